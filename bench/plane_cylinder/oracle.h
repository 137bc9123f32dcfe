#pragma once
// How a plane and a cylinder or a cone lie, in rationals: which of its discs the plane misses, by the point of the
// plane, within the disc's own plane, that is nearest to its center; and on which sides the centers lie.

#include <algorithm>
#include <type_traits>

#include "bench/round_oracle.h"

namespace isect::oracle {

/// A shape that is empty, NaN or infinite, and a plane without a normal, is disjoint from all.
template <class S, Round Solid>
Relation relation(const Plane<S, 3>& plane, const Solid& shape) {
  const RoundSolid solid = round_solid(shape);
  if (!solid.exists || !finite(plane) || plane.normal.isZero(0)) return Relation::disjoint;
  const Coordinates<3> n = rational(plane.normal);
  const Coordinates<3> tilted = n - Rational(dot(n, solid.d) / dot(solid.d, solid.d)) * solid.d;
  bool above = false, below = false, meets = false;
  const auto ask = [&](const Coordinates<3>& center, const Rational& radius) {
    const Rational height = dot(n, center) + Rational(plane.d), tilt = dot(tilted, tilted);
    above |= height > 0, below |= height < 0, meets |= height == 0;
    if (tilt == 0 || radius == 0) return;
    const Coordinates<3> to_plane = Rational(-height / tilt) * tilted;
    const Rational away = dot(to_plane, to_plane), reach = radius * radius;
    if (away <= reach) meets = true;
    if (away < reach) above = below = true;
  };
  ask(solid.start, solid.at_start);
  ask(solid.start + solid.d, solid.at_end);
  if (above && below) return Relation::overlapping;
  return meets ? Relation::touching : Relation::disjoint;
}

}  // namespace isect::oracle
