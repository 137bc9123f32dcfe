#pragma once
// The slabs of a polygon and what they store, as a picture.

#include <vector>

#include <isect/many/slab_map.h>
#include "lessons/concave_polygon/picture.h"

namespace isect::lessons::concave_polygon_lesson {

/// What a step shows.
struct DrawnSlabs {
  std::vector<int> probed = {};  ///< lines, in the order asked
  int slab = -1, asked = -1;     ///< the slab found, the edge asked; -1: none
  std::size_t lo = 0, hi = 0;    ///< the edges of the slab still possible
  bool narrowed = false;         ///< some are not
  bool table = false, done = false;
};
viz::Scene picture(const Setup&, const SlabMap&, const DrawnSlabs&);

}  // namespace isect::lessons::concave_polygon_lesson
