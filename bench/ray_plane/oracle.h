#pragma once
// Where a ray meets a plane, in rationals.

#include <optional>

#include "bench/rational.h"

namespace isect::oracle {

/// What a ray and a plane truly have in common; the members mean what those of isect::RayPlane mean.
struct RayPlane {
  bool parallel, coplanar;
  std::optional<Rational> line;
  bool meets;
};

/// The height over the plane is linear along the ray: two values of it tell all. For finite shapes and a normal that
/// is not 0.
template <class S, int N>
RayPlane ray_plane(const Ray<S, N>& ray, const Plane<S, N>& plane) {
  const auto o = rational<S, N>(ray.origin), d = rational<S, N>(ray.direction);
  const auto height = [&](const Coordinates<N>& x) -> Rational {
    return dot(rational<S, N>(plane.normal), x) + Rational(plane.d);
  };
  const Rational at_0 = height(o), at_1 = height(o + d);
  if (at_0 == at_1) {
    const bool coplanar = at_0 == 0;
    return {true, coplanar, {}, coplanar && ray.range.lo <= ray.range.hi};
  }
  const Rational t = at_0 / (at_0 - at_1);
  return {false, false, t, holds(ray.range, t)};
}

}  // namespace isect::oracle
