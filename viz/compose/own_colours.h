#pragma once
// The colours that an author chose, on the ground of a theme.

#include <vector>

#include "viz/theme.h"

namespace isect::viz {

/// Returns the theme with these colours for the own roles: as given, or darker or lighter by as much as texts in them
/// need on its background (a contrast of 4.5); in grey print those of the parts that they play.
Theme with_colours(Theme, const std::vector<OwnColour>&);

}  // namespace isect::viz
