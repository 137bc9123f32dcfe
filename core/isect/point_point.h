#pragma once
// Point against point.
//
// Points are equal when their coordinates are: 0.1 + 0.2 is not 0.3, and that is no error of the test. Whoever wants
// points that are near says how near. Then |p - q| <= tolerance is decided by the squares. Source: the note, N11.

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/squares.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace point_point {

/// equal: one coordinate of each; the first that differs ends the test.
template <class S>
struct Coordinate {
  int axis;
  S p, q;
  bool equal;
};
/// nearly_equal: the sign of |p - q|^2 - tolerance^2.
struct Distance {
  int sign;
};
template <class S>
using Event = std::variant<Coordinate<S>, Distance, Fallback>;

namespace detail {

/// The sign of |p - q|^2 - tolerance^2, computed as x - y, where that does not settle it.
template <class S, int N, class Trace>
[[gnu::noinline]] int sign_of_gap(const Point<S, N>& p, const Point<S, N>& q, S tolerance, double x, double y,
                                  Trace&& trace) {
  const Point<double, N> wide_p = p.template cast<double>(), wide_q = q.template cast<double>();
  const auto text = [&]<class W>() -> W {
    const Components<W, N> f = difference<W, N>(wide_p, wide_q);
    return dot(f, f) - W(tolerance) * W(tolerance);
  };
  return settled_squares(text, x, y, trace);
}

}  // namespace detail

}  // namespace point_point

/// Whether the points are the same. Exact: coordinates are compared, -0 equals 0. NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool equal(const Point<S, N>& p, const Point<S, N>& q, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  if (!finite(p)) return false;
  for (int axis = 0; axis < N; ++axis) {
    const bool same = p[axis] == q[axis];
    trace(point_point::Coordinate<S>{axis, p[axis], q[axis], same});
    if (!same) return false;
  }
  return true;
}

/// Whether the points are at most `tolerance` apart, in Euclidean distance. Exact. A tolerance of 0 asks whether they
/// are equal; no points meet a negative one or NaN, all meet an infinite one. NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool nearly_equal(const Point<S, N>& p, const Point<S, N>& q, S tolerance, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  if (!finite(p) || !finite(q) || !(tolerance >= 0)) return false;
  if (std::isinf(tolerance)) return true;

  const double distance2 = (p.template cast<double>() - q.template cast<double>()).squaredNorm();
  const double tolerance2 = double(tolerance) * double(tolerance);
  const int sign = order_of_squares(distance2, tolerance2, [&] {
    return point_point::detail::sign_of_gap<S, N>(p, q, tolerance, distance2, tolerance2, trace);
  });
  trace(point_point::Distance{sign});
  return sign <= 0;
}

}  // namespace isect
