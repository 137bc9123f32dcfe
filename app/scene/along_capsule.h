#pragma once
// Where a ray, a line or a segment enters a capsule and leaves it, in numbers: isect/ray_capsule.h says whether.

#include <isect/shapes.h>

namespace isect::program::scene {

/// The part of the line in the capsule, in t. Each end, if it is finite, is within 5 ulp of the true one; they are the
/// range's where that ends within. The ray meets the capsule, and all is finite but for the range's ends.
Interval<double> part_in(const Ray<double, 3>&, const Capsule<double, 3>&);
/// The same of a segment with both ends as given: t of [0, 1].
Interval<double> part_in(const Segment<double, 3>&, const Capsule<double, 3>&);

}  // namespace isect::program::scene
