#pragma once
// Several pictures as one file that shows them in turn, in an endless loop.

#include <string>
#include <utility>
#include <vector>

#include "viz/formats/files.h"

namespace isect::viz {

/// For how many seconds each picture is shown: all alike, or each by its place in a list as long as that of pictures.
class Timing {
 public:
  Timing(double all) : all_(all) {}
  Timing(std::vector<double> each) : each_(std::move(each)) {}
  double of(std::size_t picture) const { return each_.empty() ? all_ : each_.at(picture); }

 private:
  double all_ = 0;
  std::vector<double> each_;
};

/// Throws FileError unless there is a picture and all are of one size.
void need_alike(const std::vector<Picture>&);

/// Writes pictures of one size, in their timing. A picture of more than 256 colours is reduced to 256;
/// opacity is lost. Metadata and alt text are comments. Throws FileError.
std::string gif(const std::vector<Picture>&, const Timing&, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no GIF.
Metadata gif_metadata(const std::string& bytes);

/// Writes the same animation with all colours, as a PNG; a program without animation shows its first picture. Metadata
/// as in `png`; png_metadata reads it.
std::string apng(const std::vector<Picture>&, const Timing&, const Metadata& = {}, const Imprint& = {});

/// Whether there is an ffmpeg, which writes MP4.
bool can_write_mp4();
/// Writes the same as a video that ends, 25 frames a second; opacity is lost. Metadata is its comment, alt text its
/// description. Throws FileError, with ffmpeg's message where ffmpeg fails.
std::string mp4(const std::vector<Picture>&, const Timing&, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no MP4.
Metadata mp4_metadata(const std::string& bytes);

}  // namespace isect::viz
