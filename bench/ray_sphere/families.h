#pragma once
// Rays and spheres that are hard to get right, each family a seeded generator.

#include <span>

#include <isect/shapes.h>
#include "bench/named_draw.h"

namespace isect::bench {

template <class S, int N>
struct RaySphereCase {
  Ray<S, N> ray;
  Sphere<S, N> sphere;
};

template <class S, int N>
using RaySphereDraw = NamedDraw<RaySphereCase<S, N>>;

/// Every family, for float and double in 2 and 3 dimensions; "ordinary" stands first.
template <class S, int N>
std::span<const RaySphereDraw<S, N>> ray_sphere_families();

/// The family of that name, which must exist.
template <class S, int N>
const RaySphereDraw<S, N>& ray_sphere_family(const char* name);

}  // namespace isect::bench
