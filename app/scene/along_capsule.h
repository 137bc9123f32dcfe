#pragma once
// Where a ray, a line or a segment enters a capsule and leaves it, in numbers: isect/ray_capsule.h says whether.

#include <isect/shapes.h>

namespace isect::program::scene {

/// The part of the line in the capsule, in t. Each end is within 2 ulp of the true one, below the least double within
/// that, and infinite beyond the largest; it is the range's where that ends within. The ray meets the capsule, and all
/// is finite but for the range's ends.
Interval<double> part_in(const Ray<double, 3>&, const Capsule<double, 3>&);
/// The same of a segment with both ends as given: t of [0, 1].
Interval<double> part_in(const Segment<double, 3>&, const Capsule<double, 3>&);

/// What the line through both ends of a segment, as given, has in common with a ball.
struct LineAndBall {
  int roots = 0;                ///< 1 where it touches, 2 where it crosses: exact. 0 of a segment that is a point
  Interval<double> t = {1, 0};  ///< [0, 1] is the segment; as good as those of part_in
};
LineAndBall line_and_ball(const Segment<double, 3>&, const Sphere<double, 3>&);

}  // namespace isect::program::scene
