#pragma once
// A ray and a polygon that lie in one plane: what `intersect` in isect/ray_polygon.h leaves to a test in two
// dimensions.

#include <array>
#include <optional>
#include <vector>

#include <isect/ray_polygon.h>
#include <isect/shapes.h>

#include "app/scene/place.h"

namespace isect::program::scene {

/// The least t at which the ray meets the polygon, its boundary included, by the even-odd rule; both are projected
/// along the axis of the largest |n_i|, as the core's test does. Whether there is one is decided exactly, and t is the
/// double nearest to the true one. The numbers are finite but for the ray's range, the outline has an area, and the ray
/// lies in its plane.
std::optional<double> first_in_plane(const Ray<double, 3>&, const Ring<double, 3>& outline);

/// The same of a segment with both ends as given, which may be one point: t of [0, 1].
std::optional<double> first_in_plane(const Segment<double, 3>&, const Ring<double, 3>& outline);

/// What `intersect` of isect/ray_polygon.h says of a ray, of a segment with both ends as given, by the even-odd rule: t
/// of [0, 1], the nearest double. All is finite.
RayPolygon<double> across_plane(const Segment<double, 3>&, const Ring<double, 3>& outline);

/// What first_in_plane says, in the plane, of outlines and their holes; of a segment the share of it, from 0 to 1. A
/// ring of two corners is a segment.
std::optional<double> first_in_plane(const Ray<double, 2>&, const std::vector<Ring<double, 2>>& outlines);
std::optional<double> first_in_plane(const Segment<double, 2>&, const std::vector<Ring<double, 2>>& outlines);

/// What first_in_plane finds, as the number itself, which is no root. Each coordinate of the direction is exact.
std::optional<Place> place_in_plane(const Point<double, 3>& origin, const std::array<Exact, 3>& direction,
                                    const Interval<double>& range, const Ring<double, 3>& outline);
std::optional<Place> place_in_plane(const Point<double, 2>& origin, const std::array<Exact, 2>& direction,
                                    const Interval<double>& range, const std::vector<Ring<double, 2>>& outlines);

/// Where the line crosses the plane of an outline with an area: t = num / den; den is 0 where it does not.
struct Crossing {
  Exact num, den;
};
Crossing crossing_of_plane(const Point<double, 3>& origin, const std::array<Exact, 3>& direction,
                           const Ring<double, 3>& outline);

/// Where a corner of the k-DOP lies among outlines and their holes, by the even-odd rule: `out` if it has none. Exact,
/// though no double may be that corner. All is finite.
Location locate_corner(const Kdop<double, 2>&, const std::vector<Ring<double, 2>>& outlines);

/// The axes that are left of a projection along the largest |n_i|, and whether the outline runs clockwise there.
struct Projection {
  int x, y;
  bool clockwise;
};
Projection projection(const Ring<double, 3>& outline);

/// The farthest that a vertex lies off the plane that the core's test takes for the outline's: through the first
/// vertex, with Newell's normal. 0 if and only if all lie in it, exactly; else within 2 ulp, or the least double. The
/// outline has an area.
double off_plane(const Ring<double, 3>& outline);

}  // namespace isect::program::scene
