#pragma once
// Cone against a convex solid given by half-spaces (isect/half_spaces.h): a box, an oriented box, a k-DOP, a frustum, a
// hull.
//
// Seen from its apex the cone is a disc, its base, and the part of the solid between the planes of apex and base casts
// a convex shadow onto the base's plane: they meet iff the disc meets the shadow, or the solid holds the apex.
// isect/parts/round_half_spaces.h finds the shadow's edges by elimination, compares its distance from the axis with the
// radius by duality, and says when interiors meet.

#include <isect/parts/round_half_spaces.h>

namespace isect {

namespace cone_half_spaces {

using round_half_spaces::Contained, round_half_spaces::Shadow, round_half_spaces::Event;

}  // namespace cone_half_spaces

/// Whether they have a common point. Exact. An empty cone, a solid without a point, NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Cone<S>& cone, const HalfSpaces& solid, Trace&& trace = {}) {
  return round_half_spaces::detail::meet(in_doubles(cone), solid, trace);
}

/// How the cone (A) and the solid lie. Exact, for a solid without a volume, too; a cone of radius 0 is a segment. What
/// is empty, NaN or infinite is disjoint from all.
template <class S, class Trace = NoTrace>
Relation relate(const Cone<S>& cone, const HalfSpaces& solid, Trace&& trace = {}) {
  return round_half_spaces::detail::relation(in_doubles(cone), solid, trace);
}

}  // namespace isect
