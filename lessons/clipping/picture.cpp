#include "lessons/clipping/picture.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

Box box_of(const Parameters& values) {
  Box box = box_of_lesson();
  if (const auto lo = values.find("b_min"); lo != values.end()) box.lo = std::get<Vec3>(lo->second).head<2>();
  if (const auto hi = values.find("b_max"); hi != values.end()) box.hi = std::get<Vec3>(hi->second).head<2>();
  return box;
}

void add_grips(const Box& box, Scene& scene) {
  const Vec3 lo = flat(box.lo), hi = flat(box.hi), middle = lo / 2 + hi / 2;
  for (const Side side : {Side{0, false}, Side{0, true}, Side{1, false}, Side{1, true}}) {
    const std::string corner = side.upper ? "b_max" : "b_min";
    Vec3 at = middle;
    at[side.axis] = (side.upper ? hi : lo)[side.axis];
    scene.handles.push_back({.parameter = corner,
                             .kind = Handle::Kind::on_line,
                             .at = at,
                             .role = Role::second,
                             .direction = Vec3::Unit(side.axis),
                             .one_of = "a side of the box",
                             .axis = side.axis,
                             .name = corner + (side.axis == 0 ? ".x" : ".y")});
  }
  scene.handles.push_back({.parameter = "b_min",
                           .kind = Handle::Kind::shift,
                           .at = middle,
                           .anchor = middle - lo,
                           .role = Role::second,
                           .one_of = "the box",
                           .with = {"b_max"},
                           .name = "box"});
}

bool runs_along_a_side(const Segment<double, 2>& s, const Box& box) {
  for (int i = 0; i < 2; ++i)
    if (s.p[i] == s.q[i] && (s.p[i] == box.lo[i] || s.p[i] == box.hi[i])) return true;
  return false;
}

std::string name_of(const Side& s) {
  if (s.axis == 0) return s.upper ? "the right side" : "the left side";
  return s.upper ? "the top side" : "the bottom side";
}

Plane<double, 2> half_plane(const Side& s, const Box& box) {
  Vector<double, 2> n = Vector<double, 2>::Zero();
  n[s.axis] = s.upper ? -1 : 1;
  return {n, s.upper ? box.hi[s.axis] : -box.lo[s.axis]};
}

Region region(const Box& b) {
  Region r;
  r.rings = {corners(b)};
  return r;
}

void add_side(const Side& s, const Box& box, Scene& scene) {
  const int along = 1 - s.axis;
  const double beyond = 0.625;
  Point<double, 2> lo = box.lo, hi = box.hi;
  lo[s.axis] = hi[s.axis] = s.upper ? box.hi[s.axis] : box.lo[s.axis];
  Point<double, 2> from = lo, to = hi;
  from[along] -= beyond, to[along] += beyond;
  scene.items.emplace_back(Line{flat(from), flat(lo), Role::construction, Pen::construction});
  scene.items.emplace_back(Line{flat(hi), flat(to), Role::construction, Pen::construction});
  scene.items.emplace_back(Line{flat(lo), flat(hi), Role::highlight, Pen::highlight});
  const Vector<double, 2> inwards = half_plane(s, box).normal;  // at the dashed end, where the box's inside is free
  const Point<double, 2> foot = to, tip = foot + 0.75 * inwards;
  scene.items.emplace_back(Arrow{flat(foot), flat(tip), Role::text});
  scene.items.emplace_back(Label{flat(tip), "**n**", Role::text});
}

}  // namespace isect::lessons::clipping_lesson
