#include "viz/solids.h"

#include <Eigen/Geometry>

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
