#pragma once
// The surface of a solid: the triangles of a closed mesh, which of them meet at an edge, and on which side of each the
// solid lies. isect/mesh_mesh.h and isect/mesh_convex.h use it.
//
// The solid is what the even-odd rule says, so the mesh may be turned inside out, in part, too. Two triangles alone at
// an edge both have the solid above them or both below, or, where they run along the edge in the same direction, one
// above and one below. So one ray for each connected part of the surface settles all of its triangles.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <isect/many/bvh_pairs.h>
#include <isect/orient.h>
#include <isect/triangle_mesh.h>

namespace isect::mesh_surface {

using Point3 = Point<double, 3>;
using Corners = Triangle<double, 3>;

// A place is a point that is never rounded: way_to<W>(x) is a positive multiple of the way from it to x, and no
// coordinate of it is below those of least().

/// The mean of some points.
struct Mean {
  std::span<const Point3> points;

  template <PolynomialScalar W>
  Components<W, 3> way_to(const Point3& x) const {
    Components<W, 3> sum = difference<W>(x, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Components<W, 3> way = difference<W>(x, points[i]);
      for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + way[k];
    }
    return sum;
  }
  Point3 least() const {
    Point3 least = points[0];
    for (const Point3& p : points) least = least.cwiseMin(p);
    return least;
  }
};

/// How the ray from a place along `direction` lies to a triangle.
enum class Pierced {
  no,
  yes,
  at_origin,  ///< the place lies in the triangle
  unclear     ///< the ray's line meets an edge or lies in the triangle's plane
};

/// Decides by the signs of volumes, as isect/ray_triangle.h does.
template <class Place>
Pierced pierced(const Place& place, const Vector<double, 3>& direction, const Corners& x) {
  const auto to = [&]<class W>(std::size_t i) { return place.template way_to<W>(x.vertices[i % 3]); };
  bool positive = false, negative = false, zero = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sign_of<long_text>([&]<class W>() -> W {
      return dot(exactly<W>(direction), cross(to.template operator()<W>(i), to.template operator()<W>(i + 1)));
    });
    (side > 0 ? positive : side < 0 ? negative : zero) = true;
  }
  if (positive && negative) return Pierced::no;
  const int height = sign_of<long_text>([&]<class W>() -> W {
    return dot(to.template operator()<W>(0), cross(to.template operator()<W>(1), to.template operator()<W>(2)));
  });
  if (!positive && !negative) return height == 0 ? Pierced::unclear : Pierced::no;  // in its plane, or parallel to it
  if (height == 0) return Pierced::at_origin;
  if ((height > 0) != positive) return Pierced::no;  // behind
  return zero ? Pierced::unclear : Pierced::yes;
}

/// The triangles of a mesh.
struct Surface {
  /// Side `side` of a triangle, from that corner to the next.
  struct Side {
    int triangle, side;
  };

  std::vector<Corners> triangles;
  std::vector<Aabb<double, 3>> boxes;
  Bvh<double, 3> tree;
  std::vector<std::array<int, 3>> places;  ///< a number for each corner, equal where two corners are equal
  std::vector<std::array<int, 3>> edges;   ///< the edge that each side is
  std::vector<Side> sides;                 ///< of all edges, edge by edge
  std::vector<int> first_side;             ///< where the sides of each edge begin in `sides`, and the end

  template <class S>
  explicit Surface(const TriangleMesh<S>& mesh) {
    const std::vector<int> place = numbered(mesh.vertices);
    const std::size_t count = mesh.triangles.size();
    std::vector<std::array<int, 4>> keys;  // both ends, the smaller first; triangle, side
    triangles.reserve(count), boxes.reserve(count), places.reserve(count), keys.reserve(3 * count);
    for (int t = 0; t < static_cast<int>(count); ++t) {
      triangles.push_back(cast<double>(triangle(mesh, t)));
      const auto& [a, b, c] = triangles.back().vertices;
      boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
      places.push_back({});
      for (std::size_t i = 0; i < 3; ++i) places.back()[i] = place[mesh.triangles[t][i]];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [lo, hi] = std::minmax(places.back()[i], places.back()[(i + 1) % 3]);
        keys.push_back({lo, hi, t, static_cast<int>(i)});
      }
    }
    tree = build_bvh(boxes);
    std::ranges::sort(keys);
    edges.resize(count), sides.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto& [lo, hi, t, side] = keys[i];
      if (i == 0 || lo != keys[i - 1][0] || hi != keys[i - 1][1]) first_side.push_back(static_cast<int>(i));
      edges[t][side] = static_cast<int>(first_side.size()) - 1;
      sides.push_back({t, side});
    }
    first_side.push_back(static_cast<int>(sides.size()));
  }

  /// All sides along the edge on which that side of a triangle lies.
  std::span<const Side> at_edge(int t, int side) const {
    const int edge = edges[t][side];
    return {sides.data() + first_side[edge], sides.data() + first_side[edge + 1]};
  }
  const Point3& corner(int t, int i) const { return triangles[t].vertices[static_cast<std::size_t>(i % 3)]; }

 private:
  /// A number for each point, the same for equal ones.
  template <class S>
  static std::vector<int> numbered(const std::vector<Point<S, 3>>& points) {
    std::vector<int> order(points.size()), number(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto less = [&](int i, int j) {
      return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(), points[j].end());
    };
    std::ranges::sort(order, less);
    for (std::size_t i = 1; i < order.size(); ++i)
      number[order[i]] = number[order[i - 1]] + (points[order[i]] == points[order[i - 1]] ? 0 : 1);
    return number;
  }
};

/// Directions of which no plane, through whatever point, holds more than two: all but finitely many meet no edge.
inline Vector<double, 3> direction(int k) { return {1, double(k), double(k) * k}; }

/// Where a place lies, by the ray of that direction, whose components are positive; nothing where the ray is unclear.
/// The triangle `except` does not count.
template <class Place>
std::optional<Location> located(const Place& place, const Vector<double, 3>& direction, const Surface& surface,
                                int except = -1) {
  const Point3 least = place.least();
  bool inside = false;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (t == except || (surface.boxes[t].hi.array() < least.array()).any()) continue;  // behind
    const Pierced found = pierced(place, direction, surface.triangles[t]);
    if (found == Pierced::at_origin) return Location::on;
    if (found == Pierced::unclear) return {};
    inside ^= found == Pierced::yes;
  }
  return inside ? Location::in : Location::out;
}
template <class Place>
Location locate(const Place& place, const Surface& surface) {
  for (int k = 3;; ++k)
    if (const std::optional<Location> found = located(place, direction(k), surface)) return *found;
}

}  // namespace isect::mesh_surface
