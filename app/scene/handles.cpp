// What can be dragged of the objects of a scene.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/scene/types/rows.h"

namespace isect::program::scene {

namespace {

using viz::Handle;
using viz::Vec3;

/// Adds what the list of types tells: its places, the tips of its vectors, its radius.
void add_fields(Grips& g, const TypeSpec& type) {
  for (const FieldSpec& f : type.fields) {
    if (f.means == Means::place) g.add(f.name, Handle::Kind::point, g.s.point(g.o, f.name));
    for (const auto& [field, from] : type.vectors)
      if (f.name == field)
        g.add(field, Handle::Kind::vector, g.s.point(g.o, from) + g.s.point(g.o, field), g.s.point(g.o, from));
    if (f.means == Means::radius) {
      const auto [from, aside] = type.radius_at(g.s, g.o);
      g.add(f.name, Handle::Kind::length, from + g.s.number(g.o, f.name) * aside, from);
    }
  }
}

/// Returns the middle of the box around the points: it moves as they do.
Vec3 middle_of_box(const std::vector<Vec3>& points) {
  Vec3 lo = points.front(), hi = lo;
  for (const Vec3& p : points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  return lo / 2 + hi / 2;
}

/// Adds its points, unless they are fixed, and what moves all of them.
void add_points(Grips& g) {
  std::vector<std::string> fields;
  for (const std::string& field : g.o.fields)
    if (field != "at") fields.push_back(field);
  const bool given = g.s.has(g.o, "at"), moved = given || g.o.is_fixed();
  const Vec3 way = given ? g.at("at") : Vec3::Zero();
  for (const std::string& field : fields) {
    const Vec3 p = g.s.point(g.o, field);
    if (moved)
      g.add(field, Handle::Kind::shift, p + way, way);
    else
      g.add(field, Handle::Kind::point, p);
  }
  if (!moved) return g.whole(fields);
  std::vector<Vec3> points = g.o.fixed.points;
  for (const std::string& field : fields) points.push_back(g.s.point(g.o, field));
  const Vec3 middle = middle_of_box(points);
  g.add("at", Handle::Kind::shift, middle + way, middle).one_of = shown_name(g.o.name) + " as a whole";
}

}  // namespace

Handle& Grips::add(const std::string& field, Handle::Kind kind, const Vec3& place, const Vec3& anchor) {
  all.push_back({.parameter = o.name + "." + field, .kind = kind, .at = place, .anchor = anchor, .role = role});
  return all.back();
}

Handle& Grips::on_line(const std::string& field, const Vec3& place, const Vec3& anchor, const Vec3& direction) {
  Handle& handle = add(field, Handle::Kind::on_line, place, anchor);
  handle.direction = direction;
  return handle;
}

Handle& Grips::face(const std::string& field, int axis, const Vec3& place, const Vec3& anchor, const Vec3& direction) {
  Handle& handle = on_line(field, place, anchor, direction);
  handle.axis = axis;
  handle.name = handle.parameter + "." + "xyz"[axis];
  handle.one_of = fmt::format("a {} of {}", s.flat ? "side" : "face", shown_name(o.name));
  return handle;
}

void Grips::turn(const std::string& field, const std::vector<std::string>& with, const Vec3& place,
                 const Vec3& anchor) {
  Handle& handle = add(field, Handle::Kind::turn, place, anchor);
  for (const std::string& other : with) handle.with.push_back(o.name + "." + other);
}

void Grips::whole(const std::vector<std::string>& fields) {
  if (fields.size() < 2) return;
  std::vector<Vec3> points;
  for (const std::string& field : fields) points.push_back(s.point(o, field));
  const auto is_taken = [&](const Vec3& p) {
    const double near = 1e-3 * room.reach;
    return std::ranges::any_of(all, [&](const Handle& other) { return (other.at - p).norm() < near; });
  };
  Vec3 place = middle_of(points);
  if (is_taken(place)) place = points[0] / 2 + points[1] / 2;
  if (is_taken(place)) return;
  Handle& handle = add(fields[0], Handle::Kind::shift, place, place - points[0]);
  for (std::size_t i = 1; i < fields.size(); ++i) handle.with.push_back(o.name + "." + fields[i]);
  handle.name = o.name;
  handle.one_of = shown_name(o.name) + " as a whole";
}

std::vector<Handle> handles(const NamedValues& s, const Object& o, const Room& room, viz::Role role, HandlesOf which) {
  const TypeSpec& type = spec(o.type);
  Grips grips = {s, o, room, role};
  add_fields(grips, type);
  if (!type.whole.empty()) grips.whole(type.whole);
  if (!o.rings.empty()) add_points(grips);
  if (type.grips && which == HandlesOf::all) type.grips(grips);
  return std::move(grips.all);
}

}  // namespace isect::program::scene
