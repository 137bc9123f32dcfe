#pragma once
// Point against axis-aligned box: the point's coordinate on every axis against the box's interval there.
//
// Only inputs are compared: exact for free. Source: the note, N06.

#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace point_aabb {

/// One axis: where x lies with respect to the interval. The first `out` ends the test.
template <class S>
struct Axis {
  int axis;
  S x;
  Interval<S> interval;
  Location location;
};
template <class S>
using Event = std::variant<Axis<S>>;

namespace detail {

template <class S>
Location locate(const S& x, const Interval<S>& interval) {
  if (!interval.contains(x)) return Location::out;
  return interval.lo < x && x < interval.hi ? Location::in : Location::on;
}

}  // namespace detail

}  // namespace point_aabb

/// Where the point lies. Exact. A flat box has no interior: its points are `on`. An empty box, NaN or an infinite
/// coordinate: out.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& point, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (empty(box) || !finite(box)) return Location::out;

  Location location = Location::in;
  for (int axis = 0; axis < N; ++axis) {
    const Location along = point_aabb::detail::locate(point[axis], box.along(axis));
    if constexpr (heard<Trace>) trace(point_aabb::Axis<S>{axis, point[axis], box.along(axis), along});
    if (along == Location::out) return Location::out;  // NaN too
    if (along == Location::on) location = Location::on;
  }
  return location;
}

}  // namespace isect
