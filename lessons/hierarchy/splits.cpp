#include "lessons/hierarchy/splits.h"

#include <algorithm>

namespace isect::lessons::hierarchy_lesson {

namespace {

using Box = Aabb<double, 2>;

double centre(const Box& box, int axis) { return (box.lo[axis] + box.hi[axis]) / 2; }

Box around(const Box& a, const Box& b) { return {a.lo.cwiseMin(b.lo), a.hi.cwiseMax(b.hi)}; }

/// For each box the one around it and all before it.
Boxes running(const Boxes& boxes) {
  Boxes all = boxes;
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = around(all[i - 1], boxes[i]);
  return all;
}

}  // namespace

double cost_of(const Box& whole, const Box& left, int left_count, const Box& right, int right_count) {
  return options.visit +
         (half_perimeter(left) * left_count + half_perimeter(right) * right_count) / half_perimeter(whole);
}

std::optional<PossibleSplit> cheapest_split(const Boxes& boxes) {
  std::optional<PossibleSplit> best;
  const int count = static_cast<int>(boxes.size());
  for (int axis = 0; axis < 2; ++axis) {
    Boxes sorted = boxes;
    std::ranges::stable_sort(sorted, {}, [axis](const Box& box) { return centre(box, axis); });
    const Boxes from_left = running(sorted);
    const Boxes from_right = running({sorted.rbegin(), sorted.rend()});
    for (int left = 1; left < count; ++left) {
      const double before = centre(sorted[left - 1], axis), after = centre(sorted[left], axis);
      if (!(before < after)) continue;
      const int right = count - left;
      const double cost = cost_of(from_left.back(), from_left[left - 1], left, from_right[right - 1], right);
      if (!best || cost < best->cost) best = {axis, left, right, (before + after) / 2, cost};
    }
  }
  return best;
}

}  // namespace isect::lessons::hierarchy_lesson
