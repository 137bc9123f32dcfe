#pragma once
// Point beside a plane, or in the plane beside a line: the sign of n.x + d. Source: the note, N20.

#include <span>
#include <variant>

#include <isect/plane_sphere.h>

namespace isect {

namespace point_plane {

/// The sign of n.x + d.
struct Height {
  int sign;
};
using Event = std::variant<Height, Fallback>;

}  // namespace point_plane

/// The sign of n.x + d: 1 on the side that the normal points to, 0 in the plane, -1 on the other side. Exact, for all
/// finite input of any magnitude. A zero normal, which makes no plane, NaN or an infinite coordinate: 0.
template <class S, int N, class Trace = NoTrace>
int side(const Plane<S, N>& plane, const Point<S, N>& point, Trace&& trace = {}) {
  if (!finite(plane) || !finite(point) || plane.normal.isZero(0)) return 0;
  const Plane<double, N>& wide = in_doubles(plane);
  const Point<double, N> at = point.template cast<double>();
  const int sign = sign_of([&]<class W>() -> W { return plane_sphere::detail::height<W, N>(wide, at); }, trace);
  trace(point_plane::Height{sign});
  return sign;
}

/// How many points lie behind a plane, in it, and before it, where its normal points. If all of a shape's corners lie
/// behind it, or all before it, the plane misses what they span.
struct Sides {
  int behind = 0, on = 0, before = 0;

  friend bool operator==(const Sides&, const Sides&) = default;
};
/// Each point counts as `side` says. Exact.
template <class S, int N>
Sides sides(const Plane<S, N>& plane, std::span<const Point<S, N>> points) {
  Sides count;
  for (const Point<S, N>& p : points) {
    const int sign = side(plane, p);
    ++(sign < 0 ? count.behind : sign == 0 ? count.on : count.before);
  }
  return count;
}

}  // namespace isect
