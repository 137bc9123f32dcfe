#include "app/scene/shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
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

HalfSpaces hull_faces(const Setting& s, const Object& o) {
  if (!s.flat) {
    static_cast<void>(solid_of(s, o));  // refuses one without a volume
    return half_spaces_of(hull_of(s, o));
  }
  HalfSpaces result = {{}, 2};
  const std::vector<Vec3> ring = outline_of(s, o);
  if (ring.size() < 3) has_none(o, "its points lie on one line, so their hull has no area");
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    result.faces.push_back({half_spaces::Behind{a, b, a + Vec3::UnitZ()}});
  }
  return result;
}

template <int N>
HalfSpaces faces(const Setting& s, const Object& o) {
  if (o.type == Type::box) return half_spaces_of(box_of<N>(s, o));
  if (o.type == Type::obb) return half_spaces_of(obb_of<N>(s, o));
  if (o.type == Type::kdop) return half_spaces_of(kdop_of<N>(s, o));
  if (o.type == Type::frustum) return half_spaces_of(frustum_of(s, o));
  return hull_faces(s, o);
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

Triangle<double, 3> triangle_of(const Setting& s, const Object& o) {
  const std::vector<Vec3> p = s.rings(o).front();
  return {{p[0], p[1], p[2]}};
}

Capsule<double, 3> capsule_in_space(const Setting& s, const Object& o) {
  if (o.type == Type::sphere) return {s.point(o, "center"), s.point(o, "center"), s.number(o, "radius")};
  return {s.point(o, "p"), s.point(o, "q"), s.number(o, "r")};
}

HalfSpaces faces_of(const Setting& s, const Object& o) { return s.flat ? faces<2>(s, o) : faces<3>(s, o); }

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
