#pragma once
// Ray, segment or line against cylinder: whether they meet, and which part of the one lies in the other.
//
// Between the planes of its ends the cylinder is all that lies within r of its axis: with d = q - p, f leading from p
// to the ray's origin, and u along the ray, that is where
//
//   |(f + t u) x d|^2 <= r^2 d.d,
//
// a quadratic inequality in t. Which part of the range lies between the planes, and how it and the roots lie to each
// other, isect/parts/ray_round.h finds by signs alone: no division, no square root. Source: Ericson, Real-Time
// Collision Detection (2005), 5.3.7.

#include <optional>

#include <isect/parts/ray_round.h>

namespace isect {

namespace ray_cylinder {

using ray_round::Limit, ray_round::Side, ray_round::Stop, ray_round::Event;

}  // namespace ray_cylinder

/// Whether a point of the ray's range lies in the cylinder. Exact, for all finite input; touching counts. A zero
/// direction makes the ray a point. An empty range, an empty cylinder, NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Ray<S, 3>& ray, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cylinder) || !ray_range::has_points(ray.range)) return false;
  return ray_round::detail::meets(straight(ray), in_doubles(cylinder), trace);
}
/// Whether a point of the segment, with both ends as given, lies in the cylinder; otherwise as for a ray.
template <class S, class Trace = NoTrace>
bool intersects(const Segment<S, 3>& segment, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cylinder)) return false;
  return ray_round::detail::meets(straight(segment), in_doubles(cylinder), trace);
}

/// The part of the ray's range inside the closed cylinder, in units of |direction|.
///
/// Whether there is one is true for all finite input of any magnitude; touching counts. Each end is the range's where
/// that lies in the cylinder; else within 2 ulp of S of where the line truly enters or leaves by a flat end, and within
/// 0.6 ulp by the side (and a unit of the least subnormal number where it is subnormal), in the range, in order;
/// infinite beyond the largest S. Radius 0 makes the cylinder a segment. A zero direction makes the ray a point: the
/// whole range if it lies in the cylinder. An empty range, an empty cylinder, NaN or an infinite coordinate: nothing.
template <class S, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, 3>& ray, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cylinder) || !ray_range::has_points(ray.range)) return {};
  return ray_round::detail::part_in<S>(straight(ray), in_doubles(cylinder), ray.range, trace);
}
/// The t of [0, 1] at which the segment, with both ends as given, is in the closed cylinder; otherwise as for a ray.
template <class S, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Segment<S, 3>& segment, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cylinder)) return {};
  return ray_round::detail::part_in<S>(straight(segment), in_doubles(cylinder), {S(0), S(1)}, trace);
}

/// The first t of what `intersect` finds.
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Ray<S, 3>& ray, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(ray, cylinder) || !ray_range::has_points(ray.range)) return {};
  return ray_round::detail::first_in<S>(straight(ray), in_doubles(cylinder), ray.range, trace);
}
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Segment<S, 3>& segment, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!ray_round::detail::may_meet(segment, cylinder)) return {};
  return ray_round::detail::first_in<S>(straight(segment), in_doubles(cylinder), {S(0), S(1)}, trace);
}

}  // namespace isect
