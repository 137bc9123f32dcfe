#pragma once
// Rays and polygons in the plane that are hard to tell apart, of any numbers.

#include "bench/random_rays.h"

namespace isect::tests::ray_outline_pairs {

using bench::Numbers, bench::Random;

template <class S>
struct Case {
  Ray<S, 2> ray;
  Polygon<S, 2> polygon;
};

/// One to three rings of up to six corners, some of two corners or one; sometimes with a repeated corner, a spike, or
/// edges along the axes. The ray comes from anywhere, sometimes along an edge or towards a corner, ending there or
/// starting on it.
template <class S>
Case<S> draw(Random& random, Numbers numbers) {
  Case<S> c;
  c.ray = bench::ray<S, 2>(random, numbers);
  for (int rings = random.one_in(3) ? random.integer(2, 3) : 1; rings > 0; --rings) {
    Ring<S, 2> ring;
    for (int i = random.one_in(8) ? random.integer(1, 2) : random.integer(3, 6); i > 0; --i) {
      ring.push_back(bench::vector<S, 2>(random, numbers));
      if (ring.size() > 1 && random.one_in(4)) ring.back()[random.below(2)] = ring[ring.size() - 2][0];
      if (ring.size() > 1 && random.one_in(10)) ring.push_back(ring[ring.size() - 2]);
    }
    c.polygon.rings.push_back(ring);
  }
  const Ring<S, 2>& ring = c.polygon.rings[0];
  const Point<S, 2>&a = ring[static_cast<std::size_t>(random.below(static_cast<int>(ring.size())))], &b = ring[0];
  const auto aim = [&](const Vector<S, 2>& d) {
    if (finite(d)) c.ray.direction = d;
  };
  if (random.one_in(4)) aim(a - c.ray.origin);
  if (random.one_in(6)) c.ray.origin = a;
  if (random.one_in(4)) aim(b - a), c.ray.origin = random.one_in(2) ? a : c.ray.origin;
  if (random.one_in(4)) c.ray.range = {std::min(c.ray.range.lo, S(1)), S(1)};
  if (random.one_in(8)) c.ray.range = infinite<S>;
  return c;
}

}  // namespace isect::tests::ray_outline_pairs
