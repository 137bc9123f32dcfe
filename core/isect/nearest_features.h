#pragma once
// Which features of two segments in space are nearest, and how their distance compares with a bound.
//
// A segment has three features: its ends p and q, and what lies between them, its interior. The lines come nearest to
// each other in both interiors, see isect/capsule_capsule.h, and then nowhere else are the segments as near; or an end
// of one is nearest. So at most four pairs are compared: each end, and the other segment's feature nearest to it. The
// square of a distance is a fraction,
//
//   |f|^2 / 1 of two ends,   |f x d|^2 / |d|^2 of an end and an interior,   (w.n)^2 / n.n of two interiors,
//
// with f from one point to the other, d the direction of a segment, n = u x v the normal of both and w from start to
// start. Fractions are compared multiplied out: no division, no square root.
//
// The pairs of nearest points form a convex set. It has more than one pair only if the segments are parallel: then it
// is an interval of pairs, told by its ends.
//
// Source: Ericson, Real-Time Collision Detection (2005), 5.1.9 and, for capsules, 4.5.1.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <isect/capsule_capsule.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/predicate.h>
#include <isect/parts/point_segment.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace nearest_features {

using point_segment::Nearest;

/// A pair of nearest points, by the features that contain them; between: the interior.
struct Pair {
  Nearest on_a, on_b;
  friend bool operator==(const Pair&, const Pair&) = default;
};

namespace detail {

inline const Point<double, 3>& end_of(const Segment<double, 3>& x, Nearest end) {
  return end == Nearest::p ? x.p : x.q;
}

/// The squared distance of two features that contain a pair of nearest points, as a fraction: numerator, denominator.
template <PolynomialScalar W>
Components<W, 2> squared(const Segment<double, 3>& a, const Segment<double, 3>& b, const Pair& pair) {
  const Components<W, 3> u = difference<W, 3>(a.q, a.p), v = difference<W, 3>(b.q, b.p);
  const bool inside_a = pair.on_a == Nearest::between, inside_b = pair.on_b == Nearest::between;
  if (inside_a && inside_b) {
    const Components<W, 3> n = cross(u, v);
    const W height = dot(difference<W, 3>(b.p, a.p), n);
    return {height * height, dot(n, n)};
  }
  const auto from_line = [](const Components<W, 3>& f, const Components<W, 3>& d) -> Components<W, 2> {
    const Components<W, 3> area = cross(f, d);
    return {dot(area, area), dot(d, d)};
  };
  if (inside_a) return from_line(difference<W, 3>(end_of(b, pair.on_b), a.p), u);
  if (inside_b) return from_line(difference<W, 3>(end_of(a, pair.on_a), b.p), v);
  const Components<W, 3> f = difference<W, 3>(end_of(a, pair.on_a), end_of(b, pair.on_b));
  return {dot(f, f), W(1.0)};
}

/// Each end, and the other segment's feature nearest to it. A segment that is a point has one end.
inline std::vector<Pair> pairs_of_ends(const Segment<double, 3>& a, const Segment<double, 3>& b) {
  const auto nearest = [](const Point<double, 3>& end, const Segment<double, 3>& x) {
    return point_segment::detail::nearest<3>(end, x.p, x.q, NoTrace());
  };
  std::vector<Pair> all = {{Nearest::p, nearest(a.p, b)}, {nearest(b.p, a), Nearest::p}};
  if (a.p != a.q) all.push_back({Nearest::q, nearest(a.q, b)});
  if (b.p != b.q) all.push_back({nearest(b.q, a), Nearest::q});
  return all;
}

}  // namespace detail

/// The pairs of features at which two segments are nearest. Exact. One pair; or two if the segments are parallel and a
/// whole interval of pairs of points has the least distance, these being its ends. A segment that is a point has the
/// end p alone. NaN or an infinite coordinate: none.
inline std::vector<Pair> nearest_pairs(const Segment<double, 3>& a, const Segment<double, 3>& b) {
  if (!finite(a) || !finite(b)) return {};
  const Capsule<double, 3> thin_a = {a.p, a.q, 0}, thin_b = {b.p, b.q, 0};
  if (capsule_capsule::detail::between_ends(thin_a, thin_b, NoTrace()).holds)
    return {{Nearest::between, Nearest::between}};

  std::vector<Pair> least;
  for (const Pair& pair : detail::pairs_of_ends(a, b)) {
    if (std::find(least.begin(), least.end(), pair) != least.end()) continue;
    const int sign = least.empty() ? -1 : sign_of([&]<class W>() -> W {
      const Components<W, 2> x = detail::squared<W>(a, b, pair), y = detail::squared<W>(a, b, least.front());
      return x[0] * y[1] - y[0] * x[1];
    });
    if (sign < 0) least.clear();
    if (sign <= 0) least.push_back(pair);
  }
  return least;
}

/// The square of the distance of two segments, within 0.5 ulp: the nearest double, or infinite beyond the largest; 0
/// only where they meet, or where it is at most half the least double. NaN or an infinite coordinate: NaN.
inline double rounded_distance2(const Segment<double, 3>& a, const Segment<double, 3>& b) {
  if (!finite(a) || !finite(b)) return std::numeric_limits<double>::quiet_NaN();
  const Components<Exact, 2> squared = detail::squared<Exact>(a, b, nearest_pairs(a, b).front());
  return squared[0].sign() == 0 ? 0 : quotient(squared[0], squared[1]);
}

/// The sign of the distance of the capsules' segments less r + s + clearance: -1 where the capsules are nearer to each
/// other than the clearance, 0 where they are exactly so far apart, 1 where they are farther. Exact. A clearance below
/// 0 asks whether they reach into each other as far as that; if r + s + clearance is below 0, they do not: 1. An empty
/// capsule, NaN or infinite numbers: 1.
inline int order(const Capsule<double, 3>& a, const Capsule<double, 3>& b, double clearance) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b) || !std::isfinite(clearance)) return 1;
  const auto bound = [&]<class W>() -> W { return W(a.radius) + W(b.radius) + W(clearance); };
  if (sign_of(bound) < 0) return 1;
  const Segment<double, 3> of_a = {a.p, a.q}, of_b = {b.p, b.q};
  const Pair pair = nearest_pairs(of_a, of_b).front();
  return sign_of([&]<class W>() -> W {
    const Components<W, 2> squared = detail::squared<W>(of_a, of_b, pair);
    const W reach = bound.template operator()<W>();
    return squared[0] - reach * reach * squared[1];
  });
}

}  // namespace nearest_features

}  // namespace isect
