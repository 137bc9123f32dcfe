#pragma once
// The markers of a scene's points and of the t-axis, as flat shapes.

#include <vector>

#include "viz/drawing.h"
#include "viz/theme.h"

namespace isect::viz {

/// Draws the marker at `p`, with a halo in the background's colour.
void mark(std::vector<Shape>& out, Mark, const Vec2& p, Role, const Theme&);
/// The radius a label must keep off.
double mark_radius(Mark, const Sizes&);
/// A notched arrow head with its tip at `tip`; `direction` has unit length.
Shape arrow_head(const Vec2& tip, const Vec2& direction, const Colour&, const Sizes&);

}  // namespace isect::viz
