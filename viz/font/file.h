#pragma once
// Where a font lies.

#include <string>

namespace isect::viz {

/// Returns the file that fontconfig finds for a pattern such as "DejaVu Sans:bold"; empty if there is none.
std::string font_file(const std::string& pattern);

}  // namespace isect::viz
