#pragma once
// Plane against axis-aligned box.
//
// Over the box, n.x + d is least and greatest at two opposite corners: at n, whose coordinate is lo where n_i > 0 and
// hi where n_i < 0, and at p, the other way round. The box lies on one side when both have the same sign. So one
// corner often decides, and no other corner ever matters. Source: Haines, Wallace, Shaft culling for efficient
// ray-traced radiosity (1991); Akenine-Moller, Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.9; the plane of the
// note, N20.

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/plane_sphere.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace plane_aabb {

/// corners: the two corners and n.x + d at each.
template <class S, int N>
struct Corners {
  Point<S, N> least, greatest;
  S at_least, at_greatest;
};
/// side, relate: the true signs of n.x + d at the two corners.
struct Decision {
  int least, greatest;
};
template <class S, int N>
using Event = std::variant<Corners<S, N>, Decision, Fallback>;

namespace detail {

/// The corner where n.x + d is least, or greatest.
template <class S, int N>
Point<S, N> corner(const Vector<S, N>& normal, const Aabb<S, N>& box, bool greatest) {
  Point<S, N> p;
  for (int i = 0; i < N; ++i) p[i] = (normal[i] > S(0)) == greatest ? box.hi[i] : box.lo[i];
  return p;
}

/// The sign of n.x + d at that corner, by the plane's equation even where the normal is 0. Finite arguments.
template <class S, int N, class Trace>
int sign_at(const Plane<S, N>& plane, const Aabb<S, N>& box, bool greatest, Trace&& trace) {
  const Plane<double, N> wide = cast<double>(plane);
  const Point<double, N> x = corner(plane.normal, box, greatest).template cast<double>();
  return sign_of([&]<class W>() -> W { return plane_sphere::detail::height<W, N>(wide, x); }, trace);
}

template <class S, int N, class Trace>
Decision decide(const Plane<S, N>& plane, const Aabb<S, N>& box, Trace&& trace) {
  const int least = sign_at(plane, box, false, trace);
  const int greatest = least > 0 ? 1 : sign_at(plane, box, true, trace);
  trace(Decision{least, greatest});
  return {least, greatest};
}

/// Whether there is a plane and a box at all.
template <class S, int N>
bool meaningful(const Plane<S, N>& plane, const Aabb<S, N>& box) {
  return finite(plane) && finite(box) && !empty(box) && !plane.normal.isZero(0);
}

}  // namespace detail

}  // namespace plane_aabb

/// The sign of n.x + d for all points x of the box, or 0 where the box meets the plane. Exact. A zero normal, which
/// makes no plane, an empty box, NaN or an infinite coordinate: 0.
template <class S, int N, class Trace = NoTrace>
int side(const Plane<S, N>& plane, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (!plane_aabb::detail::meaningful(plane, box)) return 0;
  const plane_aabb::Decision signs = plane_aabb::detail::decide(plane, box, trace);
  return signs.least == signs.greatest ? signs.least : 0;
}

/// Returns disjoint; touching, when the box has points in the plane and on one side of it at most, be it a face, an
/// edge or a corner; or overlapping, when it has points on both sides. Exact. A zero normal, which makes no plane, an
/// empty box, NaN or an infinite coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Plane<S, N>& plane, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (!plane_aabb::detail::meaningful(plane, box)) return Relation::disjoint;
  const plane_aabb::Decision signs = plane_aabb::detail::decide(plane, box, trace);
  if (signs.least > 0 || signs.greatest < 0) return Relation::disjoint;
  return signs.least == 0 || signs.greatest == 0 ? Relation::touching : Relation::overlapping;
}

/// Whether the plane and the box have a common point. Exact; degenerate arguments as for relate.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Plane<S, N>& plane, const Aabb<S, N>& box, Trace&& trace = {}) {
  return relate(plane, box, trace) != Relation::disjoint;
}

}  // namespace isect
