#pragma once
// Rays and oriented boxes that are hard to tell apart, of any numbers.

#include <algorithm>

#include "bench/random_obb.h"
#include "bench/random_rays.h"

namespace isect::tests::ray_obb_pairs {

using bench::Numbers, bench::Random;

template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Obb<S, N> box;
};

/// Any box, and a ray from anywhere or aimed: at a corner, an edge, a face or the center, ending there at times.
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  Case<S, N> c = {bench::ray<S, N>(random, numbers), bench::obb<S, N>(random, numbers)};
  if (random.one_in(40)) c.box.half[0] = -c.box.half[0];
  if (random.one_in(3)) return c;
  Vector<S, N> across;
  for (int i = 0; i < N; ++i) across[i] = c.box.half[i] * static_cast<S>(random.integer(-1, 1));
  const Point<S, N> target = c.box.center + c.box.axes * across;
  const Vector<S, N> d = target - c.ray.origin;
  if (!finite(d)) return c;
  c.ray.direction = d;
  if (random.one_in(4)) c.ray.direction = c.box.axes.col(random.below(N)), c.ray.origin = target;
  if (random.one_in(4)) c.ray.range.hi = S(1), c.ray.range.lo = std::min(c.ray.range.lo, S(1));
  return c;
}

}  // namespace isect::tests::ray_obb_pairs
