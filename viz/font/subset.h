#pragma once
// The letters of figures as a font of their own, for pages that embed it.

#include <optional>
#include <string>

namespace isect::viz {

enum class Face { upright, italic, bold };

struct FontSubset {
  std::string bytes;   ///< an OpenType font with these letters, called "IsectLetter" inside
  std::string notice;  ///< copyright, trademark and licence as the font states them
};
/// Returns a font of those `letters` (UTF-8) that the font of figures has. None where that font is not STIX, whose
/// licence allows this under another name, or is not there, or where `letters` are not UTF-8.
std::optional<FontSubset> font_subset(Face, const std::string& letters);

}  // namespace isect::viz
