#pragma once
// Ray against polygon in space in the note's way, and by a fan of triangles: for lessons and comparison. `intersect` in
// isect/ray_polygon.h is right for all input.

#include <optional>
#include <variant>

#include <isect/methods/point_polygon.h>
#include <isect/methods/ray_triangle.h>
#include <isect/ray_polygon.h>

namespace isect::ray_polygon {

// clang-format off
template <class S> struct Normal { Vector<S, 3> n; };                     ///< Newell's
template <class S> struct InPlane { S t; Point<S, 3> point; };            ///< where the line meets the plane
template <class S> struct InRange { S t; bool holds; };                   ///< t_min <= t <= t_max
template <class S> struct Projected { int dropped; Point<S, 2> point; };  ///< without the coordinate of largest |n_i|
// clang-format on
template <class S>
using ProjectedEvent = std::variant<Normal<S>, InPlane<S>, InRange<S>, Projected<S>, point_polygon::Straddles,
                                    point_polygon::CrossesAt<S>>;

/// The note's way: meet the plane, round the point, drop a coordinate, count crossings. Naive: rounding may decide,
/// and a ray at an edge that two polygons share may miss both. Source: the note, N20 to N22.
template <class S, class Trace = NoTrace>
std::optional<S> projected(const Ray<S, 3>& ray, const Ring<S, 3>& ring, Trace&& trace = {}) {
  Vector<S, 3> n(S(0), S(0), S(0));
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vector<S, 3> a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    n = n + a.cross(b);
  }
  trace(Normal<S>{n});

  const S denominator = n.dot(ray.direction);
  if (denominator == S(0)) return {};
  const S t = n.dot(ring[0] - ray.origin) / denominator;
  const Point<S, 3> point = ray.at(t);
  trace(InPlane<S>{t, point});
  const bool holds = ray.range.contains(t);
  trace(InRange<S>{t, holds});
  if (!holds) return {};

  const auto size = [&](int i) -> S { return n[i] < S(0) ? -n[i] : n[i]; };
  int axis = size(1) > size(0) ? 1 : 0;
  if (size(2) > size(axis)) axis = 2;
  const auto flatten = [&](const Point<S, 3>& v) { return Point<S, 2>(v[(axis + 1) % 3], v[(axis + 2) % 3]); };
  Ring<S, 2> outline;
  for (const Point<S, 3>& v : ring) outline.push_back(flatten(v));
  trace(Projected<S>{axis, flatten(point)});
  if (!point_polygon::crossings_naive(flatten(point), outline, trace)) return {};
  return t;
}

/// One triangle of the fan: vertices 0, second, second + 1.
template <class S>
struct FanTriangle {
  int second;
  bool hit;
};
template <class S>
using FanEvent = std::variant<FanTriangle<S>>;

/// t in the last triangle that the ray meets, if it meets an odd number of those that vertex 0 makes with the edges:
/// so concave outlines are right by even-odd, too. Naive: Moller and Trumbore's rounding may decide, and a ray
/// through a diagonal may meet both triangles beside it or none. Source: parity as in the note, N22;
/// isect/methods/ray_triangle.h.
template <class S, class Trace = NoTrace>
std::optional<S> fan(const Ray<S, 3>& ray, const Ring<S, 3>& ring, Trace&& trace = {}) {
  bool inside = false;
  S t = S(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const auto hit = ray_triangle::moller_trumbore<S>(ray, {{ring[0], ring[i], ring[i + 1]}});
    trace(FanTriangle<S>{static_cast<int>(i), hit.has_value()});
    if (hit) inside = !inside, t = hit->t;
  }
  if (!inside) return {};
  return t;
}

}  // namespace isect::ray_polygon
