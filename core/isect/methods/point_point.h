#pragma once
// Whether points are near, as it is written in practice: for lessons and comparison. `nearly_equal` in
// isect/point_point.h is right for all input.

#include <cmath>
#include <variant>

#include <isect/point_point.h>

namespace isect::point_point {

/// |p - q| or its square against the tolerance or its square, as rounded.
template <class S>
struct Compared {
  S distance, tolerance;
};
template <class S>
using MethodEvent = std::variant<Compared<S>>;

/// Whether the points are near, by squares. Naive: rounding may decide, and squares overflow or vanish beyond 1e+-154
/// in double, 1e+-19 in float: then all points are near, or none.
template <class S, int N, class Trace = NoTrace>
bool near_by_squares(const Point<S, N>& p, const Point<S, N>& q, S tolerance, Trace&& trace = {}) {
  const Vector<S, N> f = p - q;
  const S distance2 = f.dot(f), tolerance2 = tolerance * tolerance;
  trace(Compared<S>{distance2, tolerance2});
  return distance2 <= tolerance2;
}

/// Whether the distance, with its square root, is within the tolerance.
template <class S, int N, class Trace = NoTrace>
bool near_by_distance(const Point<S, N>& p, const Point<S, N>& q, S tolerance, Trace&& trace = {}) {
  const Vector<S, N> f = p - q;
  using std::sqrt;
  const S distance = sqrt(f.dot(f));
  trace(Compared<S>{distance, tolerance});
  return distance <= tolerance;
}

/// Compares coordinate by coordinate: that is a cube, where a ball is meant.
template <class S, int N, class Trace = NoTrace>
bool near_by_coordinates(const Point<S, N>& p, const Point<S, N>& q, S tolerance, Trace&& trace = {}) {
  for (int i = 0; i < N; ++i) {
    const S apart = p[i] - q[i], size = apart < S(0) ? -apart : apart;
    trace(Compared<S>{size, tolerance});
    if (!(size <= tolerance)) return false;
  }
  return true;
}

}  // namespace isect::point_point
