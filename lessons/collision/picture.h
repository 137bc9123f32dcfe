#pragma once
// Boxes in the plane for the collision lesson: a fixed layout with one that can be dragged, and many for counting.

#include <isect/shapes.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::collision_lesson {

using Boxes = std::vector<Aabb<double, 2>>;

/// Six boxes; the first is centred at `p`.
Boxes few(const viz::Vec3& p);
/// As dense as the few, and the same on every machine.
Boxes many(int n);

struct Drawn {
  int i = -1, j = -1;          ///< the pair that is tested
  std::vector<int> also = {};  ///< i was tested with these, too, in the same step
  bool overlap = false;
  std::vector<std::pair<int, int>> found;  ///< pairs that overlap
  std::vector<int> active;                 ///< those that the sweeping plane meets
  double sweep = 0;                        ///< its x-coordinate
  bool sweeping = false;
  std::vector<Aabb<double, 2>> compared;  ///< two nodes of a hierarchy
  std::vector<Aabb<double, 2>> nodes;     ///< all nodes, as dashed boxes
};
viz::Scene picture(const Boxes&, const Drawn&);

}  // namespace isect::lessons::collision_lesson
