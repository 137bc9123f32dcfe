#include "lessons/ray_polygon/picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include <isect/methods/point_polygon.h>

#include "lessons/shared/axis_names.h"
#include "viz/compose/compose.h"
#include "viz/compose/small_multiples.h"

namespace isect::lessons::ray_polygon_lesson {

using namespace viz;

namespace {

Vec3 middle(const Setup& s) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : s.ring) sum += v;
  return sum / static_cast<double>(s.ring.size());
}

/// A part of the plane around the polygon.
Chain plane(const Setup& s) {
  const Vec3 c = middle(s), u = 1.5 * s.across, v = 1.375 * s.up;
  return {{c - u - v, c + u - v, c + u + v, c - u + v}, true, Role::construction, Pen::construction};
}

std::vector<Handle> handles(const Setup& s) {
  std::vector<Handle> all = {{"o", Handle::Kind::point, s.ray.origin, Vec3::Zero(), Role::first},
                             {"d", Handle::Kind::vector, s.ray.origin + s.ray.direction, s.ray.origin, Role::first}};
  for (std::size_t i = 0; i < s.ring.size(); ++i)
    all.push_back({.parameter = "p" + std::to_string(i),
                   .kind = Handle::Kind::plane,
                   .at = s.ring[i],
                   .role = Role::second,
                   .direction = s.across,
                   .one_of = "a corner",
                   .across = s.up});
  return all;
}

/// A point of a projection, on the plane that faces the camera.
Vec3 facing(const Point<double, 2>& p, double scale) {
  const View view(Camera{}, 1, 1);
  return scale * (p.x() * view.right() + p.y() * view.up());
}

/// Moves the drawing to the middle of the picture in space, so that the camera stands still.
std::vector<Item> centred(std::vector<Item> items, const Setup& s) {
  const View view(Camera{}, 1, 1);
  const Box2 own = extent(items, Camera{});
  const Box2 whole =
      extent(picture(s, {.normal = true, .plane = true, .settled = false}, s.across.cross(s.up)).items, Camera{});
  const Vec2 by = (whole.lo + whole.hi - own.lo - own.hi) / 2;
  return moved(std::move(items), by.x() * view.right() + by.y() * view.up());
}

Region outline(const Ring<double, 2>& ring, double scale) {
  Region region;
  region.rings.emplace_back();
  for (const Point<double, 2>& v : ring) region.rings[0].push_back(facing(v, scale));
  return region;
}

void ray(Scene& scene, const Setup& s, const Shown& shown) {
  const double t = s.truth.line.value_or(0), end = std::max({s.truth.line ? t + 0.875 : 3.25, 1.5});
  if (shown.plane && t < 0)
    scene.items.emplace_back(Line{s.ray.origin, s.ray.at(t - 0.25), Role::construction, Pen::construction});
  scene.items.emplace_back(Arrow{s.ray.origin, s.ray.at(end), Role::first, Pen::solid});
  scene.items.emplace_back(Label{s.ray.at(end), "**d**", Role::first});
}

void meeting(Scene& scene, const Setup& s, bool settled) {
  if (!s.truth.line) return;
  const Vec3 p = s.ray.at(*s.truth.line);
  Dot dot = {p, Mark::disc, Role::text};
  if (*s.truth.line < 0) dot = {p, Mark::excluded, Role::construction};
  if (settled && s.truth.t)
    dot = s.truth.location == Location::on ? Dot{p, Mark::diamond, Role::highlight} : Dot{p, Mark::disc, Role::hit};
  if (settled && !s.truth.t && *s.truth.line >= 0) dot = {p, Mark::no, Role::miss};
  scene.items.emplace_back(dot);
  scene.items.emplace_back(Label{p, "**r**(*t*)", dot.role == Role::construction ? Role::muted : Role::text});
}

}  // namespace

Setup setup(const Parameters& p) {
  Setup s;
  s.ray = {std::get<Vec3>(p.at("o")), std::get<Vec3>(p.at("d"))};
  const bool upright = std::get<std::string>(p.at("polygon")) == "upright";
  s.across = Vec3(1, 0, 0.5);
  s.up = upright ? Vec3(0, 1, 0) : Vec3(0.125, 1, -0.0625);
  const std::array<Vec2, corner_count> given = {{{-1.25, -1.0}, {1.0, -1.0}, {1.25, 1.0}, {0.125, 0.0}, {-1.0, 1.0}}};
  for (int i = 0; i < corner_count; ++i) {
    Vec2 at = given[i];
    constexpr double grid = 64;
    if (const auto moved = p.find("p" + std::to_string(i)); moved != p.end())
      at = (grid * std::get<Vec3>(moved->second).head<2>()).array().round() / grid;
    s.ring.emplace_back(at.x() * s.across + at.y() * s.up);
  }
  s.truth = intersect(s.ray, s.ring);
  return s;
}

Scene picture(const Setup& s, const Shown& shown, const Vec3& normal) {
  Scene scene;
  Region polygon;
  polygon.rings = {s.ring}, polygon.hides = true;
  scene.items.emplace_back(polygon);
  if (shown.plane) scene.items.emplace_back(plane(s));
  ray(scene, s, shown);
  if (shown.normal) {
    for (std::size_t i = 1; i < s.ring.size(); ++i)
      scene.items.emplace_back(Line{s.ring[0], s.ring[i], Role::construction, Pen::construction});
    scene.items.emplace_back(Dot{s.ring[0], Mark::disc, Role::second});
    scene.items.emplace_back(Label{s.ring[0], "**p**_0", Role::second});
    const Vec3 foot = s.center + 0.5 * s.across - 0.625 * s.up, tip = foot + 1.125 * normal.normalized();
    scene.items.emplace_back(Arrow{foot, tip, Role::second, Pen::solid});
    scene.items.emplace_back(Label{tip, "**n**", Role::second});
  }
  if (shown.plane) meeting(scene, s, shown.settled);
  scene.items.emplace_back(Dot{s.ray.origin, Mark::disc, Role::first});
  scene.items.emplace_back(Label{s.ray.origin, "**o**", Role::first});
  scene.handles = handles(s);
  return scene;
}

Flat flattened(const Setup& s, const Vec3& point, int dropped) {
  const auto flatten = [&](const Vec3& v) { return Point<double, 2>(v[(dropped + 1) % 3], v[(dropped + 2) % 3]); };
  Flat flat = {dropped, {}, flatten(point), false};
  for (const Vec3& v : s.ring) flat.ring.push_back(flatten(v));
  flat.inside = point_polygon::crossings_naive(flat.point, flat.ring);
  return flat;
}

Scene projections(const Setup& s, const Vec3& point, const Vec3& normal, int chosen) {
  constexpr double scale = 0.875;
  std::vector<Inset> insets;
  for (int axis = 0; axis < 3; ++axis) {
    const Flat flat = flattened(s, point, axis);
    Inset inset;
    inset.items = {outline(flat.ring, scale), Dot{facing(flat.point, scale), Mark::disc, Role::text}};
    inset.heading =
        fmt::format("{} dropped: ({}, {})", axis_names[axis], axis_names[(axis + 1) % 3], axis_names[(axis + 2) % 3]);
    inset.note = fmt::format("{}area {}", axis == chosen ? "largest " : "", shown(std::abs(normal[axis]) / 2));
    inset.role = axis == chosen ? Role::hit : Role::muted;
    insets.push_back(inset);
  }
  return arrangeable(insets, 3, Camera{}, [s](std::vector<Item> items) { return centred(std::move(items), s); });
}

Scene crossings(const Setup& s, const Flat& flat, const std::vector<Passing>& passing) {
  constexpr double scale = 1.25;
  Inset inset;
  inset.items.emplace_back(outline(flat.ring, scale));
  double right = flat.point.x();
  for (const Point<double, 2>& v : flat.ring) right = std::max(right, v.x());
  const auto at = [&](double x) { return facing({x, flat.point.y()}, scale); };
  inset.items.emplace_back(Arrow{at(flat.point.x()), at(right + 0.375), Role::first, Pen::construction});
  int count = 0;
  for (const Passing& p : passing) {
    inset.items.emplace_back(
        Dot{at(p.x), p.counted ? Mark::disc : Mark::uncounted, p.counted ? Role::hit : Role::muted});
    if (p.counted) inset.items.emplace_back(Label{at(p.x), std::to_string(++count), Role::text});
  }
  inset.items.emplace_back(Dot{at(flat.point.x()), Mark::disc, Role::first});
  inset.items.emplace_back(Label{at(flat.point.x()), "**r**′", Role::first});
  inset.heading = fmt::format("{} dropped: {} right, {} up", axis_names[flat.dropped],
                              axis_names[(flat.dropped + 1) % 3], axis_names[(flat.dropped + 2) % 3]);
  inset.note = fmt::format("{} on the right: {}", count, flat.inside ? "IN" : "OUT");
  Scene scene;
  scene.items = centred(small_multiples({inset}, 1, Camera{}), s);
  return scene;
}

}  // namespace isect::lessons::ray_polygon_lesson
