#pragma once
// Rays and capsules that are hard to tell apart, of any numbers.

#include <cmath>
#include <limits>

#include "bench/random_rays.h"
#include "bench/simple_shapes.h"
#include "bench/sphere_capsule/oracle.h"

namespace isect::tests::ray_capsule_pairs {

using bench::Numbers, bench::Random;

template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Capsule<S, N> capsule;
};

/// Any capsule and a ray from anywhere. The ray is sometimes along a coordinate axis or the capsule's, from the middle
/// of that axis, or without direction; the capsule's axis is sometimes along a coordinate axis. `touching` sets the
/// radius so that the line touches the capsule, up to rounding.
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers, bool touching) {
  Case<S, N> c = {bench::ray<S, N>(random, numbers), bench::capsule<S, N>(random, numbers)};
  const auto along_an_axis = [&](Vector<S, N>& x) {
    for (int k = 0, kept = random.below(N); k < N; ++k)
      if (k != kept) x[k] = 0;
  };
  if (random.one_in(3)) {
    Vector<S, N> axis = c.capsule.q - c.capsule.p;
    along_an_axis(axis);
    c.capsule.q = c.capsule.p + axis;
  }
  if (random.one_in(4)) c.ray.direction = c.capsule.q - c.capsule.p;
  if (random.one_in(8)) c.ray.origin = c.capsule.p / 2 + c.capsule.q / 2;
  if (random.one_in(2)) {
    const auto end = [&] { return static_cast<S>(random.integer(-8, 8)) / 4; };
    const S first = end(), last = end();
    c.ray.range = {random.one_in(3) ? infinite<S>.lo : std::min(first, last),
                   random.one_in(2) ? infinite<S>.hi : std::max(first, last)};
  }
  if (!finite(c.ray) || !finite(c.capsule) || !touching) return c;
  using namespace oracle;
  const Coordinates<N> d = rational(c.ray.direction);
  const Stretch<N> axis = stretch(c.capsule);
  if (dot(d, d) == 0) return c;
  // The distance of an end, or of the lines where they pass each other
  const Coordinates<N> f = rational(random.one_in(2) ? c.capsule.p : c.capsule.q) - rational(c.ray.origin);
  Rational d2 = dot(f, f) - dot(f, d) * dot(f, d) / dot(d, d);
  if constexpr (N == 3) {
    const Coordinates<3> n = cross(d, axis.d);
    if (random.one_in(2) && dot(n, n) != 0) d2 = dot(f, n) * dot(f, n) / dot(n, n);
  }
  c.capsule.radius = bench::moved(static_cast<S>(std::sqrt(static_cast<double>(d2))), random.integer(-2, 2));
  return c;
}

}  // namespace isect::tests::ray_capsule_pairs
