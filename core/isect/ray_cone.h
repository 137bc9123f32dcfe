#pragma once
// Ray, segment or line against cone: whether they meet, and which part of the one lies in the other.
//
// Between the apex and the plane of the base the cone is all points whose distance from the axis is at most r / |d|
// times its height over the apex: with d leading from there to the center of the base, f to the ray's origin, and u
// along the ray, that is where
//
//   d.d |(f + t u) x d|^2 <= r^2 ((f + t u).d)^2,
//
// a quadratic inequality in t, which the other half of the double cone obeys, too: between the planes there is none of
// it. Which part of the range lies there, and how it and the roots lie to each other, isect/parts/ray_round.h finds by
// signs alone: no division, no square root. Source: Eberly, Intersection of a Line and a Cone (2000),
// geometrictools.com.

#include <optional>

#include <isect/parts/ray_round.h>

namespace isect {

namespace ray_cone {

using ray_round::Limit, ray_round::Side, ray_round::Stop, ray_round::Event;

}  // namespace ray_cone

/// Whether a point of the ray's range lies in the cone. Exact, for all finite input; touching counts. A zero
/// direction makes the ray a point. An empty range, an empty cone, NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Ray<S, 3>& ray, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cone) || !ray_range::has_points(ray.range)) return false;
  return ray_round::detail::meets(straight(ray), in_doubles(cone), trace);
}
/// Whether a point of the segment, with both ends as given, lies in the cone; otherwise as for a ray.
template <class S, class Trace = NoTrace>
bool intersects(const Segment<S, 3>& segment, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cone)) return false;
  return ray_round::detail::meets(straight(segment), in_doubles(cone), trace);
}

/// The part of the ray's range inside the closed cone, in units of |direction|.
///
/// Whether there is one is true for all finite input of any magnitude; touching counts. Each end is the range's where
/// that lies in the cone; else within 2 ulp of S of where the line truly enters or leaves by a flat end, and within
/// 0.6 ulp by the side (and a unit of the least subnormal number where it is subnormal), in the range, in order;
/// infinite beyond the largest S. Radius 0 makes the cone a segment. A zero direction makes the ray a point: the
/// whole range if it lies in the cone. An empty range, an empty cone, NaN or an infinite coordinate: nothing.
template <class S, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, 3>& ray, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cone) || !ray_range::has_points(ray.range)) return {};
  return ray_round::detail::part_in<S>(straight(ray), in_doubles(cone), ray.range, trace);
}
/// The t of [0, 1] at which the segment, with both ends as given, is in the closed cone; otherwise as for a ray.
template <class S, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Segment<S, 3>& segment, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cone)) return {};
  return ray_round::detail::part_in<S>(straight(segment), in_doubles(cone), {S(0), S(1)}, trace);
}

/// The first t of what `intersect` finds.
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Ray<S, 3>& ray, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cone) || !ray_range::has_points(ray.range)) return {};
  return ray_round::detail::first_in<S>(straight(ray), in_doubles(cone), ray.range, trace);
}
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Segment<S, 3>& segment, const Cone<S>& cone, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cone)) return {};
  return ray_round::detail::first_in<S>(straight(segment), in_doubles(cone), {S(0), S(1)}, trace);
}

}  // namespace isect
