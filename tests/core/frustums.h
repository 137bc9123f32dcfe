#pragma once
// Frustums for tests: a view pyramid whose planes have small integer coordinates, one with rounded planes, and any
// six half-spaces.

#include "bench/simple_shapes.h"

namespace isect::tests {

/// The pyramid from the origin along +z: |x| <= z, |y| <= z, 1 <= z <= 8.
template <class S>
Frustum<S> pyramid() {
  const auto plane = [](double x, double y, double z, double d) {
    return Plane<S, 3>{Vector<double, 3>(x, y, z).cast<S>(), S(d)};
  };
  return {{plane(1, 0, 1, 0), plane(-1, 0, 1, 0), plane(0, 1, 1, 0), plane(0, -1, 1, 0), plane(0, 0, 1, -1),
           plane(0, 0, -1, 8)}};
}

/// The pyramid, as it is or with unit normals, or six random planes.
template <class S>
Frustum<S> frustum(bench::Random& random, bench::Numbers numbers) {
  Frustum<S> f = pyramid<S>();
  if (random.one_in(3)) return f;
  const bool any = random.one_in(2);
  for (Plane<S, 3>& plane : f.planes) {
    if (any)
      plane = {bench::vector<S, 3>(random, numbers), bench::number<S>(random, numbers)};
    else
      plane = {plane.normal / std::sqrt(plane.normal.dot(plane.normal)), plane.d};
  }
  return f;
}

}  // namespace isect::tests
