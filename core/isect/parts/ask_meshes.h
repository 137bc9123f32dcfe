#pragma once
// How isect/ask.h asks meshes: how many triangles, for two meshes the first one's, have a point in the other shape; and
// how they lie, where the mesh bounds a solid and the other has a volume.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <isect/answer.h>
#include <isect/line_triangle.h>
#include <isect/many/bvh_pairs.h>
#include <isect/mesh_convex.h>
#include <isect/mesh_mesh.h>
#include <isect/parts/ask_pairs.h>
#include <isect/polygon_triangles.h>
#include <isect/sphere_triangle.h>
#include <isect/triangle_aabb.h>
#include <isect/triangle_half_spaces.h>
#include <isect/triangle_mesh.h>

namespace isect::ask_pairs {

/// Adds how the solid that mesh A bounds lies to B, if there is one.
template <class S, class B>
void add_solid(const TriangleMesh<S>& a, const B& b, Answer& out) {
  if (bounds_solid(a)) out.relation = relate(a, b);
}

/// Whether two triangles have a corner in common: most neighbours of equal meshes do.
template <class S>
bool share_corner(const Triangle<S, 3>& x, const Triangle<S, 3>& y) {
  for (const Point<S, 3>& v : x.vertices)
    if (v == y.vertices[0] || v == y.vertices[1] || v == y.vertices[2]) return true;
  return false;
}

template <class S>
Answer triangles_met(const TriangleMesh<S>& a, const TriangleMesh<S>& b) {
  const std::vector<Aabb<S, 3>> around_a = boxes(a), around_b = boxes(b);
  std::vector<char> met(a.triangles.size(), 0);
  for (const auto& [i, j] : overlapping_pairs(build_bvh(around_a), around_a, build_bvh(around_b), around_b)) {
    char& one = met[static_cast<std::size_t>(i)];
    if (one) continue;
    const Triangle<S, 3> x = triangle(a, i), y = triangle(b, j);
    one = (share_corner(x, y) && finite(x) && finite(y)) || intersects(x, y);
  }
  int count = 0;
  for (const char one : met) count += one;
  return {.meet = count > 0, .triangles = count};
}
template <class S>
Answer in_order(const TriangleMesh<S>& a, const TriangleMesh<S>& b) {
  Answer out = triangles_met(a, b);
  out.relation = relate_solids(a, b);
  return out;
}
template <class S>
Answer in_order(const TriangleMesh<S>& a, const TriangulatedPolygon<S>& b) {
  return triangles_met(a, TriangleMesh<S>{b.outline, b.triangles});
}
template <class S, class B>
requires(
    detail::is_line<B> || detail::is_round<B> || requires(Triangle<S, 3> x, B b) { intersects(x, b); } ||
    requires(Triangle<S, 3> x, B b) { intersects(b, x); }) Answer triangles_met(const TriangleMesh<S>& a, const B& b) {
  int count = 0;
  std::optional<double> first;
  const std::optional<Aabb<double, 3>> near = around(b);
  for (int i = 0; i < static_cast<int>(a.triangles.size()); ++i) {
    const Triangle<S, 3> x = triangle(a, i);
    if (near && !intersects(*around(x), *near)) continue;
    if constexpr (detail::is_line<B>) {
      const std::optional<S> t = first_hit(b, x);
      if (t && (!first || *t < *first)) first = t;
      count += t.has_value();
    } else if constexpr (detail::is_round<B>) {
      count += intersects(b, solid_of(x));
    } else if constexpr (requires { intersects(x, b); }) {
      count += intersects(x, b);
    } else {
      count += intersects(b, x);
    }
  }
  return {.meet = count > 0, .t = first, .triangles = count};
}
template <class S, class B>
requires requires(TriangleMesh<S> a, B b) { triangles_met(a, b); }
Answer in_order(const TriangleMesh<S>& a, const B& b) {
  Answer out = triangles_met(a, b);
  if constexpr (requires { has_volume(b); })
    if (has_volume(b)) add_solid(a, b, out);
  return out;
}
/// Tests the triangles against B's half-spaces, and the solid against B itself.
template <class S, class B>
Answer by_faces(const TriangleMesh<S>& a, const B& b) {
  Answer out = triangles_met(a, half_spaces_of(b));
  if (has_volume(b)) add_solid(a, b, out);
  return out;
}
template <class S>
Answer in_order(const TriangleMesh<S>& a, const Obb<S, 3>& b) {
  return by_faces(a, b);
}
template <class S>
Answer in_order(const TriangleMesh<S>& a, const Hull3<S>& b) {
  return by_faces(a, b);
}

}  // namespace isect::ask_pairs
