#pragma once
// How two capsules lie, in rationals.

#include "bench/sphere_capsule/oracle.h"

namespace isect::oracle {

/// The least of all candidates: where both lines come nearest (clamped to the segments), and the distances of the ends.
template <int N>
Rational distance2(const Stretch<N>& a, const Stretch<N>& b) {
  const Coordinates<N> a_end = a.at(1), b_end = b.at(1);
  Rational least = std::min({distance2(a.p, b), distance2(a_end, b), distance2(b.p, a), distance2(b_end, a)});

  const Coordinates<N> w = b.p - a.p;
  const Rational uu = dot(a.d, a.d), uv = dot(a.d, b.d), vv = dot(b.d, b.d), determinant = uu * vv - uv * uv;
  if (determinant == 0) return least;
  const Rational s = (dot(a.d, w) * vv - uv * dot(b.d, w)) / determinant, t = (s * uv - dot(b.d, w)) / vv;
  return std::min(least, distance2(a.at(s), b.at(t)));  // each clamped, so never too near
}

/// Whether the balls around the ends of a are in b.
template <int N>
bool inside(const Stretch<N>& a, const Rational& r, const Stretch<N>& b, const Rational& s) {
  const Coordinates<N> end = a.at(1);
  return at_most(distance2(a.p, b), s - r) && at_most(distance2(end, b), s - r);
}

/// Whether some point is interior to both segments, which have a common point and do not contain each other: where they
/// are parallel the middle of what they share, else the point where their lines meet.
template <int N>
bool interiors_meet(const Stretch<N>& a, const Stretch<N>& b) {
  const Coordinates<N> w = b.p - a.p;
  const Rational uu = dot(a.d, a.d), uv = dot(a.d, b.d), vv = dot(b.d, b.d), determinant = uu * vv - uv * uv;
  if (determinant == 0) {
    const Rational from = dot(w, a.d) / uu, to = from + uv / uu;  // the ends of b, as places on a
    return std::max<Rational>(0, std::min(from, to)) < std::min<Rational>(1, std::max(from, to));
  }
  const Rational s = (dot(a.d, w) * vv - uv * dot(b.d, w)) / determinant, t = (s * uv - dot(b.d, w)) / vv;
  return 0 < s && s < 1 && 0 < t && t < 1;
}

/// A capsule that is empty, NaN or infinite is disjoint from all.
template <class S, int N>
Relation relation(const Capsule<S, N>& a, const Capsule<S, N>& b) {
  if (!finite(a) || !finite(b)) return Relation::disjoint;
  const Rational r = a.radius, s = b.radius;
  if (r < 0 || s < 0) return Relation::disjoint;
  const Stretch<N> x = stretch(a), y = stretch(b);
  const Rational d2 = distance2<N>(x, y);

  if (!at_most(d2, r + s)) return Relation::disjoint;
  const bool a_inside = inside(x, r, y, s), b_inside = inside(y, s, x, r);
  if (a_inside) return b_inside ? Relation::equal : Relation::a_inside_b;
  if (b_inside) return Relation::b_inside_a;
  const bool overlap = r == 0 && s == 0 ? interiors_meet<N>(x, y) : d2 < (r + s) * (r + s);
  return overlap ? Relation::overlapping : Relation::touching;
}

}  // namespace isect::oracle
