#pragma once
// Point against cone.
//
// With d leading from the apex to the center of the base and f to the point, it lies in the cone iff
//
//   0 <= f.d <= d.d   and   d.d |f x d|^2 <= r^2 (f.d)^2:
//
// between the apex and the base, and no farther from the axis than its height over the apex allows. Source: Eberly,
// Intersection of a Line and a Cone (2000), geometrictools.com.

#include <variant>

#include <isect/parts/round_solid.h>
#include <isect/trace.h>

namespace isect {

namespace point_cone {

using round_solid::Signs;
using Event = std::variant<Signs, Fallback>;

}  // namespace point_cone

/// Where the point lies with respect to the cone. Exact, for all finite input of any magnitude. A point of a cone
/// of radius 0, which is a segment, is `on`. An empty cone, NaN or an infinite coordinate: out.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 3>& point, const Cone<S>& cone, Trace&& trace = {}) {
  if (!round_solid::exists(cone) || !finite(point)) return Location::out;
  const Cone<double>& wide = in_doubles(cone);
  const Point<double, 3> at = point.template cast<double>();
  const point_cone::Signs signs =
      in_doubles_first([&](auto& listener) { return round_solid::signs(at, wide, listener); }, trace);
  trace(signs);
  return round_solid::location(signs);
}

}  // namespace isect
