#pragma once
// Point against capsule: its distance from the segment p q compared with r, as isect/parts/point_segment.h does without
// a division or a square root.

#include <functional>
#include <variant>

#include <isect/parts/point_segment.h>
#include <isect/trace.h>

namespace isect {

namespace point_capsule {

/// Which of the axis' points is nearest, and the sign of that distance less r.
struct Distance {
  point_segment::Nearest nearest;
  int sign;
};
using Event = std::variant<Distance, Fallback>;

}  // namespace point_capsule

/// Where the point lies with respect to the capsule. Exact, for all finite input of any magnitude. A point of the axis
/// of a capsule of radius 0 is `on`. An empty capsule, NaN or an infinite coordinate: out.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& point, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule) || !finite(point)) return Location::out;
  const Capsule<double, N>& wide = in_doubles(capsule);
  const Point<double, N> at = point.template cast<double>();
  const point_capsule::Distance distance = in_doubles_first(
      [&](auto& listener) -> point_capsule::Distance {
        using namespace point_segment::detail;
        const point_segment::Nearest place = nearest<N>(at, wide.p, wide.q, listener);
        return {place, compare<N>(at, wide.p, wide.q, place, wide.radius, 0, std::plus(), listener)};
      },
      trace);
  trace(distance);
  if (distance.sign > 0) return Location::out;
  return distance.sign == 0 ? Location::on : Location::in;
}

}  // namespace isect
