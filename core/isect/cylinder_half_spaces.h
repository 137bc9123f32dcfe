#pragma once
// Cylinder against a convex solid given by half-spaces (isect/half_spaces.h): a box, an oriented box, a k-DOP, a
// frustum, a hull.
//
// Seen along its axis the cylinder is a disc, and the part of the solid between the planes of its ends a convex
// polygon, its shadow: they meet iff the disc meets the shadow. isect/parts/round_half_spaces.h finds the shadow's
// edges by elimination, compares its distance from the axis with the radius by duality, and says when interiors meet.

#include <isect/parts/round_half_spaces.h>

namespace isect {

namespace cylinder_half_spaces {

using round_half_spaces::Contained, round_half_spaces::Shadow, round_half_spaces::Event;

}  // namespace cylinder_half_spaces

/// Whether they have a common point. Exact. An empty cylinder, a solid without a point, NaN or an infinite coordinate:
/// no.
template <class S, class Trace = NoTrace>
bool intersects(const Cylinder<S>& cylinder, const HalfSpaces& solid, Trace&& trace = {}) {
  return round_half_spaces::detail::meet(in_doubles(cylinder), solid, trace);
}

/// How the cylinder (A) and the solid lie. Exact, for a solid without a volume, too; a cylinder of radius 0 is a
/// segment. What is empty, NaN or infinite is disjoint from all.
template <class S, class Trace = NoTrace>
Relation relate(const Cylinder<S>& cylinder, const HalfSpaces& solid, Trace&& trace = {}) {
  return round_half_spaces::detail::relation(in_doubles(cylinder), solid, trace);
}

}  // namespace isect
