#pragma once
// A polygon's plane: how to see it, what lies off it, and where a ray in it first meets the polygon, as the number
// itself.

#include <array>
#include <optional>
#include <vector>

#include <isect/point_polygon.h>
#include <isect/shapes.h>

#include "app/scene/place.h"

namespace isect::program::scene {

/// The least t at which a ray meets a polygon in its plane, as the number itself, which is no root: what `first_hit` of
/// isect/ray_outline.h finds. Each coordinate of the direction is exact.
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
