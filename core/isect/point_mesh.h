#pragma once
// Point against closed triangle mesh, by the even-odd rule: inside iff a ray from the point crosses the surface an odd
// number of times.
//
// A crossing counts only where the ray passes within a triangle. A ray that meets an edge or a corner, or lies in a
// triangle's plane, says nothing, and another direction is tried: which of these a ray does is decided exactly.
// Source: O'Rourke, Computational Geometry in C, 2nd ed. (1998), 7.5.

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include <isect/sphere_triangle.h>
#include <isect/triangle_mesh.h>

namespace isect {

namespace point_mesh {

using Event = std::variant<Fallback>;

/// Whether every edge belongs to an even number of triangles: only such a surface has an inside. Vertices in the same
/// place count as one.
template <class S>
bool closed(const TriangleMesh<S>& mesh) {
  std::map<std::array<S, 3>, int> places;
  std::vector<int> place;
  for (const Point<S, 3>& v : mesh.vertices)
    place.push_back(
        places.try_emplace({v[0] + S(0), v[1] + S(0), v[2] + S(0)}, static_cast<int>(places.size())).first->second);
  std::map<std::pair<int, int>, int> uses;
  for (const std::array<int, 3>& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = place[static_cast<std::size_t>(t[i])], b = place[static_cast<std::size_t>(t[(i + 1) % 3])];
      if (a != b) ++uses[std::minmax(a, b)];
    }
  return std::ranges::all_of(uses, [](const auto& use) { return use.second % 2 == 0; });
}

namespace detail {

/// Whether a ray of that direction, to larger coordinates, crosses the surface an odd number of times; nothing where it
/// is unclear.
template <class S>
std::optional<bool> odd(const Point<S, 3>& p, const Vector<S, 3>& direction, const TriangleMesh<S>& mesh) {
  const Ray<S, 3> ray = {p, direction};
  bool result = false;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const Triangle<S, 3> x = triangle(mesh, i);
    const auto& [a, b, c] = x.vertices;
    if ((a.cwiseMax(b).cwiseMax(c).array() < p.array()).any()) continue;  // behind
    const RayTriangle<S> hit = intersect(ray, x);
    if (hit.coplanar || (hit.t && hit.location == Location::on)) return {};
    if (hit.t) result = !result;
  }
  return result;
}

}  // namespace detail

}  // namespace point_mesh

/// Where the point lies. Exact. The mesh is closed (see point_mesh::closed) and its indices are valid. Out for a mesh,
/// or a point, with a NaN or an infinite coordinate.
template <class S>
Location locate(const Point<S, 3>& p, const TriangleMesh<S>& mesh) {
  if (!finite(p) || !std::ranges::all_of(mesh.vertices, [](const Point<S, 3>& v) { return finite(v); }))
    return Location::out;
  Point<S, 3> lo = p, hi = p;
  if (!mesh.vertices.empty()) lo = hi = mesh.vertices.front();
  for (const Point<S, 3>& v : mesh.vertices) lo = lo.cwiseMin(v), hi = hi.cwiseMax(v);
  if (mesh.triangles.empty() || !(lo.array() <= p.array() && p.array() <= hi.array()).all()) return Location::out;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const Triangle<S, 3> x = triangle(mesh, i);
    const auto& [a, b, c] = x.vertices;
    const bool near = (a.cwiseMin(b).cwiseMin(c).array() <= p.array()).all() &&
                      (p.array() <= a.cwiseMax(b).cwiseMax(c).array()).all();
    if (near && intersects(Sphere<S, 3>{p, S(0)}, x)) return Location::on;
  }
  // A plane through the point holds two of these directions at most, so all but finitely many say something.
  for (int k = 3;; ++k) {
    const Vector<S, 3> direction(S(1), S(k), S(k) * S(k));
    if (const std::optional<bool> odd = point_mesh::detail::odd(p, direction, mesh))
      return *odd ? Location::in : Location::out;
  }
}

}  // namespace isect
