// Points, segments, rays, lines and planes.

#include <Eigen/Geometry>
#include <algorithm>

#include "app/scene/types/rows.h"
#include "lessons/shared/parameters.h"

namespace isect::program::scene {

namespace {

using lessons::unit;
using viz::Vec3;

void draw_segment(Drawing& d) {
  const Vec3 from = d.at("from"), to = d.at("to");
  d.items.push_back(viz::Line{from, to, d.role});
  d.dot(from);
  d.dot(to);
  d.name(from, to);
}

/// Draws a ray from its origin to beyond the scene, or to its end.
void draw_ray(Drawing& d) {
  const Vec3 origin = d.at("origin"), dir = d.at("dir");
  const double foot = (d.room.middle - origin).dot(dir) / dir.squaredNorm(), reach = 1.15 * d.room.reach / dir.norm();
  const bool ends = d.s.has(d.o, "tmax");
  const double from = d.s.has(d.o, "tmin") ? d.s.number(d.o, "tmin") : 0;
  const double to = ends ? d.s.number(d.o, "tmax") : std::max(foot, 0.0) + reach;
  const Vec3 a = origin + from * dir, b = origin + to * dir;
  if (ends)
    d.items.push_back(viz::Line{a, b, d.role});
  else
    d.items.push_back(viz::Arrow{a, b, d.role});
  if (ends) d.dot(b);
  d.named_dot(a);
}

/// Draws a line from before the scene to beyond it.
void draw_line(Drawing& d) {
  const Vec3 origin = d.at("origin"), dir = d.at("dir");
  const double foot = (d.room.middle - origin).dot(dir) / dir.squaredNorm(), reach = 1.15 * d.room.reach / dir.norm();
  const Vec3 a = origin + (foot - reach) * dir, b = origin + (foot + reach) * dir;
  d.items.push_back(viz::Line{a, b, d.role});
  d.name(a + 0.2 * (b - a), a + 0.3 * (b - a));
}

/// Returns the point of the plane that is nearest to the middle of the scene.
Vec3 middle_of_plane(const NamedValues& s, const Object& o, const Room& room) {
  const Vec3 n = s.point(o, "normal");
  return room.middle - (n.dot(room.middle) + s.number(o, "d")) / n.squaredNorm() * n;
}

/// Draws a square of the plane, in the plane a stretch of the line, about the middle of the scene.
void draw_plane(Drawing& d) {
  const Vec3 n = d.at("normal"), u = across(n, d.s.flat), v = unit(n.cross(u));
  const Vec3 p = middle_of_plane(d.s, d.o, d.room);
  const double r = 0.8 * d.room.reach;
  if (d.s.flat) {
    d.items.push_back(viz::Line{p - 1.2 * r * u, p + 1.2 * r * u, d.role});
    d.name(p - r * u, p - 0.8 * r * u);
    return;
  }
  viz::Region square;
  square.rings = {{p - r * u - r * v, p + r * u - r * v, p + r * u + r * v, p - r * u + r * v}};
  square.role = d.role, square.hides = true;
  d.items.push_back(square);
  d.name(p - r * u - r * v);
}

/// Adds the ends of its range, which keep their order.
void grip_ray(Grips& g) {
  const Vec3 origin = g.at("origin"), dir = g.at("dir"), rate = dir / dir.squaredNorm();
  const bool begins = g.s.has(g.o, "tmin"), ends = g.s.has(g.o, "tmax");
  const double from = begins ? g.s.number(g.o, "tmin") : 0, to = ends ? g.s.number(g.o, "tmax") : 1e300;
  if (begins) g.on_line("tmin", origin + from * dir, origin, rate).hi = to;
  if (ends) g.on_line("tmax", origin + to * dir, origin, rate).lo = from;
}

/// Adds its middle, which is moved along the normal, and the tip of the normal, which turns the plane about that.
void grip_plane(Grips& g) {
  const Vec3 n = g.at("normal"), middle = middle_of_plane(g.s, g.o, g.room);
  g.on_line("d", middle, Vec3::Zero(), -n);
  g.turn("normal", {"d"}, middle + 0.4 * g.room.reach * unit(n), middle);
}

}  // namespace

std::vector<TypeSpec> straight_types() {
  TypeSpec point = {Type::point, "point"};
  point.fields = {{"at", Means::place, "where it lies"}};
  point.extent = [](const NamedValues& s, const Object& o) { return std::vector{s.point(o, "at")}; };
  point.draw = [](Drawing& d) { d.named_dot(d.at("at")); };

  TypeSpec segment = row<Segment<double, 3>>(Type::segment);
  segment.extent = [](const NamedValues& s, const Object& o) {
    return std::vector{s.point(o, "from"), s.point(o, "to")};
  };
  segment.draw = draw_segment;
  segment.whole = {"from", "to"};

  TypeSpec ray = row<Ray<double, 3>>(Type::ray);
  ray.extent = [](const NamedValues& s, const Object& o) { return std::vector{s.point(o, "origin")}; };
  ray.draw = draw_ray;
  ray.vectors = {{"dir", "origin"}};
  ray.grips = grip_ray;

  TypeSpec line = {Type::line, "line"};
  line.fields = {ray.fields[0], ray.fields[1]};
  line.extent = [](const NamedValues&, const Object&) { return std::vector<Vec3>(); };
  line.draw = draw_line;
  line.vectors = ray.vectors;

  TypeSpec plane = row<Plane<double, 3>>(Type::plane);
  plane.extent = line.extent;
  plane.draw = draw_plane;
  plane.grips = grip_plane;
  return {point, segment, ray, line, plane};
}

}  // namespace isect::program::scene
