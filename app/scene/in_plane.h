#pragma once
// A polygon's plane: how to see it, and what lies off it.

#include <isect/shapes.h>

namespace isect::program::scene {

/// The axes that are left of a projection along the largest |n_i|, and whether the outline runs clockwise there.
struct Projection {
  int x, y;
  bool clockwise;
};
Projection projection(const Ring<double, 3>& outline);

/// The farthest that a vertex lies off the plane that the core's test takes for the outline's: through the first
/// vertex, with Newell's normal. 0 if and only if all lie in it, exactly; else within 2 ulp, or the least double. The
/// outline has an area.
double off_plane(const Ring<double, 3>& outline);

}  // namespace isect::program::scene
