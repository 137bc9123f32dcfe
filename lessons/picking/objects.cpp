#include "lessons/picking/objects.h"

#include <isect/fit_tight.h>

namespace isect::lessons::picking_lesson {

using namespace viewing;

namespace {

using viz::Role;
using viz::Vec3;

/// Eight triangles, counter-clockwise seen from outside.
Triangles octahedron(const Vec3& center, double r) {
  Triangles all;
  for (const double x : {-r, r})
    for (const double y : {-r, r})
      for (const double z : {-r, r}) {
        const Vec3 a = center + Vec3(x, 0, 0), b = center + Vec3(0, y, 0), c = center + Vec3(0, 0, z);
        if (x * y * z > 0)
          all.push_back({{a, b, c}});
        else
          all.push_back({{a, c, b}});
      }
  return all;
}

/// Two triangles a face, counter-clockwise seen from outside.
Triangles crate(const Vec3& lo, const Vec3& hi) {
  Triangles all;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto corner = [&](bool high_u, bool high_v) {
        Vec3 p;
        p[axis] = upper ? hi[axis] : lo[axis];
        p[u] = high_u ? hi[u] : lo[u], p[v] = high_v ? hi[v] : lo[v];
        return p;
      };
      const Vec3 a = corner(false, false), b = corner(true, false), c = corner(true, true), d = corner(false, true);
      if (upper) {
        all.push_back({{a, b, c}}), all.push_back({{a, c, d}});
      } else {
        all.push_back({{a, c, b}}), all.push_back({{a, d, c}});
      }
    }
  return all;
}

}  // namespace

std::vector<Object> objects() {
  return {{"the crate", crate({2.5, -1, -2}, {3.5, 1.5, -0.5625}), Role::second},
          {"the gem", octahedron({1, 0.25, -0.75}, 0.875), Role::first},
          {"ball **b**", Sphere<double, 3>{{2, 0.75, 1.21875}, 0.5}, Role::miss},
          {"ball **c**", Sphere<double, 3>{{2, -0.25, 1.21875}, 0.5}, Role::text}};
}

Sphere<double, 3> bounding_ball(const Shape& shape) {
  if (const auto* ball = std::get_if<Sphere<double, 3>>(&shape)) return *ball;
  std::vector<Point<double, 3>> points;
  if (const auto* all = std::get_if<Triangles>(&shape))
    for (const Triangle<double, 3>& t : *all) points.insert(points.end(), t.vertices.begin(), t.vertices.end());
  return fit_sphere_smallest(points);
}

int tests_of(const Shape& shape) {
  const auto* all = std::get_if<Triangles>(&shape);
  return all ? static_cast<int>(all->size()) : 1;
}

}  // namespace isect::lessons::picking_lesson
