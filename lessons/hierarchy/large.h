#pragma once
// What a box nearly as large as all of them together does to a tree.

#include <optional>

#include "lessons/hierarchy/tree.h"

namespace isect::lessons::hierarchy_lesson {

/// The costs are what a random line that meets the root's box takes, as expected by its chance to meet each node: inner
/// nodes opened and boxes tested.
struct LargeBox {
  int box;
  double share;  ///< its perimeter, of the root's
  int nodes;     ///< how many hold it
  int mates;     ///< how many other boxes its leaf holds
  double cost;
  double apart;  ///< the cost if this box is tested by itself and the others have a tree of their own
};
/// The box with the largest perimeter, if that is at least half of the root's.
std::optional<LargeBox> large_box(const Tree&);

/// The step's words on it.
std::string told_of(const LargeBox&);
viz::Question asked_of(const LargeBox&);

}  // namespace isect::lessons::hierarchy_lesson
