#pragma once
// Boxes in the plane for the collision lesson: a fixed layout with one that can be dragged, and many for counting.

#include <isect/shapes.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::collision_lesson {

using Boxes = std::vector<Aabb<double, 2>>;

/// Six boxes of a setting: the first is centred at p, the others at p1, p2, … where it has these.
Boxes few(const viz::Parameters&);
inline constexpr int count_of_few = 6;
/// n random boxes as dense as the few, the same on every machine.
Boxes many(int n);

/// The size and place of what is drawn beside the boxes. The default is for the few.
struct Frame {
  double unit = 1;
  double below = -2.45;           ///< y of the intervals on the axis
  double bottom = -3.1, top = 2;  ///< of the sweeping plane
};
Frame frame_of(const Boxes&);

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
viz::Scene picture(const Boxes&, const Drawn&, const Frame&);

}  // namespace isect::lessons::collision_lesson
