#pragma once
// The window's colours in each theme, and Dear ImGui dressed in them.

#include <imgui.h>

#include "viz/theme.h"

namespace isect::viz {

ImU32 packed(const Colour&, double alpha = 1);

struct Palette {
  Theme theme;
  Colour window, card;    ///< panels, and the cards, scene and bar tracks set into them
  Colour frame, hovered;  ///< buttons and fields
  Colour text, muted, rule, first, second, hit, miss, highlight;
  Colour fresh, fresh_text;       ///< the rim and the word of new values; a light highlight is no colour for text
  Colour on_first, on_highlight;  ///< text on a filled button or row
};
Palette palette(ThemeName);

/// Sets Dear ImGui's colours and sizes.
void dress(const Palette&);

}  // namespace isect::viz
