#pragma once
// A polygon in space as triangles between its corners, so that what has a test of triangles has one of polygons.

#include <array>
#include <vector>

#include <isect/shapes.h>

namespace isect::program::scene {

/// What follows takes the square of an outline's corners: no more than these are looked at.
inline constexpr std::size_t most_corners = 2'000;

/// Triangles whose union is the polygon, if its corners lie in one plane; else the surface that is tested in its place.
/// They are found by cutting off ears (Meisters, Polygons have ears, 1975) where the corners are seen along the axis of
/// the normal's largest component, exactly. None if that outline has no area, crosses or touches itself.
std::vector<Triangle<double, 3>> triangulated(const Ring<double, 3>& outline);
/// The same by the numbers of their corners; they turn as the outline does. An outline may touch itself: so programs
/// write a face with a hole, which an edge leads to and back from. None if it has no area, crosses itself or runs back
/// over an edge with nothing around it.
std::vector<std::array<int, 3>> ears(const Ring<double, 3>& outline);
/// Whether it neither crosses nor touches itself, as seen along that axis.
bool is_simple(const Ring<double, 3>& outline);

}  // namespace isect::program::scene
