#pragma once
// Plane against axis-aligned box by the heights of two corners, as it is written in practice: for comparison. `side` in
// isect/plane_aabb.h is right for all input.

#include <isect/plane_aabb.h>

namespace isect::plane_aabb {

/// The side of the plane that the box lies on, or 0. Naive: rounding may decide.
template <class S, int N, class Trace = NoTrace>
int corners(const Plane<S, N>& plane, const Aabb<S, N>& box, Trace&& trace = {}) {
  const Point<S, N> least = detail::corner(plane.normal, box, false),
                    greatest = detail::corner(plane.normal, box, true);
  const S at_least = plane.normal.dot(least) + plane.d;
  const S at_greatest = plane.normal.dot(greatest) + plane.d;
  trace(Corners<S, N>{least, greatest, at_least, at_greatest});

  if (at_least > S(0)) return 1;
  return at_greatest < S(0) ? -1 : 0;
}

}  // namespace isect::plane_aabb
