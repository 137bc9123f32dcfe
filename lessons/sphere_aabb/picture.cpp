#include "lessons/sphere_aabb/picture.h"

#include <cmath>
#include <numbers>

#include <isect/clip_polygon.h>
#include <isect/point_aabb.h>
#include "lessons/shared/axis_names.h"
#include "viz/solids.h"

namespace isect::lessons::sphere_aabb_lesson {

using namespace viz;

namespace {

Aabb<double, 3> grown(const Setup& s) {
  const Vec3 r = Vec3::Constant(s.ball.radius);
  return {s.box.lo - r, s.box.hi + r};
}

/// The part of the ball's section with one face's plane that lies in the face.
Ring<double, 3> patch(const Setup& s, int axis, double coordinate) {
  constexpr int corners = 96;
  const double h = coordinate - s.ball.center[axis], rest = s.ball.radius * s.ball.radius - h * h;
  if (!(rest > 0)) return {};
  Ring<double, 3> section;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    Vec3 p = s.ball.center;
    p[axis] = coordinate;
    p[(axis + 1) % 3] += std::sqrt(rest) * std::cos(angle);
    p[(axis + 2) % 3] += std::sqrt(rest) * std::sin(angle);
    section.push_back(p);
  }
  return clip(section, s.box);
}

/// Where the box's surface lies in the ball, or the one common point.
void shared(Scene& scene, const Setup& s) {
  if (s.truth == Relation::touching) scene.items.push_back(Dot{s.nearest(), Mark::disc, Role::hit});
  if (s.truth != Relation::overlapping) return;
  for (int axis = 0; axis < 3; ++axis)
    for (const double coordinate : {s.box.lo[axis], s.box.hi[axis]}) {
      const Ring<double, 3> part = patch(s, axis, coordinate);
      if (part.size() < 3) continue;
      Region region;
      region.rings = {part}, region.role = Role::hit;
      scene.items.push_back(region);
    }
}

/// The centre, moved to the box on the first `axes` axes.
Vec3 corner_of_way(const Setup& s, int axes) {
  Vec3 p = s.ball.center;
  for (int i = 0; i < axes; ++i) p[i] = s.nearest()[i];
  return p;
}

void way(Scene& scene, const Setup& s, const Shown& shown) {
  for (int axis = 0; axis < shown.legs; ++axis) {
    const Vec3 from = corner_of_way(s, axis), to = corner_of_way(s, axis + 1);
    if (from == to) continue;
    const bool now = shown.current && axis + 1 == shown.legs;
    scene.items.push_back(
        Line{from, to, now ? Role::highlight : Role::construction, now ? Pen::highlight : Pen::construction});
    if (shown.current) scene.items.push_back(Label{from, std::string("*g*_") + "xyz"[axis], Role::text, to});
  }
}

/// The box's interval on one axis and the centre's coordinate, drawn in front of the box like a ruler.
void ruler(Scene& scene, const Setup& s, int axis) {
  const auto at = [&](double t) {
    const double off = 0.4;
    Vec3 p = {s.box.lo.x() - off, s.box.lo.y(), s.box.hi.z() + off};  // y: beside the front left edge
    if (axis == 0) p = {0, s.box.lo.y() - off, s.box.hi.z() + off};
    if (axis == 2) p = {s.box.hi.x() + off, s.box.lo.y() - off, 0};
    p[axis] = t;
    return p;
  };
  const double lo = s.box.lo[axis], hi = s.box.hi[axis], c = s.ball.center[axis], near = s.nearest()[axis];
  scene.items.push_back(Span{at(lo), at(hi), Role::second, Pen::thick});
  if (c != near) scene.items.push_back(Line{at(near), at(c), Role::highlight, Pen::highlight});
  scene.items.push_back(Dot{at(c), Mark::disc, Role::first});
  scene.items.push_back(Label{at(c), std::string("*c*_") + "xyz"[axis], Role::first});
  scene.items.push_back(Label{at(c < lo ? hi : lo), axis_names[axis], Role::text});
}

void outline(Scene& scene, const Aabb<double, 3>& box) {
  const auto corner = [&](int i) {
    return Vec3((i & 1) != 0 ? box.hi.x() : box.lo.x(), (i & 2) != 0 ? box.hi.y() : box.lo.y(),
                (i & 4) != 0 ? box.hi.z() : box.lo.z());
  };
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if ((i & bit) == 0)
        scene.items.push_back(Line{corner(i), corner(i | bit), Role::construction, Pen::construction});
}

void distance(Scene& scene, const Setup& s) {
  const Vec3 c = s.ball.center, p = s.nearest();
  if (c != p) {
    scene.items.push_back(Line{c, p, Role::highlight, Pen::highlight});
    scene.items.push_back(Label{c, "*d*", Role::text, p});
  }
  const Vec3 rim = c + s.ball.radius * Vec3::UnitY();
  scene.items.push_back(Line{c, rim, Role::construction, Pen::construction});
  scene.items.push_back(Label{c, "*r*", Role::text, rim});
}

}  // namespace

int Setup::gaps() const { return static_cast<int>((ball.center.array() != nearest().array()).count()); }

int Setup::feature() const {
  if (gaps() == 0) return 0;
  const Vec3 p = nearest();
  return static_cast<int>((p.array() == box.lo.array() || p.array() == box.hi.array()).count());
}

Setup setup(const Parameters& p) {
  const auto vector = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  Setup s = {{vector("c"), std::get<double>(p.at("r"))}, {vector("b_min"), vector("b_max")}, {}, false};
  s.truth = relate(s.ball, s.box);
  s.in_grown = !empty(s.box) && locate(s.ball.center, grown(s)) != Location::out;
  return s;
}

Scene picture(const Setup& s, const Shown& shown) {
  Scene scene;
  const Vec3 c = s.ball.center;
  scene.items = {Ball{c, s.ball.radius, Role::first}, solid(s.box, Role::second)};
  if (shown.grown) {
    const Vec3 p = s.nearest(), rim = p + s.ball.radius * (c - p).normalized();
    outline(scene, grown(s));
    scene.items.push_back(Ball{p, s.ball.radius, Role::construction});
    scene.items.push_back(Line{p, rim, Role::highlight, Pen::highlight});
    scene.items.push_back(Label{p, "*r*", Role::text, rim});
  }
  if (!shown.settled && !shown.grown) way(scene, s, shown);
  if (shown.current) ruler(scene, s, shown.legs - 1);
  if (shown.settled) shared(scene, s), distance(scene, s);
  scene.items.push_back(Dot{c, Mark::disc, Role::first});
  scene.items.push_back(Label{c, "**c**", Role::first});
  if (shown.legs == 3 && !(shown.settled && s.truth == Relation::touching) && s.gaps() > 0)
    scene.items.push_back(Dot{s.nearest(), Mark::disc, Role::second});
  scene.handles = {{"c", Handle::Kind::point, c, Vec3::Zero(), Role::first},
                   {"r", Handle::Kind::length, c + s.ball.radius * Vec3::UnitY(), c, Role::first},
                   {"b_min", Handle::Kind::point, s.box.lo, Vec3::Zero(), Role::second},
                   {"b_max", Handle::Kind::point, s.box.hi, Vec3::Zero(), Role::second}};
  return scene;
}

}  // namespace isect::lessons::sphere_aabb_lesson
