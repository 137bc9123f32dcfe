#pragma once
// The core's answers as a result's fields: the same for queries and for scenes.

#include <isect/point_line.h>
#include <isect/point_polygon.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/segment_segment.h>
#include <isect/shapes.h>
#include "app/query/reply.h"

namespace isect::query {

inline constexpr const char* meeting_words[] = {"disjoint", "touch", "cross", "overlap"};  ///< of two segments

/// Returns a relation's fields; `a` and `b` are names for its word if one contains the other.
inline Json related(Relation r, const std::string& a = "a", const std::string& b = "b") {
  return {{"intersects", r != Relation::disjoint},
          {"relation", r == Relation::a_inside_b   ? b + "_contains_" + a
                       : r == Relation::b_inside_a ? a + "_contains_" + b
                                                   : name(r)}};
}
template <class Box>
Json related(Relation r, const std::string& a, const std::string& b, const Box& box) {
  return telling_empty(related(r, a, b), box, "box");
}

/// Returns the result for two balls; both kinds of tangency are distinguished.
template <class S, int N>
Json two_balls(Relation r, bool tangent, const Sphere<S, N>& a, const Sphere<S, N>& b) {
  Json result = related(r);
  if (r == Relation::touching) result["relation"] = "touch_outer";
  if (!tangent || r == Relation::touching) return result;
  const bool point = a.radius == 0 || b.radius == 0;
  result["relation"] = point ? "touch_inner" : "touch_inner_" + name(r);
  return result;
}

/// Whether on every axis each box begins before the other ends, as the suites that this answers to define it: true for
/// flat boxes, too, unless both are flat along one axis.
template <class S, int N>
bool share_more_than_a_face(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  return intersects(a, b) && (a.lo.array() < b.hi.array()).all() && (b.lo.array() < a.hi.array()).all();
}
template <class S, int N>
Json two_boxes(Relation r, const Aabb<S, N>& a, const Aabb<S, N>& b) {
  const bool equal = r == Relation::equal;
  const Json result = {{"intersects", r != Relation::disjoint},
                       {"interiors_intersect", share_more_than_a_face(a, b)},
                       {"a_contains_b", equal || r == Relation::b_inside_a},
                       {"b_contains_a", equal || r == Relation::a_inside_b},
                       {"relation", name(r)}};
  return telling_empty(telling_empty(result, a, "a"), b, "b");
}
template <class S, int N>
Json two_obbs(Relation r, const Obb<S, N>& a, const Obb<S, N>& b) {
  return telling_empty(telling_empty(related(r), a, "a"), b, "b");
}

inline Json located(Location where) { return {{"location", name(where)}}; }

inline Json wound(const Winding& w) {
  return {{"evenodd", name(w.even_odd)},
          {"nonzero", name(w.nonzero)},
          {"winding", w.nonzero == Location::on ? Json(nullptr) : Json(w.winding)}};
}

/// Returns the stretch of a line inside a solid.
template <class S>
Json stretch(const std::optional<Interval<S>>& inside) {
  return {{"hit", inside.has_value()},
          {"t_in", inside ? number(inside->lo) : nullptr},
          {"t_out", inside ? number(inside->hi) : nullptr}};
}

template <class S>
Json first_t(const std::optional<S>& t) {
  return {{"hit", t.has_value()}, {"t", number(t)}};
}

template <class S>
Json line_and_ball(const RaySphere<S>& shared) {
  const bool meets = shared.line_roots > 0;
  return {{"line_roots", shared.line_roots},
          {"t0", meets ? number(shared.roots.lo) : nullptr},
          {"t1", meets ? number(shared.roots.hi) : nullptr},
          {"ray_hit", shared.solid.has_value()},
          {"origin", name(shared.origin)},
          {"t_first_surface", number(shared.surface)},
          {"t_enter_solid", shared.solid ? number(shared.solid->lo) : nullptr}};
}

template <class S>
Json line_and_plane(const RayPlane<S>& shared) {
  return {{"parallel", shared.parallel},
          {"coplanar", shared.coplanar},
          {"line_hit", shared.line.has_value() || shared.coplanar},
          {"t", number(shared.line)},
          {"ray_hit", shared.meets}};
}
/// Returns the result for a ray and a plane, and whether t of [0, 1] is in the plane.
template <class S, int N>
Json ray_and_plane(const RayPlane<S>& shared, Ray<S, N> ray, const Plane<S, N>& plane) {
  ray.range = {S(0), S(1)};
  Json result = line_and_plane(shared);
  result["segment_hit_0_1"] = intersect(ray, plane).meets;
  return result;
}

/// Returns whether a segment meets the plane, and the part of it on the side to which the normal points.
template <class S>
Json segment_and_plane(const RayPlane<S>& shared, const std::optional<Interval<S>>& above) {
  return {{"parallel", shared.parallel},
          {"coplanar", shared.coplanar},
          {"line_hit", shared.line.has_value() || shared.coplanar},
          {"t", number(shared.line)},
          {"hit", shared.meets},
          {"t_in", above ? number(above->lo) : nullptr},
          {"t_out", above ? number(above->hi) : nullptr}};
}

template <class S>
Json line_and_polygon(const RayPolygon<S>& shared) {
  return {{"parallel", !shared.line},
          {"coplanar", shared.coplanar},
          {"hit", shared.flat || shared.coplanar ? Json(nullptr) : Json(shared.t.has_value())},
          {"t", number(shared.line)},
          {"plane_point_location", shared.line ? name(shared.location) : nullptr}};
}

template <class S>
Json two_segments(const SegmentSegment<S>& shared) {
  Json result = {{"relation", meeting_words[static_cast<int>(shared.relation)]}};
  result["point"] = shared.point ? numbers<S, 2>(*shared.point) : nullptr;
  if (shared.shared) result["shared"] = {numbers<S, 2>(shared.shared->p), numbers<S, 2>(shared.shared->q)};
  return result;
}

}  // namespace isect::query
