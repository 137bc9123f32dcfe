#pragma once
// Metadata as the formats without keys of their own carry it: GIF, MP4, PDF, SVG and TikZ.

#include <string>

#include "viz/files.h"

namespace isect::viz {

/// A JSON object in ASCII: control characters and what is no UTF-8 are escaped.
std::string metadata_text(const Metadata&);
/// What it was made from. Throws FileError on anything else, and names the format.
Metadata metadata_of_text(const std::string& text, const char* format);

}  // namespace isect::viz
