#include "lessons/bounding_volumes/object.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include <isect/aabb_aabb.h>
#include <isect/directions.h>
#include <isect/fit.h>
#include <isect/fit_tight.h>
#include <isect/kdop_kdop.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/obb_obb.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/orient.h>
#include <isect/sphere_sphere.h>
#include <isect/volume.h>
#include "viz/solids.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

using C = Counted<double>;
using Mesh3 = TriangleMesh<double>;

/// Right-handed axes, the first along `tip`; their turn about it is arbitrary, but smooth.
Eigen::Matrix3d frame_along(const Vec3& tip) {
  Eigen::Matrix3d axes;
  const Vec3 along = tip.norm() > 0 ? Vec3(tip.normalized()) : Vec3(Vec3::UnitX());
  const Vec3 aside = Vec3(-0.28, 0.6, 0.75).cross(along);
  axes.col(0) = along;
  axes.col(2) = aside.norm() > 0 ? Vec3(aside.normalized()) : along.unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// The point at this angle on the unit circle.
Vec2 on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Rings of vertices around the first axis, closed by a point at either end. Along runs from -1 to 1.
Mesh3 revolved(const std::vector<Vec2>& profile, double half_length, const Eigen::Matrix3d& axes) {
  constexpr int columns = 20;
  const int rows = static_cast<int>(profile.size());
  Mesh3 mesh;
  mesh.vertices = {-half_length * axes.col(0), half_length * axes.col(0)};
  for (const Vec2& p : profile)
    for (int j = 0; j < columns; ++j) {
      const Vec2 around = on_circle(2 * std::numbers::pi * j / columns);
      mesh.vertices.emplace_back(axes * Vec3(p.x() * half_length, p.y() * around.x(), p.y() * around.y()));
    }
  const auto at = [&](int i, int j) { return 2 + i * columns + j % columns; };
  for (int j = 0; j < columns; ++j) {
    mesh.triangles.push_back({0, at(0, j + 1), at(0, j)});
    mesh.triangles.push_back({1, at(rows - 1, j), at(rows - 1, j + 1)});
    for (int i = 0; i + 1 < rows; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

/// A skittle: a thick body, a neck and a head.
Mesh3 pin(double half_length, const Eigen::Matrix3d& axes) {
  std::vector<Vec2> profile;
  for (const auto& [along, radius] : {std::pair{-0.96, 0.3},
                                      {-0.85, 0.45},
                                      {-0.65, 0.58},
                                      {-0.4, 0.64},
                                      {-0.15, 0.6},
                                      {0.1, 0.48},
                                      {0.3, 0.35},
                                      {0.5, 0.27},
                                      {0.65, 0.29},
                                      {0.8, 0.32},
                                      {0.9, 0.28},
                                      {0.97, 0.16}})
    profile.emplace_back(along, radius);
  return revolved(profile, half_length, axes);
}

Mesh3 ball(double half_length, const Eigen::Matrix3d& axes) {
  constexpr int rows = 12;
  std::vector<Vec2> profile;
  for (int i = 1; i < rows; ++i) {
    const Vec2 on = on_circle(std::numbers::pi * i / rows);
    profile.emplace_back(-on.x(), half_length * on.y());
  }
  return revolved(profile, half_length, axes);
}

/// Two arms at a right angle, the longer one along the first axis.
Mesh3 bracket(double half_length, const Eigen::Matrix3d& axes) {
  const double end = std::max(half_length, 0.5), thick = 0.5, arm = 1.5, deep = 0.375;
  const Vec2 outline[] = {{-end, 0}, {end, 0}, {end, thick}, {thick - end, thick}, {thick - end, arm}, {-end, arm}};
  Mesh3 mesh;
  for (const double z : {-deep, deep})
    for (const Vec2& p : outline) mesh.vertices.emplace_back(axes * Vec3(p.x(), p.y() - arm / 3, z));
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({6 + a, 6 + b, 6 + c});
  }
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, 6 + j});
    mesh.triangles.push_back({i, 6 + j, 6 + i});
  }
  return mesh;
}

// One overlap test of a volume with itself: every comparison is made, as nothing separates.

template <class Run>
Tally counted(const Run& run) {
  const Tally before = tally();
  tally() = {};
  run();
  const Tally result = tally();
  tally() = before;
  return result;
}

Tally cost(const Sphere<double, 3>& x) {
  return counted([&] { sphere_sphere::squared_distance_naive(cast<C>(x), cast<C>(x)); });
}
Tally cost(const Aabb<double, 3>& x) {
  return counted([&] { aabb_aabb::by_axis(cast<C>(x), cast<C>(x)); });
}
Tally cost(const Obb<double, 3>& x) {
  return counted([&] { obb_obb::gottschalk(cast<C>(x), cast<C>(x), C(0x1p-40)); });
}
Tally cost(const Kdop<double, 3>& x) {
  return counted([&] {
    for (const Interval<double>& slab : x.slabs)
      if (!interval_interval::ends(Interval<C>{slab.lo, slab.hi}, Interval<C>{slab.lo, slab.hi})) return;
  });
}

std::string dop(const Kdop<double, 3>& kdop) { return fmt::format("{}-DOP", 2 * kdop.slabs.size()); }

template <class Volume>
Measured measure(const std::string& name, const Volume& x, double object, const Item& drawn) {
  return {name, volume(x), void_volume(x, object), numbers_kept(x), cost(x), drawn};
}

}  // namespace

Mesh3 object(const std::string& name, const Vec3& tip) {
  const Eigen::Matrix3d axes = frame_along(tip);
  const double half_length = std::max(tip.norm(), 0.125);
  Mesh3 mesh = name == "bracket" ? bracket(half_length, axes)
               : name == "ball"  ? ball(half_length, axes)
                                 : pin(half_length, axes);
  // Sines and sums of products differ from machine to machine in their last digits, and the fits are exact.
  for (Vec3& vertex : mesh.vertices)
    vertex = vertex.unaryExpr([](double x) { return std::round(x * 0x1p32) * 0x1p-32; });
  return mesh;
}

Fitted::Fitted(const Mesh3& mesh, int k)
    : object(volume(mesh.vertices, mesh.triangles)),
      hull(convex_hull(mesh.vertices)),
      ball(fit_sphere_smallest(hull.vertices)),
      aabb(fit_aabb(hull.vertices)),
      obb(fit_obb_tight(hull)),
      kdop(fit_kdop(hull.vertices, directions<double, 3>(k))) {}

Measured measured(const Kdop<double, 3>& kdop, double object) {
  const Polytope<double, 3> shape = polytope(kdop);  // once for all: the slowest part
  return {dop(kdop),          volume(shape), void_volume(shape, object),
          numbers_kept(kdop), cost(kdop),    solid(shape, Role::second)};
}

std::vector<Measured> measured_kdops(const Hull3<double>& hull, double object) {
  std::vector<Measured> all;
  for (const std::string& k : sizes_of_dops)
    all.push_back(measured(fit_kdop(hull.vertices, directions<double, 3>(std::stoi(k))), object));
  return all;
}

std::vector<Measured> measured(const Fitted& f, const Measured& kdop) {
  return {
      measure("sphere", f.ball, f.object, Ball{f.ball.center, f.ball.radius, Role::second}),
      measure("AABB", f.aabb, f.object, solid(f.aabb, Role::second)),
      measure("OBB", f.obb, f.object, solid(f.obb, Role::second)),
      kdop,
      {"hull", volume(f.hull), void_volume(f.hull, f.object), numbers_kept(f.hull), {}, solid(f.hull, Role::second)}};
}

}  // namespace isect::lessons::bounding_volumes_lesson
