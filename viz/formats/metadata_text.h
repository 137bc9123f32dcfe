#pragma once
// Metadata as text, for formats without keys of their own: GIF, MP4, PDF, SVG and TikZ.

#include <string>

#include "viz/formats/files.h"

namespace isect::viz {

/// Returns a JSON object in ASCII: control characters and invalid UTF-8 are escaped.
std::string metadata_text(const Metadata&);
/// Returns the metadata of such a text. Throws FileError on anything else, and names the format.
Metadata metadata_of_text(const std::string& text, const char* format);

}  // namespace isect::viz
