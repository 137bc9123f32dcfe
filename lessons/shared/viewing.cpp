#include "lessons/shared/viewing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <isect/polygon.h>
#include <isect/ray_aabb.h>
#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/ray_triangle.h>
#include "viz/solids.h"

namespace isect::lessons::viewing {

using namespace viz;

namespace {

template <class... F>
struct Match : F... {
  using F::operator()...;
};
template <class... F>
Match(F...) -> Match<F...>;

using Sphere3 = Sphere<double, 3>;
using Box3 = Aabb<double, 3>;
using Ring3 = Ring<double, 3>;

std::optional<double> least(const Ray3& ray, const Triangles& triangles) {
  std::optional<double> first;
  for (const Triangle<double, 3>& triangle : triangles)
    if (const std::optional<double> t = intersect(ray, triangle).t; t && (!first || *t < *first)) first = t;
  return first;
}

Ring3 corners(const Triangles& triangles) {
  Ring3 points;
  for (const Triangle<double, 3>& t : triangles) points.insert(points.end(), t.vertices.begin(), t.vertices.end());
  return points;
}

/// The normal of the triangle whose plane is nearest to p.
Vec3 normal_of(const Triangles& triangles, const Vec3& p) {
  Vec3 best = Vec3::UnitY();
  double nearest = INFINITY;
  for (const Triangle<double, 3>& t : triangles) {
    const Vec3 n = (t.vertices[1] - t.vertices[0]).cross(t.vertices[2] - t.vertices[0]).normalized();
    const double away = std::abs(n.dot(p - t.vertices[0]));
    if (away < nearest) nearest = away, best = n;
  }
  return best;
}

/// A solid that has each vertex once, so that it is known which faces are neighbours.
Solid body(const Triangles& triangles, Role role) {
  Solid solid;
  solid.role = role;
  for (const Triangle<double, 3>& t : triangles) {
    solid.faces.emplace_back();
    for (const Vec3& p : t.vertices) {
      const auto found = std::ranges::find(solid.vertices, p);
      solid.faces.back().push_back(static_cast<int>(found - solid.vertices.begin()));
      if (found == solid.vertices.end()) solid.vertices.push_back(p);
    }
  }
  return solid;
}

Box3 around(const Ring3& ring) {
  Box3 box = {ring.front(), ring.front()};
  for (const Point<double, 3>& p : ring) box.lo = box.lo.cwiseMin(p), box.hi = box.hi.cwiseMax(p);
  return box;
}

std::vector<Box3> all_bounds(const std::vector<Object>& objects) {
  std::vector<Box3> boxes;
  for (const Object& o : objects) boxes.push_back(bounds(o.shape));
  return boxes;
}

}  // namespace

std::optional<double> first_hit(const Ray3& ray, const Shape& shape) {
  return std::visit(Match{[&](const Sphere3& s) -> std::optional<double> { return intersect(ray, s).surface; },
                          [&](const Box3& b) -> std::optional<double> {
                            const auto inside = intersect(ray, b);
                            return inside ? std::optional(inside->lo) : std::nullopt;
                          },
                          [&](const Ring3& r) -> std::optional<double> { return intersect(ray, r).t; },
                          [&](const Triangles& all) -> std::optional<double> { return least(ray, all); }},
                    shape);
}

Vec3 normal_at(const Shape& shape, const Vec3& p) {
  return std::visit(Match{[&](const Sphere3& s) -> Vec3 { return (p - s.center).normalized(); },
                          [&](const Box3& b) -> Vec3 {  // of the face nearest to p
                            const Vec3 from = (p - (b.lo + b.hi) / 2).cwiseQuotient(b.hi - b.lo);
                            int axis = 0;
                            from.cwiseAbs().maxCoeff(&axis);
                            Vec3 n = Vec3::Zero();
                            n[axis] = from[axis] < 0 ? -1 : 1;
                            return n;
                          },
                          [&](const Ring3& r) -> Vec3 {
                            const Vec3 n = normal(r).value_or(Vec3::UnitY());
                            return n.y() < 0 ? Vec3(-n) : n;
                          },
                          [&](const Triangles& all) -> Vec3 { return normal_of(all, p); }},
                    shape);
}

Box3 bounds(const Shape& shape) {
  return std::visit(Match{[](const Sphere3& s) -> Box3 {
                            const Vec3 r = Vec3::Constant(s.radius);
                            return {s.center - r, s.center + r};
                          },
                          [](const Box3& b) -> Box3 { return b; }, [](const Ring3& r) -> Box3 { return around(r); },
                          [](const Triangles& all) -> Box3 { return around(corners(all)); }},
                    shape);
}

Vec3 middle(const Shape& shape) {
  const Box3 box = bounds(shape);
  return (box.lo + box.hi) / 2;
}

World::World(std::vector<Object> all)
    : objects(std::move(all)), bvh(build_bvh(all_bounds(objects), {.largest_leaf = 1})) {}

Camera eye_camera() {
  Camera camera;
  camera.target = {1.5, 0.25, 0};
  camera.azimuth = -std::numbers::pi / 2;
  camera.elevation = 0;
  camera.perspective = true;
  camera.half_height = 1.5;
  camera.field_of_view = 2 * std::atan(camera.half_height / 6);  // the eye is 6 away
  return camera;
}

Eye::Eye(int the_columns, int the_rows)
    : columns(the_columns), rows(the_rows), view(eye_camera(), the_columns, the_rows) {}

Vec3 Eye::on_plane(const Vec2& pixel) const {
  const View::ViewingRay line = view.viewing_ray(pixel);
  Vec3 p = line.origin + (plane_x - line.origin.x()) / line.direction.x() * line.direction;
  p.x() = plane_x;
  return p;
}

Vec2 Eye::pixel(const Vec3& p) const { return view.project({plane_x, p.y(), p.z()}).at; }

void add(const Object& object, Scene& scene, bool lit) {
  const Role role = lit ? object.role : Role::muted;
  std::visit(Match{[&](const Sphere3& s) {
                     scene.items.emplace_back(Ball{s.center, s.radius, role});
                   },
                   [&](const Box3& b) { scene.items.emplace_back(solid(b, role)); },
                   [&](const Ring3& r) {
                     scene.items.emplace_back(
                         Region{.rings = {r}, .role = role == Role::muted ? Role::grid : role, .hides = true});
                   },
                   [&](const Triangles& all) { scene.items.emplace_back(body(all, role)); }},
             object.shape);
}

std::string short_name(const Object& object) {
  const std::string name = object.name;
  return name.substr(name.find(' ') + 1);  // npos + 1 = 0: all of it
}

void add_name(const Object& object, Scene& scene) {
  const Box3 box = bounds(object.shape);
  const std::string label = short_name(object);
  if (std::holds_alternative<Ring3>(object.shape)) {
    scene.items.emplace_back(Label{{box.hi.x(), box.hi.y(), box.hi.z()}, label, object.role});
  } else {
    const Vec3 top = {(box.lo.x() + box.hi.x()) / 2, box.hi.y(), (box.lo.z() + box.hi.z()) / 2};
    scene.items.emplace_back(Label{top, label, object.role});
  }
}

void add(const Eye& eye, Scene& scene) {
  const double w = eye.columns, h = eye.rows;
  std::vector<Vec3> frame;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(w, 0), Vec2(w, h), Vec2(0, h)}) frame.push_back(eye.on_plane(corner));
  for (const Vec3& corner : frame)
    scene.items.emplace_back(Line{Eye::eye_point(), corner, Role::construction, Pen::hairline});
  scene.items.emplace_back(Region{.rings = {frame}, .role = Role::muted});
  scene.items.emplace_back(Dot{Eye::eye_point(), Mark::disc, Role::first});
  scene.items.emplace_back(Label{Eye::eye_point(), "eye", Role::first});
}

Raster picture(const Eye& eye, std::vector<Cell> cells, const Vec3& center, double height) {
  const View outside(from_outside(), 1, 1);  // for its axes only
  Raster raster;
  raster.columns = eye.columns;
  raster.across = height * eye.columns / eye.rows * outside.right(), raster.down = -height * outside.up();
  raster.corner = center - raster.across / 2 - raster.down / 2;
  raster.cells = std::move(cells);
  return raster;
}

Vec3 on_picture(const Raster& raster, const Eye& eye, const Vec2& pixel) {
  return raster.corner + pixel.x() / eye.columns * raster.across + pixel.y() / eye.rows * raster.down;
}

Camera from_outside() { return {.azimuth = -0.5, .elevation = 0.6}; }

}  // namespace isect::lessons::viewing
