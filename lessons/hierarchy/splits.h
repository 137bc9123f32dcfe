#pragma once
// What any split of some boxes would cost, tried by the builder or not.

#include <optional>

#include "lessons/hierarchy/tree.h"

namespace isect::lessons::hierarchy_lesson {

/// Half of what surrounds a box in the plane.
inline double half_perimeter(const Aabb<double, 2>& box) { return (box.hi - box.lo).sum(); }

/// What a node of this box and two parts costs: one visit, then each part's boxes with the chance that it is met.
double cost_of(const Aabb<double, 2>& whole, const Aabb<double, 2>& left, int left_count, const Aabb<double, 2>& right,
               int right_count);

struct PossibleSplit {
  int axis, left, right;
  double at;  ///< halfway between two centres
  double cost;
};
/// The cheapest split by centres: along either axis, between any two of them. Nothing if all centres are one point.
std::optional<PossibleSplit> cheapest_split(const Boxes&);

}  // namespace isect::lessons::hierarchy_lesson
