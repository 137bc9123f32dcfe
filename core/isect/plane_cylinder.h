#pragma once
// Plane against cylinder.
//
// The cylinder is the convex hull of the discs at its ends: with d = q - p they lie between the heights
//
//   n.p + e -+ r |n x d| / |d|   and   n.q + e -+ r |n x d| / |d|,
//
// over the plane n.x + e = 0, times |n|. isect/parts/plane_round.h compares them with 0 by squares: no division, no
// square root. Source: Ericson, Real-Time Collision Detection (2005), 5.2.4, of a cone.

#include <isect/parts/plane_round.h>

namespace isect {

namespace plane_cylinder {

using plane_round::Decision, plane_round::Event;

}  // namespace plane_cylinder

/// The sign of n.x + e for all points x of the cylinder, or 0 where it meets the plane. Exact. A zero normal, which
/// makes no plane, an empty cylinder, NaN or an infinite coordinate: 0.
template <class S, class Trace = NoTrace>
int side(const Plane<S, 3>& plane, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!plane_round::detail::meaningful(plane, cylinder)) return 0;
  const plane_cylinder::Decision signs = plane_round::detail::decision(plane, cylinder, trace);
  trace(signs);
  return signs.lowest > 0 ? 1 : signs.highest < 0 ? -1 : 0;
}

/// Returns disjoint; touching, when the cylinder has points in the plane and on one side of it at most; or overlapping,
/// when it has points on both sides. Exact. Radius 0 makes the cylinder a segment. A zero normal, which makes no plane,
/// an empty cylinder, NaN or an infinite coordinate: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Plane<S, 3>& plane, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!plane_round::detail::meaningful(plane, cylinder)) return Relation::disjoint;
  const plane_cylinder::Decision signs = plane_round::detail::decision(plane, cylinder, trace);
  trace(signs);
  if (signs.lowest > 0 || signs.highest < 0) return Relation::disjoint;
  return signs.lowest < 0 && signs.highest > 0 ? Relation::overlapping : Relation::touching;
}

/// Whether the plane and the cylinder have a common point. Exact; degenerate arguments as for relate.
template <class S, class Trace = NoTrace>
bool intersects(const Plane<S, 3>& plane, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  return relate(plane, cylinder, trace) != Relation::disjoint;
}

}  // namespace isect
