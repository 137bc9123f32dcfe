#pragma once
// How a step looked, as a baseline keeps it: in few colours, so that it weighs a quarter.

#include "viz/formats/files.h"

namespace isect::viz {

/// Returns a PNG with a table of colours. Each channel of a pixel may be off by 10, or by what 256 colours need; the
/// metadata says by how much. At 12 a floor that fades could be missing without notice.
std::string baseline_png(const Picture&, Metadata);

/// What such a PNG holds. One of more colours, from before they were left out, has no slack. One that lost its metadata
/// has the usual one.
struct BaselinePicture {
  Picture picture;
  int slack = 0;  ///< by how much a channel may be off
};
/// Throws FileError on what is no PNG.
BaselinePicture read_baseline_png(const std::string& bytes);

}  // namespace isect::viz
