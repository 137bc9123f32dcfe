#pragma once
// Where a font lies.

#include <string>

namespace isect::viz {

/// Returns the file that fontconfig finds for a pattern such as "DejaVu Sans:bold"; empty if there is none.
std::string font_file(const std::string& pattern);

/// Whether some font has the letters of a language, given as fontconfig calls it: "zh-cn".
bool has_font_for(const std::string& language);

}  // namespace isect::viz
