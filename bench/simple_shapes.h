#pragma once
// Random intervals, boxes, balls, capsules, cylinders and cones from any family of numbers: flat and empty ones now and
// then, or made to meet.

#include <algorithm>

#include <isect/shapes.h>
#include "bench/random_shapes.h"

namespace isect::bench {

/// Sometimes inverted, and so empty.
template <class S>
Interval<S> interval(Random& random, Numbers numbers) {
  const S x = number<S>(random, numbers), y = number<S>(random, numbers);
  return random.one_in(30) ? Interval<S>{x, y} : Interval<S>{std::min(x, y), std::max(x, y)};
}

template <class S, int N>
Aabb<S, N> box(Random& random, Numbers numbers) {
  Aabb<S, N> b;
  for (int i = 0; i < N; ++i) {
    const Interval<S> side = interval<S>(random, numbers);
    b.lo[i] = side.lo, b.hi[i] = side.hi;
  }
  return b;
}

/// Sometimes of radius 0, or empty.
template <class S, int N>
Sphere<S, N> ball(Random& random, Numbers numbers) {
  const Point<S, N> center = vector<S, N>(random, numbers);
  const S radius = numbers == Numbers::distant ? static_cast<S>(random.integer(0, 8)) : number<S>(random, numbers);
  return {center, random.one_in(20) ? S(0) : random.one_in(20) ? radius : std::abs(radius)};
}

/// Sometimes with both ends at one point.
template <class S, int N>
Capsule<S, N> capsule(Random& random, Numbers numbers) {
  const Sphere<S, N> end = ball<S, N>(random, numbers);
  return {end.center, random.one_in(20) ? end.center : vector<S, N>(random, numbers), end.radius};
}

/// Sometimes along a coordinate axis; sometimes empty, when both ends are one point.
template <class S>
Cylinder<S> cylinder(Random& random, Numbers numbers) {
  const Capsule<S, 3> c = capsule<S, 3>(random, numbers);
  Cylinder<S> result = {c.p, c.q, c.radius};
  if (random.one_in(3))
    for (int i = 0, kept = random.below(3); i < 3; ++i)
      if (i != kept) result.q[i] = result.p[i];
  return result;
}
template <class S>
Cone<S> cone(Random& random, Numbers numbers) {
  const Cylinder<S> c = cylinder<S>(random, numbers);
  return {c.p, c.q, c.radius};
}

}  // namespace isect::bench
