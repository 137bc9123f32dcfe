#pragma once
// The markers of a scene's points and of the t-axis, as flat shapes.

#include <vector>

#include "viz/drawing.h"
#include "viz/theme.h"

namespace isect::viz {

/// Returns the colour for thin lines and texts of a role: yellow can't be seen on white.
inline Colour edge_ink(Role role, const Theme& theme) {
  return theme.ink(role == Role::highlight && theme.name != ThemeName::dark ? Role::text : role);
}

/// Draws the marker at `p`, with a halo in the background's colour.
void mark(std::vector<Shape>& out, Mark, const Vec2& p, Role, const Theme&);
/// Returns the radius that a label must keep off.
double mark_radius(Mark, const Sizes&);
/// Returns the outline of a notched arrow head with its tip at `tip`; `direction` has unit length.
Path arrow_head(const Vec2& tip, const Vec2& direction, double length);

}  // namespace isect::viz
