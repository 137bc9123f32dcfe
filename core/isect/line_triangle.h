#pragma once
// Ray, line or segment against any triangle in space: the first t, also where it lies in the triangle's plane, and
// where the triangle is a segment or a point; isect/ray_triangle.h leaves both to others.
//
// A triangle without area is the segment between those two corners that have the third between them, which the line
// meets as in isect/line_line.h. Any other the ray meets as isect/ray_triangle.h says, or, in its plane, as
// isect/ray_outline.h does.

#include <array>
#include <optional>

#include <isect/line_line.h>
#include <isect/ray_outline.h>
#include <isect/ray_triangle.h>
#include <isect/triangle_half_spaces.h>

namespace isect {

namespace line_triangle::detail {

/// Returns the first t in a triangle that has no area.
template <class S, class Line>
std::optional<S> first_of_thin(const Line& line, const Triangle<double, 3>& x) {
  const Capsule<double, 3> edge = triangle_half_spaces::detail::as_segment(x, NoTrace());
  const line_line::Result met = intersect(line_line::Straight(line), Segment<double, 3>{edge.p, edge.q});
  if (!met.meets()) return {};
  const auto straight_line = straight(line);
  return static_cast<S>(straight_line.is_point() ? straight_line.range.lo : *met.t);
}

/// Returns the first t of a line in the plane of a triangle that has an area.
template <class Line, class S>
std::optional<S> first_in_plane(const Line& line, const Triangle<S, 3>& x) {
  const std::array<Ring<S, 3>, 1> ring = {Ring<S, 3>{x.vertices[0], x.vertices[1], x.vertices[2]}};
  const int axis = segment_polygon::detail::steepest(ring[0]);
  return first_hit(ray_outline::detail::flattened(line, axis), ray_outline::detail::flattened<S>(ring, axis));
}

}  // namespace line_triangle::detail

/// The first t at which the ray, or the line, meets the triangle.
///
/// Whether there is one is true for all finite input of any magnitude, for any triangle; touching counts. It is the
/// range's lower end where that lies in the triangle, else within 2 ulp of S of its true value, in the range. A zero
/// direction makes the ray a point: the range's lower end if it lies in the triangle. NaN or an infinite coordinate, or
/// an empty range: none.
template <class S>
std::optional<S> first_hit(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  if (!finite(ray) || !finite(triangle) || !ray_range::has_points(ray.range)) return {};
  const RayTriangle<S> across = intersect(ray, triangle);
  if (across.t) return across.t;
  if (across.coplanar) return line_triangle::detail::first_in_plane(ray, triangle);
  const Triangle<double, 3>& wide = in_doubles(triangle);
  if (!triangle_half_spaces::detail::degenerate(wide, NoTrace())) return {};
  return line_triangle::detail::first_of_thin<S>(in_doubles(ray), wide);
}
/// The first t of [0, 1] at which the segment, with both ends as given, meets the triangle; otherwise as for a ray.
template <class S>
std::optional<S> first_hit(const Segment<S, 3>& segment, const Triangle<S, 3>& triangle) {
  if (!finite(segment) || !finite(triangle)) return {};
  const Triangle<double, 3>& wide = in_doubles(triangle);
  if (triangle_half_spaces::detail::degenerate(wide, NoTrace()))
    return line_triangle::detail::first_of_thin<S>(in_doubles(segment), wide);
  const Ring<S, 3> ring = {triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]};
  const RayPolygon<S> across = intersect(segment, ring);
  return across.coplanar ? line_triangle::detail::first_in_plane(segment, triangle) : across.t;
}

}  // namespace isect
