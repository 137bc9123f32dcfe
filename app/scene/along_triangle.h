#pragma once
// Where a ray or a segment first meets a triangle, also where it lies in the triangle's plane, or where the triangle
// has no area: what isect/ray_triangle.h leaves to others.

#include <optional>

#include <isect/line_line.h>
#include <isect/ray_half_spaces.h>
#include <isect/triangle_half_spaces.h>

namespace isect::program::scene {

/// The first t of a ray, or of a segment, of [0, 1]. Whether there is one is exact; t is within 2 ulp.
template <class Along>
std::optional<double> first_in(const Along& along, const Triangle<double, 3>& x) {
  if (triangle_half_spaces::detail::degenerate(x, NoTrace())) {
    const Capsule<double, 3> edge = triangle_half_spaces::detail::as_segment(x, NoTrace());
    const line_line::Result r = intersect(line_line::Straight(along), Segment<double, 3>{edge.p, edge.q});
    return r.meets() ? r.t : std::nullopt;
  }
  const auto part = intersect(along, half_spaces_of(x));
  return part ? std::optional(part->lo) : std::nullopt;
}

}  // namespace isect::program::scene
