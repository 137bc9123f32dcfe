#pragma once
// Pairs that isect/ask.h asks and no other header does: a plane and a plane, a capsule or corners; in the plane
// outlines of which one has no area, and a polygon of any form and a convex shape.

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <isect/capsule_capsule.h>
#include <isect/convex_hull.h>
#include <isect/plane_sphere.h>
#include <isect/point_plane.h>
#include <isect/point_polygon.h>
#include <isect/polygon_convex.h>
#include <isect/polygon_polygon.h>
#include <isect/segment_segment.h>
#include <isect/triangle_half_spaces.h>

namespace isect::ask_pairs {

namespace detail {

template <class X>
inline constexpr bool is_line = false;
template <class S, int N>
inline constexpr bool is_line<Segment<S, N>> = true;
template <class S, int N>
inline constexpr bool is_line<Ray<S, N>> = true;

template <class X>
inline constexpr bool is_round = false;
template <class S>
inline constexpr bool is_round<Cylinder<S>> = true;
template <class S>
inline constexpr bool is_round<Cone<S>> = true;

}  // namespace detail

/// Whether its numbers make a plane.
template <class S, int N>
bool exists(const Plane<S, N>& x) {
  return finite(x) && !x.normal.isZero(0);
}

/// How two planes lie: equal, disjoint and parallel, or overlapping, where they have a line in common, or a point in
/// 2D. Exact. Disjoint if one is no plane.
template <class S, int N>
Relation planes(const Plane<S, N>& a, const Plane<S, N>& b) {
  if (!exists(a) || !exists(b)) return Relation::disjoint;
  const auto row = [&]<class W>(const Plane<S, N>& x) -> Components<W, N + 1> {
    Components<W, N + 1> all;
    for (int i = 0; i < N; ++i) all[static_cast<std::size_t>(i)] = W(x.normal[i]);
    all[N] = W(x.d);
    return all;
  };
  bool parallel = true, equal = true;
  for (std::size_t i = 0; i < N && parallel; ++i)
    for (std::size_t j = i + 1; j <= N; ++j) {
      const bool dependent = sign_of([&]<class W>() -> W {
                               const auto m = row.template operator()<W>(a), n = row.template operator()<W>(b);
                               return m[i] * n[j] - m[j] * n[i];
                             }) == 0;
      (j < N ? parallel : equal) &= dependent;
    }
  return !parallel ? Relation::overlapping : equal ? Relation::equal : Relation::disjoint;
}

/// How the plane (A) and the capsule lie: as the plane and the balls around its ends do, unless it parts these. Exact.
template <class S, int N>
Relation plane_and_capsule(const Plane<S, N>& plane, const Capsule<S, N>& capsule) {
  const Relation p = relate(plane, Sphere<S, N>{capsule.p, capsule.radius}),
                 q = relate(plane, Sphere<S, N>{capsule.q, capsule.radius});
  if (empty(capsule) || !finite(capsule)) return Relation::disjoint;
  const bool cut =
      p == Relation::overlapping || q == Relation::overlapping || side(plane, capsule.p) * side(plane, capsule.q) < 0;
  if (cut) return Relation::overlapping;
  return p == Relation::touching || q == Relation::touching ? Relation::touching : Relation::disjoint;
}

/// Counts the corners behind the plane, in it and before it; all counts are 0 where something is not finite.
template <class S, int N>
Sides corners(const Plane<S, N>& plane, std::span<const Point<S, N>> points) {
  bool all_finite = exists(plane);
  for (const Point<S, N>& p : points) all_finite &= finite(p);
  return all_finite ? sides<S, N>(plane, points) : Sides();
}

/// Returns the segment, or the point, that a polygon of one ring without an area is.
template <class S>
std::optional<Segment<S, 2>> thin(const Polygon<S, 2>& x) {
  if (x.rings.size() != 1 || !polygon_polygon::detail::all_finite(x)) return {};
  const Ring<S, 2> hull = convex_hull(x.rings.front());
  if (hull.size() != 1 && hull.size() != 2) return {};
  return Segment<S, 2>{hull.front(), hull.back()};
}

/// How two outlines lie, by the even-odd rule. A polygon of one ring without an area is a segment or a point, with its
/// interior within the line that it spans. Exact.
template <class S>
Relation outlines(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  const std::optional<Segment<S, 2>> p = thin(a), q = thin(b);
  if (!p && !q) return relate(a, b);
  if (!p) return reversed(relate(*q, a));
  const Relation r = relate(*p, b);
  if (!q || r != Relation::touching) return r;
  const segment_segment::Meeting met = intersect(*p, *q).relation;
  const bool within = met == segment_segment::Meeting::cross || met == segment_segment::Meeting::overlap;
  return within ? Relation::overlapping : r;
}

/// How an outline lies to a capsule or half-spaces; nothing where these have no inside and the outline is no segment.
template <class S>
Relation outline_and(const Polygon<S, 2>& a, const Capsule<S, 2>& b) {
  if (const std::optional<Segment<S, 2>> segment = thin(a))
    return relate(Capsule<S, 2>{segment->p, segment->q, S(0)}, b);
  return relate(a, b);
}
template <class S>
std::optional<Relation> outline_and(const Polygon<S, 2>& a, const HalfSpaces& b) {
  if (const std::optional<Segment<S, 2>> segment = thin(a))
    return relate(Triangle<S, 2>{{segment->p, segment->q, segment->q}}, b);
  if (!half_spaces::detail::has_interior(b.faces, NoTrace())) return {};
  return relate(a, b);
}

/// Returns any triangle in space as half-spaces.
template <class S>
HalfSpaces solid_of(const Triangle<S, 3>& x) {
  if (!finite(x)) return {{half_spaces::detail::nothing()}};
  return triangle_half_spaces::detail::solid_of(cast<double>(x), 3, NoTrace());
}

/// A box that holds the shape, where one is quickly found.
template <class X>
std::optional<Aabb<double, 3>> around(const X&) {
  return {};
}
template <class S>
std::optional<Aabb<double, 3>> around(const Triangle<S, 3>& x) {
  const auto& [p, q, r] = x.vertices;
  return cast<double>(Aabb<S, 3>{p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)});
}
template <class S>
std::optional<Aabb<double, 3>> around(const Aabb<S, 3>& x) {
  return cast<double>(x);
}
template <class S>
std::optional<Aabb<double, 3>> around(const Capsule<S, 3>& x) {
  constexpr double all = std::numeric_limits<double>::infinity();
  const Capsule<double, 3> wide = cast<double>(x);
  Aabb<double, 3> box = {wide.p.cwiseMin(wide.q), wide.p.cwiseMax(wide.q)};
  for (int i = 0; i < 3; ++i)  // rounded outwards
    box.lo[i] = std::nextafter(box.lo[i] - wide.radius, -all), box.hi[i] = std::nextafter(box.hi[i] + wide.radius, all);
  return finite(box) ? std::optional(box) : std::nullopt;
}
template <class S>
std::optional<Aabb<double, 3>> around(const Sphere<S, 3>& x) {
  return around(Capsule<S, 3>{x.center, x.center, x.radius});
}
template <class S>
std::optional<Aabb<double, 3>> around(const Cylinder<S>& x) {
  return around(Capsule<S, 3>{x.p, x.q, x.radius});
}
template <class S>
std::optional<Aabb<double, 3>> around(const Cone<S>& x) {
  return around(Capsule<S, 3>{x.apex, x.base, x.radius});
}

}  // namespace isect::ask_pairs
