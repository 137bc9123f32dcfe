#pragma once
// A ray's t-axis as shapes: below a figure, and below the scene in the window.

#include "viz/compose/compose.h"

namespace isect::viz {

/// The height of the axis below a picture, in the size of its texts.
inline constexpr double axis_height = 3.1;
/// The distance from its top down to its line.
inline constexpr double axis_line = 1.75;

/// Draws the axis from `left` to `right` at height y, in the theme's sizes: marks on the line with their names above
/// it, the ends of the ray's range below. A text is no wider than `most`.
Composed compose_axis(const Axis&, double left, double right, double y, double most, const Theme&);

}  // namespace isect::viz
