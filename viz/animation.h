#pragma once
// Several pictures as one file that shows them in turn, without end.

#include <string>
#include <vector>

#include "viz/files.h"

namespace isect::viz {

/// Throws FileError unless there is a picture and all are of one size.
void need_alike(const std::vector<Picture>&);

/// Pictures of one size, each shown for so many seconds. A picture of more than 256 colours keeps 256 that stand for
/// them all; opacity is lost. Metadata and alt text are comments. Throws FileError.
std::string gif(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});
/// Throws FileError on anything that is no GIF; empty if it carries none of ours.
Metadata gif_metadata(const std::string& bytes);

/// The same with all colours, as a PNG that a program without animation shows the first picture of. Metadata as in
/// `png`, which png_metadata reads.
std::string apng(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});

/// Whether there is an ffmpeg, which writes MP4.
bool can_write_mp4();
/// The same as a video, 25 frames a second, that ends; opacity is lost. Metadata is its comment, alt text its
/// description. Throws FileError, with what ffmpeg said where that fails.
std::string mp4(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});
/// Throws FileError on anything that is no MP4; empty if it carries none of ours.
Metadata mp4_metadata(const std::string& bytes);

}  // namespace isect::viz
