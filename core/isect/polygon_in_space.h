#pragma once
// A polygon in space, cut into triangles (isect/polygon_triangles.h), against points, lines, triangles, convex solids,
// round ones and other polygons.
//
// A convex polygon is half-spaces, as any plate. For any other each triangle is tested, and then:
//
// - It lies in a convex B where its corners do.
// - B lies in it where the triangles cover B.
//   That is tested triangle by triangle: the part of B beyond one of its sides has to lie in the triangles after it,
//   and the rest is covered.
// - A point is within it, and not on its outline, where it is within a triangle or a diagonal: a side of two triangles.
//
// All of this is decided by signs of determinants, see isect/half_spaces.h. Whether triangles cover something takes the
// cube of their number, so two polygons in one plane are asked as isect/polygon_polygon.h does, in O(n lg n). A polygon
// that is not flat is the surface of its triangles, and its points within are those between its edges.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#include <isect/line_triangle.h>
#include <isect/polygon_polygon.h>
#include <isect/polygon_triangles.h>
#include <isect/sphere_triangle.h>
#include <isect/triangle_half_spaces.h>

namespace isect {

namespace polygon_in_space {

namespace detail {

/// A convex part of a set, and a box that holds it, if one is known.
struct Part {
  HalfSpaces faces;
  std::optional<Aabb<double, 3>> box = {};
};
inline bool meet(const Part& a, const Part& b) {
  return (!a.box || !b.box || intersects(*a.box, *b.box)) && intersects(a.faces, b.faces);
}

/// A set as the union of its pieces. Its points within are those within a piece or within a diagonal.
struct Parts {
  std::vector<Part> pieces, diagonals = {};
};

/// Returns the triangles, and as diagonals the sides that two of them share.
template <class S>
Parts parts_of(const TriangulatedPolygon<S>& x) {
  const auto at = [&](int i) -> Point<double, 3> {
    return x.outline[static_cast<std::size_t>(i)].template cast<double>();
  };
  Parts all;
  std::map<std::pair<int, int>, int> sides;
  for (const std::array<int, 3>& three : x.triangles) {
    const Point<double, 3> a = at(three[0]), b = at(three[1]), c = at(three[2]);
    all.pieces.push_back({half_spaces_of(Triangle<double, 3>{{a, b, c}}),
                          Aabb<double, 3>{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)}});
    for (std::size_t i = 0; i < 3; ++i) ++sides[std::minmax(three[i], three[(i + 1) % 3])];
  }
  for (const auto& [ends, count] : sides) {
    if (count != 2) continue;
    const Point<double, 3> a = at(ends.first), b = at(ends.second);
    all.diagonals.push_back({half_spaces_of(Segment<double, 3>{a, b}), Aabb<double, 3>{a.cwiseMin(b), a.cwiseMax(b)}});
  }
  return all;
}

/// Whether solids cover a convex set, which has a point.
inline bool covered(HalfSpaces set, std::span<const HalfSpaces> by) {
  if (by.empty()) return false;
  const HalfSpaces& first = by.front();
  const std::span<const HalfSpaces> others = by.subspan(1);
  if (!intersects(set, first)) return covered(set, others);
  for (const half_spaces::Face& face : first.faces) {
    if (half_spaces::detail::inside(set, {face}, NoTrace())) continue;
    HalfSpaces beyond = set;
    beyond.faces.push_back({face.form, !face.turned});
    if (!covered(beyond, others)) return false;
    set.faces.push_back(face);
  }
  return true;
}

/// Whether A lies in B.
inline bool lies_in(const Parts& a, const Parts& b) {
  return std::ranges::all_of(a.pieces, [&](const Part& piece) {
    std::vector<HalfSpaces> near;
    for (const Part& other : b.pieces)
      if (meet(piece, other)) near.push_back(other.faces);
    return covered(piece.faces, near);
  });
}

inline bool interiors_meet(const Parts& a, const Parts& b) {
  for (const std::vector<Part>* const of_a : {&a.pieces, &a.diagonals})
    for (const std::vector<Part>* const of_b : {&b.pieces, &b.diagonals})
      for (const Part& x : *of_a)
        for (const Part& y : *of_b)
          if (meet(x, y) && half_spaces::detail::interiors_meet(x.faces, y.faces, NoTrace())) return true;
  return false;
}

inline Relation relation(const Parts& a, const Parts& b) {
  const auto meets_b = [&](const Part& x) {
    return std::ranges::any_of(b.pieces, [&](const Part& y) { return meet(x, y); });
  };
  if (std::ranges::none_of(a.pieces, meets_b)) return Relation::disjoint;
  const bool a_in_b = lies_in(a, b), b_in_a = lies_in(b, a);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return interiors_meet(a, b) ? Relation::overlapping : Relation::touching;
}

/// Returns two polygons in one plane as they are seen along an axis; nothing for others.
template <class S>
std::optional<std::array<Polygon<S, 2>, 2>> in_one_plane(const TriangulatedPolygon<S>& a,
                                                         const TriangulatedPolygon<S>& b) {
  const Triangle<double, 3> first = cast<double>(triangle(a, 0));
  const auto& [p, q, r] = first.vertices;
  const int axis = segment_polygon::detail::steepest(Ring<double, 3>{p, q, r});
  std::array<Polygon<S, 2>, 2> seen = {Polygon<S, 2>{{{}}}, Polygon<S, 2>{{{}}}};
  for (const TriangulatedPolygon<S>* const x : {&a, &b})
    for (const Point<S, 3>& v : x->outline) {
      if (orient3d(p, q, r, v.template cast<double>()) != 0) return {};
      seen[x == &b].rings[0].emplace_back(v[(axis + 1) % 3], v[(axis + 2) % 3]);
    }
  return seen;
}

/// Relates the polygon (A) to a convex solid that has a volume.
template <class S>
Relation to_solid(const TriangulatedPolygon<S>& a, const HalfSpaces& solid) {
  int most = -1;
  bool inside = true;
  for (int i = 0; i < static_cast<int>(a.triangles.size()); ++i) {
    const Triangle<S, 3> x = triangle(a, i);
    if (most < 1) most = std::max(most, triangle_half_spaces::detail::common(cast<double>(x), solid.faces, NoTrace()));
    inside = inside &&
             std::ranges::all_of(x.vertices, [&](const auto& v) { return locate<S, 3>(v, solid) != Location::out; });
  }
  return most < 0   ? Relation::disjoint
         : inside   ? Relation::a_inside_b
         : most > 0 ? Relation::overlapping
                    : Relation::touching;
}

// A ball, a capsule, a cylinder or a cone: its relation to a triangle, and the axis that is all of it without a radius.

template <class Solid, class S>
Relation to_triangle(const Solid& x, const Triangle<S, 3>& t) {
  if constexpr (requires { relate(x, t); })
    return relate(x, t);
  else
    return relate(x, half_spaces_of(t));
}
/// Whether a triangle in the solid has a point inside: it may lie in an end of a cylinder, or in a cone's base.
template <class Solid, class S>
bool reaches_inside(const Solid& x, const Triangle<S, 3>& t) {
  if constexpr (std::is_same_v<Solid, Cylinder<S>> || std::is_same_v<Solid, Cone<S>>)
    return round_half_spaces::detail::meeting(cast<double>(x), half_spaces_of(t), NoTrace()) < 0;
  else
    return true;
}
template <class Solid>
HalfSpaces axis(const Solid& x) {
  if constexpr (requires { x.center; })
    return half_spaces_of(Segment<double, 3>{x.center.template cast<double>(), x.center.template cast<double>()});
  else if constexpr (requires { x.apex; })
    return half_spaces_of(Segment<double, 3>{x.apex.template cast<double>(), x.base.template cast<double>()});
  else
    return half_spaces_of(Segment<double, 3>{x.p.template cast<double>(), x.q.template cast<double>()});
}

/// How a surface of triangles (A), a mesh or a polygon, lies to a round solid that has a volume.
template <class Surface, class Solid>
Relation to_round(const Surface& surface, const Solid& solid) {
  bool inside = true, touch = false, overlap = false;
  for (int i = 0; i < static_cast<int>(surface.triangles.size()); ++i) {
    const auto x = triangle(surface, i);
    const Relation r = to_triangle(solid, x);
    inside &= r == Relation::b_inside_a, touch |= r != Relation::disjoint;
    overlap = overlap || r == Relation::overlapping || (r == Relation::b_inside_a && reaches_inside(solid, x));
  }
  return inside    ? Relation::a_inside_b
         : overlap ? Relation::overlapping
         : touch   ? Relation::touching
                   : Relation::disjoint;
}

/// Relates the polygon (A) to a round solid; `exists`: the solid has a point.
template <class S, class Solid>
Relation relate_round(const TriangulatedPolygon<S>& polygon, const Solid& solid, bool exists) {
  if (empty(polygon) || !exists) return Relation::disjoint;
  if (solid.radius == 0) return relate(polygon, axis(solid));
  return to_round(polygon, solid);
}

template <class S, class Line>
std::optional<S> first_hit(const Line& line, const TriangulatedPolygon<S>& polygon) {
  std::optional<S> least;
  for (int i = 0; i < static_cast<int>(polygon.triangles.size()); ++i)
    if (const std::optional<S> t = isect::first_hit(line, triangle(polygon, i)); t && (!least || *t < *least))
      least = t;
  return least;
}

}  // namespace detail

}  // namespace polygon_in_space

/// Returns the half-spaces of a convex polygon in one plane: that from both sides, and a side for each edge.
template <class S>
HalfSpaces half_spaces_of(const TriangulatedPolygon<S>& polygon) {
  assert(!polygon.convex.empty());
  const std::size_t n = polygon.convex.size();
  const auto at = [&](std::size_t i) -> Point<double, 3> {
    return polygon.outline[static_cast<std::size_t>(polygon.convex[i % n])].template cast<double>();
  };
  using half_spaces::Behind, half_spaces::Beside;
  HalfSpaces result = {{{Behind{at(0), at(1), at(2)}}, {Behind{at(0), at(1), at(2)}, true}}};
  for (std::size_t i = 0; i < n; ++i) result.faces.push_back({Beside{at(i), at(i + 1), at(i + 2)}});
  return result;
}

// How a polygon in space (A) lies to another shape. Exact, for all finite input. Empty polygons, and what is empty, NaN
// or infinite, are disjoint from all. Two that are not flat, or a plate across one, overlap where points within both
// meet.

/// Relates the polygon (A) to a solid of space, which may have no volume.
template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const HalfSpaces& solid) {
  using namespace polygon_in_space::detail;
  if (empty(polygon)) return Relation::disjoint;
  if (!polygon.convex.empty()) return relate(half_spaces_of(polygon), solid);
  if (half_spaces::detail::has_interior(solid.faces, NoTrace())) return to_solid(polygon, solid);
  return relation(parts_of(polygon), Parts{{{solid}}});
}

template <class S>
Relation relate(const TriangulatedPolygon<S>& a, const TriangulatedPolygon<S>& b) {
  using namespace polygon_in_space::detail;
  if (empty(a) || empty(b)) return Relation::disjoint;
  if (const auto seen = in_one_plane(a, b)) return relate((*seen)[0], (*seen)[1]);
  if (!b.convex.empty()) return relate(a, half_spaces_of(b));
  if (!a.convex.empty()) return reversed(relate(b, half_spaces_of(a)));
  return relation(parts_of(a), parts_of(b));
}

/// Relates the polygon (A) to any triangle: one without an area is a segment or a point.
template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const Triangle<S, 3>& x) {
  if (!finite(x)) return Relation::disjoint;
  const TriangulatedPolygon<S> other = triangulated(Ring<S, 3>(x.vertices.begin(), x.vertices.end()));
  if (!empty(other)) return relate(polygon, other);
  return relate(polygon, triangle_half_spaces::detail::solid_of(cast<double>(x), 3, NoTrace()));
}

template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const Sphere<S, 3>& ball) {
  return polygon_in_space::detail::relate_round(polygon, ball, !empty(ball) && finite(ball));
}
template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const Capsule<S, 3>& capsule) {
  return polygon_in_space::detail::relate_round(polygon, capsule, !empty(capsule) && finite(capsule));
}
template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const Cylinder<S>& cylinder) {
  return polygon_in_space::detail::relate_round(polygon, cylinder, round_solid::exists(cylinder));
}
template <class S>
Relation relate(const TriangulatedPolygon<S>& polygon, const Cone<S>& cone) {
  return polygon_in_space::detail::relate_round(polygon, cone, round_solid::exists(cone));
}

/// Whether the point lies on the polygon, which has no inside. Exact.
template <class S>
Location locate(const Point<S, 3>& p, const TriangulatedPolygon<S>& polygon) {
  for (int i = 0; i < static_cast<int>(polygon.triangles.size()); ++i)
    if (intersects(Sphere<S, 3>{p, S(0)}, triangle(polygon, i))) return Location::on;
  return Location::out;
}

/// The first t at which a ray or a line meets the polygon, in its plane, too: that of the triangle that it meets first,
/// as in isect/line_triangle.h. isect/ray_polygon.h tells more where the polygon is flat.
template <class S>
std::optional<S> first_hit(const Ray<S, 3>& ray, const TriangulatedPolygon<S>& polygon) {
  return polygon_in_space::detail::first_hit(ray, polygon);
}
template <class S>
std::optional<S> first_hit(const Segment<S, 3>& segment, const TriangulatedPolygon<S>& polygon) {
  return polygon_in_space::detail::first_hit(segment, polygon);
}

}  // namespace isect
