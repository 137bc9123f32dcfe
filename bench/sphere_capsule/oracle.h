#pragma once
// How a ball and a capsule lie, in rationals.

#include <algorithm>
#include <type_traits>

#include "bench/rational.h"

namespace isect::oracle {

/// p + t d with t in [0, 1].
template <int N>
struct Stretch {
  Coordinates<N> p, d;

  Coordinates<N> at(const Rational& t) const { return p + std::clamp<Rational>(t, 0, 1) * d; }
};
template <class S, int N>
Stretch<N> stretch(const Capsule<S, N>& capsule) {
  const Coordinates<N> p = rational(capsule.p);
  return {p, rational(capsule.q) - p};
}

template <std::size_t N>
Rational distance2(const std::array<Rational, N>& x, const std::array<Rational, N>& y) {
  const auto f = x - y;
  return dot(f, f);
}
/// The squared distance to the nearest point of the stretch, which is found by a division.
template <int N>
Rational distance2(const std::type_identity_t<Coordinates<N>>& x, const Stretch<N>& stretch) {
  const Rational length2 = dot(stretch.d, stretch.d);
  return distance2(x, length2 == 0 ? stretch.p : stretch.at(dot(x - stretch.p, stretch.d) / length2));
}

/// Whether sqrt(d2) <= k.
inline bool at_most(const Rational& d2, const Rational& k) { return k >= 0 && d2 <= k * k; }

/// Compares the distances of the center from the segment and from its ends with lengths. A shape that is empty, NaN or
/// infinite is disjoint from all.
template <class S, int N>
Relation relation(const Sphere<S, N>& sphere, const Capsule<S, N>& capsule) {
  if (!finite(sphere) || !finite(capsule)) return Relation::disjoint;
  const Rational r = sphere.radius, s = capsule.radius;
  if (r < 0 || s < 0) return Relation::disjoint;
  const Coordinates<N> c = rational(sphere.center);
  const Rational d2 = distance2(c, stretch(capsule));
  const Rational farthest2 = std::max(distance2(c, rational(capsule.p)), distance2(c, rational(capsule.q)));

  if (!at_most(d2, r + s)) return Relation::disjoint;
  const bool in_capsule = at_most(d2, s - r), in_ball = at_most(farthest2, r - s);
  if (in_capsule) return in_ball ? Relation::equal : Relation::a_inside_b;
  if (in_ball) return Relation::b_inside_a;
  return d2 == (r + s) * (r + s) ? Relation::touching : Relation::overlapping;
}

}  // namespace isect::oracle
