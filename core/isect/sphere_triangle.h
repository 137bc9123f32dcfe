#pragma once
// Sphere and capsule against triangle in space.
//
// The triangle's point nearest to a center is the foot of the perpendicular, if that lies within, and else a point of
// an edge: each distance is compared with the radius squared and multiplied out. For a capsule it is the least of the
// distances of its segment from the three edges and of its two ends from the triangle, or 0 if the segment passes
// through. Source: Ericson, Real-Time Collision Detection (2005), 5.1.5 and 5.2.7.

#include <algorithm>
#include <functional>
#include <variant>

#include <isect/capsule_capsule.h>
#include <isect/parts/point_segment.h>
#include <isect/shapes.h>
#include <isect/trace.h>
#include <isect/triangle_half_spaces.h>

namespace isect {

namespace sphere_triangle {

using Event = std::variant<Fallback>;

namespace detail {

/// The sign of the distance of c from the triangle less r, by the foot of the perpendicular; 1 where that lies outside.
template <class Trace>
int by_foot(const Point<double, 3>& c, double r, const Triangle<double, 3>& x, Trace&& trace) {
  const Point<double, 3>&p = x.vertices[0], &q = x.vertices[1], &s = x.vertices[2];
  if (triangle_half_spaces::detail::degenerate(x, trace)) return 1;
  const auto beside = [&](const Point<double, 3>& a, const Point<double, 3>& b) {
    return sign_of<long_text>(
        [&]<class W>() -> W {
          const Components<W, 3> n = half_spaces::detail::normal<W>(p, q, s);
          return dot(cross(n, difference<W>(b, a)), difference<W>(c, a));
        },
        trace);
  };
  if (beside(p, q) < 0 || beside(q, s) < 0 || beside(s, p) < 0) return 1;
  return sign_of<long_text>(
      [&]<class W>() -> W {
        const Components<W, 3> n = half_spaces::detail::normal<W>(p, q, s);
        const W height = dot(n, difference<W>(c, p));
        return height * height - W(r) * W(r) * dot(n, n);
      },
      trace);
}

/// The sign of the distance of c from the triangle less r.
template <class Trace>
int compare(const Point<double, 3>& c, double r, const Triangle<double, 3>& x, Trace&& trace) {
  int least = by_foot(c, r, x, trace);
  for (std::size_t i = 0; i < 3 && least >= 0; ++i) {
    const Point<double, 3>&a = x.vertices[i], &b = x.vertices[(i + 1) % 3];
    const auto nearest = point_segment::detail::nearest<3>(c, a, b, trace);
    least = std::min(least, point_segment::detail::compare<3>(c, a, b, nearest, r, 0.0, std::plus<>(), trace));
  }
  return least;
}

/// Whether every corner is at most r away from the segment p q.
template <class Trace>
bool holds(const Capsule<double, 3>& capsule, const Triangle<double, 3>& x, Trace&& trace) {
  return std::ranges::all_of(x.vertices, [&](const Point<double, 3>& v) {
    const auto nearest = point_segment::detail::nearest<3>(v, capsule.p, capsule.q, trace);
    return point_segment::detail::compare<3>(v, capsule.p, capsule.q, nearest, capsule.radius, 0.0, std::plus<>(),
                                             trace) <= 0;
  });
}

/// The sign of the distance of the segment p q from the triangle less the radius.
template <class Trace>
int compare(const Capsule<double, 3>& capsule, const Triangle<double, 3>& x, Trace&& trace) {
  int least = std::min(compare(capsule.p, capsule.radius, x, trace), compare(capsule.q, capsule.radius, x, trace));
  for (std::size_t i = 0; i < 3 && least >= 0; ++i)
    least = std::min(
        least, capsule_capsule::detail::compare<3>(capsule, {x.vertices[i], x.vertices[(i + 1) % 3], 0.0}, trace));
  if (least <= 0 && (least < 0 || capsule.radius == 0)) return least;
  const bool through = intersects(Triangle<double, 3>{{capsule.p, capsule.q, capsule.q}}, x, trace);
  return through ? (capsule.radius > 0 ? -1 : 0) : least;
}

/// How a body with a volume (A) lies to a triangle; `reach`: the sign of a distance less a radius, `held`: A holds it.
inline Relation relation(int reach, bool held) {
  if (reach > 0) return Relation::disjoint;
  if (held) return Relation::b_inside_a;
  return reach == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace detail

}  // namespace sphere_triangle

/// How the ball (A) and the triangle lie. Exact; degenerate triangles are segments or points, and a ball of radius 0 is
/// a point. An empty ball, NaN or an infinite coordinate: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Sphere<S, 3>& sphere, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere) || !finite(triangle)) return Relation::disjoint;
  const Sphere<double, 3> ball = cast<double>(sphere);
  const Triangle<double, 3> x = cast<double>(triangle);
  const int reach = sphere_triangle::detail::compare(ball.center, ball.radius, x, trace);
  const bool held = reach <= 0 && sphere_triangle::detail::holds({ball.center, ball.center, ball.radius}, x, trace);
  if (ball.radius == 0 && reach <= 0) return held ? Relation::equal : Relation::a_inside_b;
  return sphere_triangle::detail::relation(reach, held);
}

/// Whether the ball and the triangle have a common point. Exact.
template <class S, class Trace = NoTrace>
bool intersects(const Sphere<S, 3>& sphere, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere) || !finite(triangle)) return false;
  const Sphere<double, 3> ball = cast<double>(sphere);
  return sphere_triangle::detail::compare(ball.center, ball.radius, cast<double>(triangle), trace) <= 0;
}

/// How the capsule (A) and the triangle lie; as for a ball. A capsule of radius 0 is a segment.
template <class S, class Trace = NoTrace>
Relation relate(const Capsule<S, 3>& capsule, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule) || !finite(triangle)) return Relation::disjoint;
  const Capsule<double, 3> wide = cast<double>(capsule);
  const Triangle<double, 3> x = cast<double>(triangle);
  if (wide.radius == 0)
    return relate(half_spaces_of(Segment<double, 3>{wide.p, wide.q}),
                  triangle_half_spaces::detail::solid_of(x, 3, trace), trace);
  const int reach = sphere_triangle::detail::compare(wide, x, trace);
  const bool held = reach <= 0 && sphere_triangle::detail::holds(wide, x, trace);
  return sphere_triangle::detail::relation(reach, held);
}

/// Whether the capsule and the triangle have a common point. Exact.
template <class S, class Trace = NoTrace>
bool intersects(const Capsule<S, 3>& capsule, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule) || !finite(triangle)) return false;
  return sphere_triangle::detail::compare(cast<double>(capsule), cast<double>(triangle), trace) <= 0;
}

}  // namespace isect
