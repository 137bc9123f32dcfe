#pragma once
// Rays aimed at the common edge of two triangles.

#include <string>

#include "bench/full_precision.h"
#include "bench/ray_triangle/families.h"

namespace isect::bench {

/// Two triangles on either side of an edge.
template <class S>
struct SharedEdge {
  Ray<S, 3> ray;
  Triangle<S, 3> left, right;
};
template <class S>
std::string full_precision(const SharedEdge<S>& c) {
  return full_precision(c.ray) + "; " + full_precision(c.left) + "; " + full_precision(c.right);
}

namespace ray_triangle_families {

/// Two triangles of a parallelogram, bent a little, and a ray aimed at their edge or at one end of it.
template <class S>
SharedEdge<S> shared_edge(Random& random) {
  const RayAndTriangle<S> c = ordinary<S>(random);
  const auto& [p, q, r] = c.b.vertices;
  const Point<S, 3> opposite = p + q - r + random.in_box<3>(0.05).template cast<S>();
  SharedEdge<S> shared = {c.a, c.b, {{q, p, opposite}}};
  aim(shared.ray, on_edge(random, c.b, 0, 1));
  return shared;
}

}  // namespace ray_triangle_families

}  // namespace isect::bench
