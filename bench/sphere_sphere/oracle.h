#pragma once
// How two balls lie, in rationals.

#include "bench/rational.h"

namespace isect::oracle {

/// Compares distances with lengths: d <= k. A ball that is empty, NaN or infinite is disjoint from all.
template <class S, int N>
Relation relation(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  if (!finite(a) || !finite(b)) return Relation::disjoint;
  const Rational r = a.radius, s = b.radius;
  if (r < 0 || s < 0) return Relation::disjoint;
  const auto f = rational(a.center) - rational(b.center);
  const Rational d2 = dot(f, f);
  const auto at_most = [&](const Rational& k) { return k >= 0 && d2 <= k * k; };
  if (!at_most(r + s)) return Relation::disjoint;
  if (d2 == 0 && r == s) return Relation::equal;
  if (at_most(s - r)) return Relation::a_inside_b;
  if (at_most(r - s)) return Relation::b_inside_a;
  return d2 == (r + s) * (r + s) ? Relation::touching : Relation::overlapping;
}

}  // namespace isect::oracle
