#pragma once
// The distance of a point from a segment, compared with a sum or difference of two radii: exact, without a division or
// a square root.
//
// With d = q - p the segment's point nearest to c is p where (c - p).d <= 0, q where (q - c).d <= 0, and else the foot
// of the perpendicular, whose distance squared is |(c - p) x d|^2 / |d|^2. Source: Ericson, Real-Time Collision
// Detection (2005), 5.1.2.

#include <functional>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>

namespace isect::point_segment {

/// Which of the segment's points is the nearest: an end, or one between them.
enum class Nearest { p, q, between };

namespace detail {

/// |x times y|^2.
template <PolynomialScalar W>
W cross_squared(const Components<W, 2>& x, const Components<W, 2>& y) {
  const W area = x[0] * y[1] - x[1] * y[0];
  return area * area;
}
template <PolynomialScalar W>
W cross_squared(const Components<W, 3>& x, const Components<W, 3>& y) {
  const Components<W, 3> area = cross(x, y);
  return dot(area, area);
}

/// Where the segment's point nearest to c lies; p where the ends coincide.
template <int N, class Trace>
Nearest nearest(const Point<double, N>& c, const Point<double, N>& p, const Point<double, N>& q, Trace&& trace) {
  const auto beyond = [&](const Point<double, N>& end, const Point<double, N>& other) {
    return sign_of([&]<class W>() -> W { return dot(difference<W, N>(c, end), difference<W, N>(other, end)); },
                   trace) <= 0;
  };
  if (beyond(p, q)) return Nearest::p;
  return beyond(q, p) ? Nearest::q : Nearest::between;
}

/// The sign of |c - x|^2 - radii(r, s)^2, x being the segment's nearest point: -1 nearer, 0 at that very distance, 1
/// farther. `radii` is std::plus or std::minus.
template <int N, class Radii, class Trace>
int compare(const Point<double, N>& c, const Point<double, N>& p, const Point<double, N>& q, Nearest nearest, double r,
            double s, Radii radii, Trace&& trace) {
  if (nearest == Nearest::between)
    return sign_of(
        [&]<class W>() -> W {
          const Components<W, N> d = difference<W, N>(q, p);
          const W reach = radii(W(r), W(s));
          return cross_squared(difference<W, N>(c, p), d) - reach * reach * dot(d, d);
        },
        trace);
  const Point<double, N>& end = nearest == Nearest::p ? p : q;
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> f = difference<W, N>(c, end);
        const W reach = radii(W(r), W(s));
        return dot(f, f) - reach * reach;
      },
      trace);
}

}  // namespace detail

}  // namespace isect::point_segment
