#pragma once
// How a ball and a box lie, in rationals.

#include "bench/rational.h"

namespace isect::oracle {

/// Decides by the least and the largest distance to the box, over all its corners and faces. A shape that is empty, NaN
/// or infinite is disjoint from all.
template <class S, int N>
Relation relation(const Sphere<S, N>& sphere, const Aabb<S, N>& box) {
  if (!finite(sphere) || !finite(box)) return Relation::disjoint;
  const Coordinates<N> c = rational(sphere.center), lo = rational(box.lo), hi = rational(box.hi);
  const Rational r = sphere.radius;
  if (r < 0) return Relation::disjoint;
  Rational outside2 = 0, corner2 = 0;
  bool ball_inside = true;
  for (int i = 0; i < N; ++i) {
    if (lo[i] > hi[i]) return Relation::disjoint;
    const Rational outside = c[i] < lo[i]   ? Rational(lo[i] - c[i])
                             : c[i] > hi[i] ? Rational(c[i] - hi[i])
                                            : Rational(0);
    outside2 += outside * outside;
    ball_inside &= lo[i] <= c[i] - r && c[i] + r <= hi[i];
  }
  for (int corner = 0; corner < 1 << N; ++corner) {
    Rational d2 = 0;
    for (int i = 0; i < N; ++i) {
      const Rational d = c[i] - (corner >> i & 1 ? hi : lo)[i];
      d2 += d * d;
    }
    if (d2 > corner2) corner2 = d2;
  }
  if (outside2 > r * r) return Relation::disjoint;
  const bool box_inside = corner2 <= r * r;
  if (ball_inside && box_inside) return Relation::equal;
  if (ball_inside) return Relation::a_inside_b;
  if (box_inside) return Relation::b_inside_a;
  return outside2 == r * r ? Relation::touching : Relation::overlapping;
}

}  // namespace isect::oracle
