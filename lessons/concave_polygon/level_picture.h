#pragma once
// A level of the hierarchy, and bars for all of them, as a picture.

#include <vector>

#include "lessons/concave_polygon/picture.h"
#include "lessons/concave_polygon/triangles.h"

namespace isect::lessons::concave_polygon_lesson {

/// What a step shows.
struct DrawnLevel {
  std::vector<int> path = {};    ///< the triangle with p on each level, the coarsest first
  std::vector<int> gone = {};    ///< vertices with a cross
  std::vector<int> linked = {};  ///< triangles that the search looks at
  int here = -1;                 ///< the one that it finds
  bool done = false;
};
viz::Scene picture(const Setup&, const Hierarchy&, const DrawnLevel&, std::size_t level);

}  // namespace isect::lessons::concave_polygon_lesson
