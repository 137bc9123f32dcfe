#pragma once
// Point against cylinder.
//
// With d = q - p and f leading from p to the point, it lies in the cylinder iff
//
//   0 <= f.d <= d.d   and   |f x d|^2 <= r^2 d.d:
//
// between the planes across the axis, and no farther than r from it. Source: Ericson, Real-Time Collision Detection
// (2005), 5.3.7.

#include <variant>

#include <isect/parts/round_solid.h>
#include <isect/trace.h>

namespace isect {

namespace point_cylinder {

using round_solid::Signs;
using Event = std::variant<Signs, Fallback>;

}  // namespace point_cylinder

/// Where the point lies with respect to the cylinder. Exact, for all finite input of any magnitude. A point of a
/// cylinder of radius 0, which is a segment, is `on`. An empty cylinder, NaN or an infinite coordinate: out.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 3>& point, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!round_solid::exists(cylinder) || !finite(point)) return Location::out;
  const Cylinder<double>& wide = in_doubles(cylinder);
  const Point<double, 3> at = point.template cast<double>();
  const point_cylinder::Signs signs =
      in_doubles_first([&](auto& listener) { return round_solid::signs(at, wide, listener); }, trace);
  trace(signs);
  return round_solid::location(signs);
}

}  // namespace isect
