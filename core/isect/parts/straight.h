#pragma once
// A ray, a line or a segment, as texts ask for it: where t = 0 is, the direction, and the range of t. A segment's
// direction leads from one end, as given, to the other, and is rounded nowhere. For the core's own use.

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>

namespace isect {

/// `heading` is the direction, or the other end.
template <int N, bool between_ends>
struct Straight {
  Point<double, N> origin;
  Vector<double, N> heading;
  Interval<double> range;

  template <PolynomialScalar W>
  Components<W, N> along() const {
    if constexpr (between_ends)
      return difference<W, N>(heading, origin);
    else
      return exactly<W, N>(heading);
  }
  /// Whether it has no direction.
  bool is_point() const {
    if constexpr (between_ends)
      return heading == origin;
    else
      return is_zero(heading);
  }
};

template <class S, int N>
Straight<N, false> straight(const Ray<S, N>& ray) {
  return {ray.origin.template cast<double>(), ray.direction.template cast<double>(), cast<double>(ray.range)};
}
template <class S, int N>
Straight<N, true> straight(const Segment<S, N>& segment) {
  return {segment.p.template cast<double>(), segment.q.template cast<double>(), {0, 1}};
}

/// The point at t, seen from c.
template <PolynomialScalar W, int N, bool ends>
Components<W, N> seen_from(const Point<double, N>& c, const Straight<N, ends>& line, double t) {
  Components<W, N> x = difference<W, N>(line.origin, c);
  if (t == 0) return x;
  const Components<W, N> d = line.template along<W>();
  for (int i = 0; i < N; ++i) x[i] = x[i] + W(t) * d[i];
  return x;
}

}  // namespace isect
