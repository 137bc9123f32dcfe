#pragma once
// Triangles that share vertices, and rays through them.
//
// Neighbours see the very same numbers at their common edge. As the test of a ray and a triangle is exact, no ray
// slips between them, and as the hierarchy loses no hit, none slips through the mesh.

#include <array>
#include <optional>
#include <vector>

#include <isect/many/bvh_ray.h>
#include <isect/ray_triangle.h>

namespace isect {

template <class S>
struct TriangleMesh {
  std::vector<Point<S, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< indices of vertices, counter-clockwise seen from outside
};

/// Whether every index names a vertex. All that follows assumes it.
template <class S>
bool valid(const TriangleMesh<S>& mesh) {
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const std::array<int, 3>& triangle : mesh.triangles)
    for (const int i : triangle)
      if (i < 0 || i >= vertices) return false;
  return true;
}

template <class S>
Triangle<S, 3> triangle(const TriangleMesh<S>& mesh, int index) {
  const auto [a, b, c] = mesh.triangles[index];
  return {{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}};
}

/// The box of every triangle, for build_bvh; exact. That of a triangle with a NaN may be any, as no ray meets it.
template <class S>
std::vector<Aabb<S, 3>> boxes(const TriangleMesh<S>& mesh) {
  std::vector<Aabb<S, 3>> all;
  all.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point<S, 3>&p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    all.push_back({p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)});
  }
  return all;
}

namespace triangle_mesh {

namespace detail {

/// The t of intersect(ray, triangle) alone: its weights cost more than all of a ray's way through a hierarchy. All is
/// finite; `sign` is that of the volumes where it is known, else 0.
template <class S>
std::optional<S> first_t(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, int sign) {
  const Ray<double, 3> wide = cast<double>(ray);
  const Triangle<double, 3> x = cast<double>(triangle);
  if (sign == 0) {
    const ray_triangle::Volumes side = ray_triangle::detail::volumes(wide, x, NoTrace());
    const bool positive = side.a > 0 || side.b > 0 || side.c > 0, negative = side.a < 0 || side.b < 0 || side.c < 0;
    if (positive == negative) return {};
    sign = positive ? 1 : -1;
  }
  const auto t = [&]<class W>() -> Ratio<W> { return ray_triangle::detail::parameter<W>(wide, x); };
  if (!ray_range::holds(wide.range, t, sign)) return {};
  return ray_range::clamped(value_of<S>(t), ray.range);
}

}  // namespace detail

}  // namespace triangle_mesh

/// The closest hit of the ray on the mesh, whose hierarchy is build_bvh(boxes(mesh)): of the least t, and of the
/// least index among triangles with that t, such as those around an edge that is hit. Exact as intersect(ray,
/// triangle) is, which also gives the place in the triangle. A triangle is not hit by a ray in its plane.
template <class S, class Trace = NoTrace>
std::optional<BvhHit<S>> closest_hit(const Bvh<S, 3>& bvh, const TriangleMesh<S>& mesh, const Ray<S, 3>& ray,
                                     Trace&& trace = {}) {
  const auto hit = [&](int index) -> std::optional<S> {
    const Triangle<S, 3> x = triangle(mesh, index);
    return finite(ray) && finite(x) ? triangle_mesh::detail::first_t(ray, x, 0) : std::nullopt;
  };
  return closest_hit(bvh, ray, hit, trace);
}

/// Whether the ray meets any triangle of the mesh.
template <class S, class Trace = NoTrace>
bool any_hit(const Bvh<S, 3>& bvh, const TriangleMesh<S>& mesh, const Ray<S, 3>& ray, Trace&& trace = {}) {
  const auto hit = [&](int index) {
    return intersects(ray, triangle(mesh, index)) ? std::optional(ray.range.lo) : std::nullopt;
  };
  return any_hit(bvh, ray, hit, trace);
}

/// All triangles of the mesh that the ray meets, by rising t, and by index among those whose rounded t is the same, as
/// at an edge. Otherwise as closest_hit.
template <class S, class Trace = NoTrace>
std::vector<BvhHit<S>> all_hits(const Bvh<S, 3>& bvh, const TriangleMesh<S>& mesh, const Ray<S, 3>& ray,
                                Trace&& trace = {}) {
  const auto hit = [&](int index) -> std::optional<S> {
    const Triangle<S, 3> x = triangle(mesh, index);
    return finite(ray) && finite(x) ? triangle_mesh::detail::first_t(ray, x, 0) : std::nullopt;
  };
  return all_hits(bvh, ray, hit, trace);
}

}  // namespace isect
