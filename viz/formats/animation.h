#pragma once
// Several pictures as one file that shows them in turn, in an endless loop.

#include <string>
#include <vector>

#include "viz/formats/files.h"

namespace isect::viz {

/// Throws FileError unless there is a picture and all are of one size.
void need_alike(const std::vector<Picture>&);

/// Writes pictures of one size, each shown for so many seconds. A picture of more than 256 colours is reduced to 256;
/// opacity is lost. Metadata and alt text are comments. Throws FileError.
std::string gif(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no GIF.
Metadata gif_metadata(const std::string& bytes);

/// Writes the same animation with all colours, as a PNG; a program without animation shows its first picture. Metadata
/// as in `png`; png_metadata reads it.
std::string apng(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});

/// Whether there is an ffmpeg, which writes MP4.
bool can_write_mp4();
/// Writes the same as a video that ends, 25 frames a second; opacity is lost. Metadata is its comment, alt text its
/// description. Throws FileError, with ffmpeg's message where ffmpeg fails.
std::string mp4(const std::vector<Picture>&, double seconds, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no MP4.
Metadata mp4_metadata(const std::string& bytes);

}  // namespace isect::viz
