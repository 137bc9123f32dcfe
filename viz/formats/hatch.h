#pragma once
// Hatches as lines, for the formats that draw lines.

#include <array>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Returns the lines of a fill's hatch, as far as the box of its outlines reaches: x + y = k gap sqrt 2 for whole k.
/// They are fixed to the drawing's origin, so that the hatches of neighbours continue each other.
std::vector<std::array<Vec2, 2>> hatch_lines(const Fill&);

}  // namespace isect::viz
