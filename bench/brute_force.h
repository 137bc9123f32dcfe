#pragma once
// The closest hit of a ray on a mesh by asking every triangle: the reference for hierarchies.

#include <optional>

#include <isect/many/bvh_ray.h>
#include <isect/triangle_mesh.h>

namespace isect::bench {

template <class S>
std::optional<BvhHit<S>> brute_force(const TriangleMesh<S>& mesh, const Ray<S, 3>& ray) {
  std::optional<BvhHit<S>> closest;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const std::optional<S> t = intersect(ray, triangle(mesh, i)).t;
    if (t && (!closest || *t < closest->t)) closest = BvhHit<S>{*t, i};
  }
  return closest;
}

}  // namespace isect::bench
