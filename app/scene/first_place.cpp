#include "app/scene/first_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <isect/half_spaces.h>
#include <isect/numbers/predicate.h>
#include <isect/triangle_half_spaces.h>

#include "app/scene/in_plane.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;
using Exact3 = Components<Exact, 3>;

/// A ray, a line or a segment with both its ends as given.
struct Course {
  Point<double, 3> origin;
  Exact3 direction;
  Interval<double> range;
};

Course course_of(const Setting& s, const Object& o) {
  if (o.type == Type::segment) {
    const Vec3 from = s.point(o, "from");
    return {from, difference<Exact>(s.point(o, "to"), from), {0, 1}};
  }
  Course along = {s.point(o, "origin"), exactly<Exact>(s.point(o, "dir")), {0, HUGE_VAL}};
  if (o.type == Type::line) along.range.lo = -HUGE_VAL;
  if (s.has(o, "tmin")) along.range.lo = s.number(o, "tmin");
  if (s.has(o, "tmax")) along.range.hi = s.number(o, "tmax");
  return along;
}

/// What of the line lies in a convex set: from the greatest of `from` to the least of `to`.
struct Chord {
  std::vector<Place> from, to;
  bool none = false;
};

/// -num / rate is where num + rate t is 0; the chord is where that is not negative.
void cut(Chord& chord, const Exact& num, const Exact& rate) {
  if (rate.sign() == 0)
    chord.none |= num.sign() < 0;
  else
    (rate.sign() > 0 ? chord.from : chord.to).push_back(quotient_at(-num, rate));
}

/// The chord is where a t^2 + 2 b t + c <= 0, a >= 0, and b = 0 where a is.
void cut_by_roots(Chord& chord, const Exact& a, const Exact& b, const Exact& c) {
  const Exact square = b * b - a * c;
  chord.none |= a.sign() == 0 ? c.sign() > 0 : square.sign() < 0;
  if (chord.none || a.sign() == 0) return;
  chord.from.push_back({-b, a, -1, square});
  chord.to.push_back({-b, a, 1, square});
}

Chord chord_of(const Course& line, const HalfSpaces& solid) {
  Chord chord;
  for (const half_spaces::Face& face : solid.faces) {
    const inequalities::Row<Exact> row = half_spaces::detail::row<Exact>(face);
    const Exact3 n = inequalities::detail::normal(row);
    cut(chord, dot(n, exactly<Exact>(line.origin)) + row[3], dot(n, line.direction));
  }
  return chord;
}

Chord chord_of_ball(const Course& line, const Vec3& center, double radius) {
  const Exact3 f = difference<Exact>(line.origin, center);
  Chord chord;
  cut_by_roots(chord, dot(line.direction, line.direction), dot(f, line.direction),
               dot(f, f) - Exact(radius) * Exact(radius));
  return chord;
}

/// A capsule is the ball around p, the ball around q, and what of a cylinder lies between them.
std::vector<Chord> chords_of_capsule(const Course& line, const Vec3& p, const Vec3& q, double radius) {
  const Exact3 v = difference<Exact>(q, p), f = difference<Exact>(line.origin, p);
  const Exact3 e = cross(line.direction, v), g = cross(f, v);
  Chord round;
  cut_by_roots(round, dot(e, e), dot(e, g), dot(g, g) - Exact(radius) * Exact(radius) * dot(v, v));
  const Exact along = dot(f, v), rate = dot(line.direction, v);
  cut(round, along, rate);
  cut(round, dot(v, v) - along, -rate);
  return {chord_of_ball(line, p, radius), chord_of_ball(line, q, radius), round};
}

/// Of a point, its place; of a line the part that both have in common.
Chord chord_of_course(const Course& line, const Course& other) {
  const Exact3 f = difference<Exact>(line.origin, other.origin);
  Chord chord;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = Vec3::Unit(i);
    const Exact3 n = cross(other.direction, exactly<Exact>(axis));
    const Exact num = dot(n, f), rate = dot(n, line.direction);
    cut(chord, num, rate);
    cut(chord, -num, -rate);
  }
  const Exact length = dot(other.direction, other.direction), along = dot(f, other.direction),
              rate = dot(line.direction, other.direction);
  if (std::isfinite(other.range.lo)) cut(chord, along - Exact(other.range.lo) * length, rate);
  if (std::isfinite(other.range.hi)) cut(chord, Exact(other.range.hi) * length - along, -rate);
  return chord;
}
Chord chord_of_point(const Course& line, const Vec3& p) {
  return chord_of(line, half_spaces_of(Aabb<double, 3>{p, p}));
}

HalfSpaces half_spaces_of_any(const Triangle<double, 3>& x) {
  if (!triangle_half_spaces::detail::degenerate(x, NoTrace())) return half_spaces_of(x);
  const Capsule<double, 3> edge = triangle_half_spaces::detail::as_segment(x, NoTrace());
  return half_spaces_of(Segment<double, 3>{edge.p, edge.q});
}

/// The first point of a chord in the range, if there is one.
std::optional<Place> first_point(const Course& line, Chord chord) {
  if (chord.none) return {};
  if (std::isfinite(line.range.lo)) chord.from.push_back(place_at(line.range.lo));
  if (std::isfinite(line.range.hi)) chord.to.push_back(place_at(line.range.hi));
  const auto less = [](const Place& x, const Place& y) { return compare(x, y) < 0; };
  if (chord.from.empty()) return {};
  const Place& first = *std::ranges::max_element(chord.from, less);
  const auto ends_before = [&](const Place& end) { return compare(end, first) < 0; };
  if (std::ranges::any_of(chord.to, ends_before)) return {};
  return first;
}

std::optional<Place> first_point(const Course& line, const std::vector<Chord>& chords) {
  std::optional<Place> first;
  for (const Chord& chord : chords)
    if (std::optional<Place> found = first_point(line, chord); found && (!first || compare(*found, *first) < 0))
      first = std::move(found);
  return first;
}

/// In the plane of the outline, or where it crosses that, inside as it is known to be.
std::optional<Place> first_in_outline(const Course& line, const Ring<double, 3>& outline) {
  const auto [num, den] = crossing_of_plane(line.origin, line.direction, outline);
  if (den.sign() != 0) return quotient_at(num, den);
  return place_in_plane(line.origin, line.direction, line.range, outline);
}

/// Of an outline that is met, its place there.
std::optional<Place> place_of(const Setting& s, const Course& line, const Object& o) {
  switch (o.type) {
    case Type::plane: {
      const half_spaces::Level level = {s.point(o, "normal"), s.number(o, "d")};
      return first_point(line, chord_of(line, {{{level, false}, {level, true}}}));
    }
    case Type::sphere:
      return first_point(line, chord_of_ball(line, s.point(o, "center"), s.number(o, "radius")));
    case Type::capsule:
      return first_point(line, chords_of_capsule(line, s.point(o, "p"), s.point(o, "q"), s.number(o, "r")));
    case Type::point:
      return first_point(line, chord_of_point(line, s.point(o, "at")));
    case Type::cloud: {
      std::vector<Chord> chords;
      for (const Vec3& p : s.points(o)) chords.push_back(chord_of_point(line, p));
      return first_point(line, chords);
    }
    case Type::ray:
    case Type::line:
      return first_point(line, chord_of_course(line, course_of(s, o)));
    case Type::segment:
      return first_point(line,
                         chord_of(line, half_spaces_of(Segment<double, 3>{s.point(o, "from"), s.point(o, "to")})));
    case Type::box:
    case Type::obb:
    case Type::kdop:
    case Type::frustum:
    case Type::hull:
      return first_point(line, chord_of(line, faces_of(s, o)));
    case Type::mesh: {
      std::vector<Chord> chords;
      const TriangleMesh<double> mesh = mesh_of(o);
      for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
        chords.push_back(chord_of(line, half_spaces_of_any(triangle(mesh, i))));
      return first_point(line, chords);
    }
    case Type::triangle:
    case Type::polygon: {
      if (s.flat) {
        std::vector<Ring<double, 2>> rings;
        for (const std::vector<Vec3>& ring : s.rings(o)) rings.push_back(points_of<2>(ring));
        return place_in_plane(line.origin.head<2>(), {line.direction[0], line.direction[1]}, line.range, rings);
      }
      if (o.type == Type::triangle) return first_point(line, chord_of(line, half_spaces_of_any(triangle_of(s, o))));
      if (is_bent(s, o)) {
        std::vector<Chord> chords;
        for (const Triangle<double, 3>& x : surface_of(s, o)) chords.push_back(chord_of(line, half_spaces_of_any(x)));
        return first_point(line, chords);
      }
      return first_in_outline(line, points_of<3>(s.rings(o).front()));
    }
  }
  return {};
}

}  // namespace

std::optional<Place> first_place(const Setting& s, const Object& along, const Object& o) {
  const Course line = course_of(s, along);
  const bool outline = o.type == Type::triangle || o.type == Type::polygon;
  if (outline && dot(line.direction, line.direction).sign() == 0) return place_at(line.range.lo);
  return place_of(s, line, o);
}

}  // namespace isect::program::scene
