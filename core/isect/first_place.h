#pragma once
// Where a ray, a line or a segment first meets a shape, as the number itself (isect/numbers/place.h): it orders hits
// whose doubles do not tell them apart. All of it runs in exact numbers, for the few that are to be told apart; each
// pair's own header says first whether they meet, and where to an ulp or two.
//
// A convex set holds the part of a line between the greatest of some places and the least of others: a half-space gives
// one place, -(n.o + d) / n.d, a ball or an endless cylinder a root of each kind; one half of a double cone, through
// whose inside a line passes, one root. A capsule is the balls around its ends and the part of a cylinder between them;
// a set made of several is met where the first of them is. For a polygon, isect/ray_outline.h says what is met first in
// its plane, and its plane is crossed at one quotient.
//
// Source: Cyrus, Beck, Generalized two- and three-dimensional clipping, Computers & Graphics 3 (1978).

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <isect/line_triangle.h>
#include <isect/numbers/place.h>
#include <isect/parts/round_solid.h>
#include <isect/ray_capsule.h>

namespace isect {

namespace detail::first_place {

using Exact3 = Components<Exact, 3>;

/// A line, with its direction in exact numbers.
struct Course {
  Point<double, 3> origin;
  Exact3 direction;
  Interval<double> range;

  template <bool ends>
  Course(const Straight<3, ends>& line)
      : origin(line.origin), direction(line.template along<Exact>()), range(line.range) {}
};

/// The part of the line in a convex set: from the greatest of `from` to the least of `to`.
struct Chord {
  std::vector<Place> from, to;
  bool none = false;
};

/// Cuts the chord to num + rate t >= 0; that is 0 at t = -num / rate.
inline void cut(Chord& chord, const Exact& num, const Exact& rate) {
  if (rate.sign() == 0)
    chord.none |= num.sign() < 0;
  else
    (rate.sign() > 0 ? chord.from : chord.to).push_back(quotient_at(-num, rate));
}

/// Cuts the chord to a t^2 + 2 b t + c <= 0; a >= 0, and b = 0 where a is.
inline void cut_by_roots(Chord& chord, const Quadratic<Exact>& f) {
  chord.none |= f.a.sign() == 0 ? f.c.sign() > 0 : f.discriminant.sign() < 0;
  if (chord.none || f.a.sign() == 0) return;
  chord.from.push_back({-f.b, f.a, -1, f.discriminant});
  chord.to.push_back({-f.b, f.a, 1, f.discriminant});
}

/// Cuts the chord to a t^2 + 2 b t + c <= 0 in the half of a double cone that the line enters iff `rate` is above 0.
inline void cut_by_roots_of_half(Chord& chord, const Quadratic<Exact>& f, const Exact& rate) {
  if (f.a.sign() > 0) return cut_by_roots(chord, f);
  if (f.a.sign() == 0) return cut(chord, -f.c, Exact(-2.0) * f.b);
  if (rate.sign() > 0)
    chord.from.push_back({f.b, -f.a, 1, f.discriminant});
  else
    chord.to.push_back({f.b, -f.a, -1, f.discriminant});
}

inline Chord chord_of(const Course& line, const HalfSpaces& solid) {
  Chord chord;
  for (const half_spaces::Face& face : solid.faces) {
    const inequalities::Row<Exact> row = half_spaces::detail::row<Exact>(face);
    const Exact3 n = inequalities::detail::normal(row);
    cut(chord, dot(n, exactly<Exact>(line.origin)) + row[3], dot(n, line.direction));
  }
  return chord;
}

/// Cuts the chord to n.x + w = 0, for x of the line; n.x + w is num + rate t.
inline void cut_by_plane(Chord& chord, const Exact& num, const Exact& rate) {
  cut(chord, num, rate), cut(chord, -num, -rate);
}

/// Returns the part that the line has in common with another one; if that is a point, its place.
inline Chord chord_of(const Course& line, const Course& other) {
  const Exact3 f = difference<Exact>(line.origin, other.origin), &d = other.direction;
  Chord chord;
  const Exact3 num = cross(d, f), rate = cross(d, line.direction);  // f + t u is parallel to d
  for (std::size_t i = 0; i < 3; ++i) cut_by_plane(chord, num[i], rate[i]);
  const Exact length = dot(d, d), along = dot(f, d), speed = dot(line.direction, d);
  if (length.sign() == 0) {  // a point: then f + t u is 0
    for (std::size_t i = 0; i < 3; ++i) cut_by_plane(chord, f[i], line.direction[i]);
    return chord;
  }
  if (std::isfinite(other.range.lo)) cut(chord, along - Exact(other.range.lo) * length, speed);
  if (std::isfinite(other.range.hi)) cut(chord, Exact(other.range.hi) * length - along, -speed);
  return chord;
}

/// The first place of a chord in the range, if there is one.
inline std::optional<Place> first_of(Chord chord, const Interval<double>& range) {
  if (chord.none || !ray_range::has_points(range)) return {};
  if (std::isfinite(range.lo)) chord.from.push_back(place_at(range.lo));
  if (std::isfinite(range.hi)) chord.to.push_back(place_at(range.hi));
  if (chord.from.empty()) return {};
  const auto less = [](const Place& x, const Place& y) { return compare(x, y) < 0; };
  const Place& first = *std::ranges::max_element(chord.from, less);
  const auto ends_before = [&](const Place& end) { return compare(end, first) < 0; };
  if (std::ranges::any_of(chord.to, ends_before)) return {};
  return first;
}

template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const HalfSpaces& solid) {
  return first_of(chord_of(line, solid), line.range);
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Sphere<double, 3>& ball) {
  if (empty(ball) || !finite(ball)) return {};
  Chord chord;
  cut_by_roots(chord, ray_capsule::detail::ball<Exact, 3>(line, ball.center, ball.radius));
  return first_of(chord, line.range);
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Capsule<double, 3>& capsule) {
  if (empty(capsule) || !finite(capsule)) return {};
  std::optional<Place> first;
  if (capsule.p != capsule.q) {
    Chord side;
    cut_by_roots(side, ray_capsule::detail::cylinder<Exact, 3>(line, capsule));
    const Exact3 v = difference<Exact>(capsule.q, capsule.p), f = difference<Exact>(line.origin, capsule.p);
    const Exact along = dot(f, v), rate = dot(line.template along<Exact>(), v);
    cut(side, along, rate);
    cut(side, dot(v, v) - along, -rate);
    first = first_of(side, line.range);
  }
  for (const Point<double, 3>& end : {capsule.p, capsule.q}) {
    std::optional<Place> found = first_in(line, Sphere<double, 3>{end, capsule.radius});
    if (found && (!first || compare(*found, *first) < 0)) first = std::move(found);
  }
  return first;
}
/// Finds the first place in a cylinder or a cone: between the planes of its ends only its side counts.
template <bool ends, class Solid>
requires requires(Solid solid) { round_solid::discs(solid); }
std::optional<Place> first_in(const Straight<3, ends>& line, const Solid& solid) {
  if (!round_solid::exists(solid)) return {};
  const Exact3 d = round_solid::axis<Exact>(solid), u = line.template along<Exact>();
  const Exact3 f = difference<Exact>(line.origin, round_solid::start(solid));
  const Exact along = dot(f, d), rate = dot(u, d);
  Chord chord;
  cut(chord, along, rate);
  cut(chord, dot(d, d) - along, -rate);
  const Exact a = round_solid::form(solid, u, u), b = round_solid::form(solid, f, u), c = round_solid::beside(solid, f);
  cut_by_roots_of_half(chord, {a, b, c, b * b - a * c}, rate);
  return first_of(chord, line.range);
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Plane<double, 3>& plane) {
  if (!finite(plane) || plane.normal.isZero(0)) return {};
  const half_spaces::Level level = plane;
  return first_in(line, HalfSpaces{{{level, false}, {level, true}}});
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Point<double, 3>& point) {
  return first_in(line, half_spaces_of(Aabb<double, 3>{point, point}));
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Triangle<double, 3>& triangle) {
  if (!finite(triangle)) return {};
  return first_in(line, triangle_half_spaces::detail::solid_of(triangle, 3, NoTrace()));
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Segment<double, 3>& segment) {
  return first_in(line, half_spaces_of(segment));
}
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Ray<double, 3>& other) {
  if (!finite(other) || !ray_range::has_points(other.range)) return {};
  return first_of(chord_of(line, Course(straight(other))), line.range);
}
template <bool ends>
std::optional<Place> first_in(const Straight<2, ends>& line, const Polygon<double, 2>& polygon) {
  const std::span<const Ring<double, 2>> rings = polygon.rings;
  if (!ray_outline::detail::all_finite(rings) || !ray_range::has_points(line.range)) return {};
  return ray_outline::detail::first(
      line, rings, FillRule::even_odd, NoTrace(),
      [&] { return place_at(std::isfinite(line.range.lo) ? line.range.lo : ray_range::clamped(0.0, line.range)); },
      [](const auto& t) {
        const Ratio<Exact> r = t.template operator()<Exact>();
        return quotient_at(r.num, r.den);
      });
}

inline Ray<double, 3> as_given(const Straight<3, false>& line) { return {line.origin, line.heading, line.range}; }
inline Segment<double, 3> as_given(const Straight<3, true>& line) { return {line.origin, line.heading}; }
/// Finds the first place in a polygon: where its plane is crossed, or within the plane.
template <bool ends>
std::optional<Place> first_in(const Straight<3, ends>& line, const Polygon<double, 3>& polygon) {
  if (!first_hit(as_given(line), polygon)) return {};
  const Ring<double, 3>& outline = polygon.rings[0];
  const Exact3 n = segment_polygon::detail::normal<Exact>(outline);
  const Exact rate = dot(n, line.template along<Exact>());
  if (rate.sign() != 0) return quotient_at(dot(n, difference<Exact>(outline[0], line.origin)), rate);
  using namespace ray_outline::detail;
  const int axis = segment_polygon::detail::steepest(outline);
  return first_in(straight(flattened(as_given(line), axis)), flattened<double>(polygon.rings, axis));
}

}  // namespace detail::first_place

/// The least t at which a ray, a line or a segment with both ends as given meets a shape: half-spaces, a ball, a
/// capsule, a cylinder, a cone, a plane, a point, a triangle, a segment, another ray or line; in the plane a polygon,
/// by the even-odd rule.
///
/// Exact, for all finite input of any magnitude. Where the range begins in the shape, it is where the range begins.
/// Nothing where they have no point in common, where a line comes from infinity in the shape, and, except for a
/// polygon, where a line without direction begins nowhere. An empty shape, NaN or an infinite coordinate: nothing.
template <int N, class Shape>
std::optional<Place> first_place(const Ray<double, N>& ray, const Shape& shape) {
  if (!finite(ray)) return {};
  return detail::first_place::first_in(straight(ray), shape);
}
template <int N, class Shape>
std::optional<Place> first_place(const Segment<double, N>& segment, const Shape& shape) {
  if (!finite(segment)) return {};
  return detail::first_place::first_in(straight(segment), shape);
}

}  // namespace isect
