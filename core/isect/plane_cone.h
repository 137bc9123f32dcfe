#pragma once
// Plane against cone.
//
// The cone is the convex hull of its apex a and of the disc of its base around b: with d = b - a they lie at the height
//
//   n.a + e   and between   n.b + e -+ r |n x d| / |d|,
//
// over the plane n.x + e = 0, times |n|. isect/parts/plane_round.h compares them with 0 by squares: no division, no
// square root. Source: Ericson, Real-Time Collision Detection (2005), 5.2.4.

#include <isect/parts/plane_round.h>

namespace isect {

namespace plane_cone {

using plane_round::Decision, plane_round::Event;

}  // namespace plane_cone

/// The sign of n.x + e for all points x of the cone, or 0 where it meets the plane. Exact. A zero normal, which makes
/// no plane, an empty cone, NaN or an infinite coordinate: 0.
template <class S, class Trace = NoTrace>
int side(const Plane<S, 3>& plane, const Cone<S>& cone, Trace&& trace = {}) {
  if (!plane_round::detail::meaningful(plane, cone)) return 0;
  const plane_cone::Decision signs = plane_round::detail::decision(plane, cone, trace);
  trace(signs);
  return signs.lowest > 0 ? 1 : signs.highest < 0 ? -1 : 0;
}

/// Returns disjoint; touching, when the cone has points in the plane and on one side of it at most; or overlapping,
/// when it has points on both sides. Exact. Radius 0 makes the cone a segment. A zero normal, which makes no plane, an
/// empty cone, NaN or an infinite coordinate: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Plane<S, 3>& plane, const Cone<S>& cone, Trace&& trace = {}) {
  if (!plane_round::detail::meaningful(plane, cone)) return Relation::disjoint;
  const plane_cone::Decision signs = plane_round::detail::decision(plane, cone, trace);
  trace(signs);
  if (signs.lowest > 0 || signs.highest < 0) return Relation::disjoint;
  return signs.lowest < 0 && signs.highest > 0 ? Relation::overlapping : Relation::touching;
}

/// Whether the plane and the cone have a common point. Exact; degenerate arguments as for relate.
template <class S, class Trace = NoTrace>
bool intersects(const Plane<S, 3>& plane, const Cone<S>& cone, Trace&& trace = {}) {
  return relate(plane, cone, trace) != Relation::disjoint;
}

}  // namespace isect
