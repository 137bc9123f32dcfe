#include "viz/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include <isect/convex_hull_3d.h>
#include <isect/kdop_polytope.h>

namespace isect::viz {

Solid hexahedron(const std::array<Vec3, 8>& corners, Role role) {
  // Counter-clockwise seen from outside, for axes that are right-handed: x, y, z low, then high.
  return {{corners.begin(), corners.end()},
          {{0, 4, 6, 2}, {0, 1, 5, 4}, {0, 2, 3, 1}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}},
          role};
}

Solid solid(const Aabb<double, 3>& box, Role role) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) corners[i][axis] = (i >> axis & 1) != 0 ? box.hi[axis] : box.lo[axis];
  return hexahedron(corners, role);
}

Solid solid(const Obb<double, 3>& box, Role role) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    Vec3 s = box.half;
    for (int axis = 0; axis < 3; ++axis)
      if ((i >> axis & 1) == 0) s[axis] = -s[axis];
    corners[i] = box.center + box.axes * s;
  }
  return hexahedron(corners, role);
}

Solid solid(const Polytope<double, 3>& shape, Role role) { return {shape.vertices, shape.faces, role}; }

Solid solid(const Kdop<double, 3>& kdop, Role role) { return solid(polytope(kdop), role); }

Solid solid(const Hull3<double>& hull, Role role) {
  Solid result = {hull.vertices, {}, role};
  for (const std::array<int, 3>& t : hull.triangles) result.faces.push_back({t[0], t[1], t[2]});
  return result;
}

Solid solid(const Frustum<double>& frustum, Role role) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {  // left or right, bottom or top, near or far
    const auto plane = [&](int axis) -> const Plane<double, 3>& { return frustum.planes[2 * axis + (i >> axis & 1)]; };
    const Plane<double, 3>&a = plane(0), &b = plane(1), &c = plane(2);
    const Vec3 bc = b.normal.cross(c.normal), ca = c.normal.cross(a.normal), ab = a.normal.cross(b.normal);
    corners[i] = -(a.d * bc + b.d * ca + c.d * ab) / a.normal.dot(bc);
  }
  return hexahedron(corners, role);
}

namespace {

constexpr int round_sides = 72;

/// Returns a regular polygon around `middle`, across `axis`, counter-clockwise as seen from where the axis points.
std::vector<Vec3> circle_around(const Vec3& middle, const Vec3& axis, double radius) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vec3 along = axis.stableNormalized(), u = along.cross(Vec3::Unit(least)).normalized(), v = along.cross(u);
  std::vector<Vec3> points;
  for (int i = 0; i < round_sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / round_sides;
    points.push_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

/// Returns the numbers from the first point to the last.
std::vector<int> numbered(int first, int last) {
  std::vector<int> all(static_cast<std::size_t>(last - first));
  std::iota(all.begin(), all.end(), first);
  return all;
}

}  // namespace

Solid solid(const Cylinder<double>& x, Role role) {
  Solid result = {circle_around(x.p, x.q - x.p, x.radius),
                  {numbered(0, round_sides), numbered(round_sides, 2 * round_sides)},
                  role};
  std::ranges::copy(circle_around(x.q, x.q - x.p, x.radius), std::back_inserter(result.vertices));
  for (int i = 0; i < round_sides; ++i) {
    const int next = (i + 1) % round_sides;
    result.faces.push_back({i, next, round_sides + next, round_sides + i});
  }
  result.round = {x.p, x.q, x.radius, false};
  return result;
}

Solid solid(const Cone<double>& x, Role role) {
  Solid result = {circle_around(x.base, x.apex - x.base, x.radius), {numbered(0, round_sides)}, role};
  result.vertices.push_back(x.apex);
  for (int i = 0; i < round_sides; ++i) result.faces.push_back({i, (i + 1) % round_sides, round_sides});
  result.round = {x.apex, x.base, x.radius, true};
  return result;
}

Region face(const Aabb<double, 3>& box, int axis, double coordinate, Role role) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Vec3> ring;
  for (const auto& [high_u, high_v] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
    Vec3 p;
    p[axis] = coordinate, p[u] = high_u ? box.hi[u] : box.lo[u], p[v] = high_v ? box.hi[v] : box.lo[v];
    ring.push_back(p);
  }
  return {.rings = {ring}, .role = role};
}

}  // namespace isect::viz
