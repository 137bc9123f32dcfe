#include "app/scene/shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <isect/convex_hull.h>
#include <isect/kdop_polytope.h>

namespace isect::program::scene {

namespace {

using viz::Vec3;

[[noreturn]] void has_none(const Object& o, const std::string& what) {
  throw viz::BadInput(fmt::format("{}: {}", o.name, what));
}

}  // namespace

std::vector<Vec3> in_space(const std::vector<Point<double, 2>>& points) {
  std::vector<Vec3> all;
  for (const Point<double, 2>& p : points) all.emplace_back(p.x(), p.y(), 0);
  return all;
}

Frustum<double> frustum_of(const Setting& s, const Object& o) {
  const Vec3 eye = s.point(o, "eye"), f = s.point(o, "forward").stableNormalized();
  const Vec3 right = f.cross(s.point(o, "up")).stableNormalized(), up = right.cross(f);
  if (!(right.squaredNorm() > 0.5)) has_none(o, "forward and up are along one line");
  const double half = s.number(o, "angle") * std::numbers::pi / 360, tall = std::tan(half);
  const double wide = tall * (s.has(o, "aspect") ? s.number(o, "aspect") : 1);
  const double near = s.number(o, "near"), far = s.number(o, "far");
  if (!(near < far)) has_none(o, "near is to be less than far");
  const auto through_eye = [&](const Vec3& normal) { return Plane<double, 3>{normal, -normal.dot(eye)}; };
  return {{through_eye(wide * f + right), through_eye(wide * f - right), through_eye(tall * f + up),
           through_eye(tall * f - up), Plane<double, 3>{f, -f.dot(eye) - near},
           Plane<double, 3>{-f, f.dot(eye) + far}}};
}

Hull3<double> hull_of(const Setting& s, const Object& o) { return convex_hull(s.points(o)); }

TriangleMesh<double> mesh_of(const Object& o) { return {o.fixed.points, o.fixed.triangles}; }

viz::Solid solid_of(const Setting& s, const Object& o) {
  if (o.type == Type::hull) {
    const Hull3<double> hull = hull_of(s, o);
    if (hull.dimension < 3) has_none(o, "its points lie in one plane, so their hull has no volume");
    return viz::solid(hull, viz::Role::second);
  }
  try {
    const viz::Solid solid = viz::solid(kdop_of<3>(s, o), viz::Role::second);
    if (solid.vertices.empty()) has_none(o, "it is empty: its slabs have no common point");
    return solid;
  } catch (const std::invalid_argument&) {
    has_none(o, "its normals do not span space, so it has no end");
  }
}

std::vector<Vec3> outline_of(const Setting& s, const Object& o) {
  if (o.type == Type::hull) return in_space(convex_hull(points_of<2>(s.points(o))));
  try {
    const std::vector<Vec3> corners = in_space(polytope(kdop_of<2>(s, o)).vertices);
    if (corners.empty()) has_none(o, "it is empty: its slabs have no common point");
    return corners;
  } catch (const std::invalid_argument&) {
    has_none(o, "its normals do not span the plane, so it has no end");
  }
}

}  // namespace isect::program::scene
