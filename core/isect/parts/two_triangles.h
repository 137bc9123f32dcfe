#pragma once
// Two triangles in space, each with an area: whether they meet, pass through each other, or have a stretch of an edge
// in common. What isect/mesh_mesh.h asks of neighbours and of two surfaces. All by the signs of volumes and areas.
// Source: Guigue, Devillers, Fast and robust triangle-triangle overlap test, J. Graphics Tools 8 (2003).

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <isect/orient.h>
#include <isect/shapes.h>

namespace isect::mesh_mesh::detail {

using Point3 = Point<double, 3>;
using Corners = Triangle<double, 3>;

using Signs = std::array<int, 3>;

/// The sides of the corners, as seen from a plane: 1 below it, where it turns clockwise.
inline Signs sides(const Corners& plane, const Corners& x) {
  const auto& [a, b, c] = plane.vertices;
  return {orient3d(a, b, c, x.vertices[0]), orient3d(a, b, c, x.vertices[1]), orient3d(a, b, c, x.vertices[2])};
}
inline bool beside(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }
inline bool on_both_sides(const Signs& s) {
  return std::min({s[0], s[1], s[2]}) < 0 && std::max({s[0], s[1], s[2]}) > 0;
}

/// Where the line through p and q passes the triangle, whose plane does not hold it: in it, on its boundary, out of it.
inline Location passes(const Point3& p, const Point3& q, const Corners& x) {
  const auto& [a, b, c] = x.vertices;
  const Signs turns = {orient3d(p, q, a, b), orient3d(p, q, b, c), orient3d(p, q, c, a)};
  return beside(turns) ? Location::in : on_both_sides(turns) ? Location::out : Location::on;
}

/// Whether a point inside both triangles lies in no edge of either: they pass through each other.
inline bool cross(const Corners& x, const Signs& of_x, const Corners& y, const Signs& of_y) {
  if (!on_both_sides(of_x) || !on_both_sides(of_y)) return false;
  int in = 0, on = 0;  // of the ends of what one has on the other's plane
  const auto count = [&](const Corners& one, const Signs& s, const Corners& other) {
    std::size_t i = 0;  // alone on its side
    while (s[i] == 0 || s[i] == s[(i + 1) % 3] || s[i] == s[(i + 2) % 3]) ++i;
    on = 0;
    for (const std::size_t k : {(i + 1) % 3, (i + 2) % 3}) {
      const Location where = passes(one.vertices[i], one.vertices[k], other);
      in += where == Location::in;
      on += where == Location::on;
    }
  };
  count(x, of_x, y);
  if (in > 0 || on == 2) return true;
  count(y, of_y, x);
  return in > 0;
}

/// p without a coordinate.
inline Point<double, 2> flat(const Point3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }
inline int turn(const Point3& p, const Point3& q, const Point3& x, int axis) {
  return orient2d(flat(p, axis), flat(q, axis), flat(x, axis));
}
/// An axis along which p, q and x are seen to turn; 3 if they lie on one line.
inline int axis_of(const Point3& p, const Point3& q, const Point3& x) {
  int axis = 0;
  while (axis < 3 && turn(p, q, x, axis) == 0) ++axis;
  return axis;
}

/// Whether the segment, in the triangle's plane, has a stretch inside the triangle.
inline bool within(const Point3& p, const Point3& q, const Corners& x) {
  const auto& v = x.vertices;
  const int axis = axis_of(v[0], v[1], v[2]), sense = turn(v[0], v[1], v[2], axis);
  Signs of_line;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3 &a = v[i], &b = v[(i + 1) % 3];
    if (turn(a, b, p, axis) * sense <= 0 && turn(a, b, q, axis) * sense <= 0) return false;
    of_line[i] = turn(p, q, a, axis);
  }
  return on_both_sides(of_line);
}

/// Whether two segments lie on one line and have a stretch in common.
inline bool share_stretch(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
  if (axis_of(p, q, r) < 3 || axis_of(p, q, s) < 3) return false;
  int axis = 0;
  while (p[axis] == q[axis]) ++axis;
  return std::max(std::min(p[axis], q[axis]), std::min(r[axis], s[axis])) <
         std::min(std::max(p[axis], q[axis]), std::max(r[axis], s[axis]));
}

/// Whether a point, in the triangle's plane, lies in the triangle.
inline bool holds(const Corners& x, const Point3& p) {
  const auto& v = x.vertices;
  const int axis = axis_of(v[0], v[1], v[2]), sense = turn(v[0], v[1], v[2], axis);
  return turn(v[0], v[1], p, axis) * sense >= 0 && turn(v[1], v[2], p, axis) * sense >= 0 &&
         turn(v[2], v[0], p, axis) * sense >= 0;
}

/// Whether a side of the triangle has all of some points, in its plane, beyond it.
inline bool parts_from(const Corners& x, std::span<const Point3> points) {
  const auto& v = x.vertices;
  const int axis = axis_of(v[0], v[1], v[2]), sense = turn(v[0], v[1], v[2], axis);
  for (std::size_t i = 0; i < 3; ++i)
    if (std::ranges::all_of(points, [&](const Point3& p) { return turn(v[i], v[(i + 1) % 3], p, axis) * sense < 0; }))
      return true;
  return false;
}

/// Whether segment and triangle have a common point.
inline bool meets(const Point3& p, const Point3& q, const Corners& x) {
  const auto& [a, b, c] = x.vertices;
  const int of_p = orient3d(a, b, c, p), of_q = orient3d(a, b, c, q);
  if (of_p * of_q != 0) return of_p != of_q && passes(p, q, x) != Location::out;
  if (of_p != 0) return holds(x, q);
  if (of_q != 0) return holds(x, p);
  const int axis = axis_of(a, b, c);
  return !beside({turn(p, q, a, axis), turn(p, q, b, axis), turn(p, q, c, axis)}) && !parts_from(x, std::array{p, q});
}

/// Whether two triangles have a common point, neither beside the other's plane.
inline bool meet(const Corners& x, const Signs& of_x, const Corners& y) {
  if (of_x == Signs{0, 0, 0}) return !parts_from(x, y.vertices) && !parts_from(y, x.vertices);
  for (std::size_t i = 0; i < 3; ++i)
    if (meets(x.vertices[i], x.vertices[(i + 1) % 3], y) || meets(y.vertices[i], y.vertices[(i + 1) % 3], x))
      return true;
  return false;
}

}  // namespace isect::mesh_mesh::detail
