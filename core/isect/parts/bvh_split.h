#pragma once
// Where to split the primitives of a node of isect/many/bvh.h. That decides how fast a hierarchy is, never how right.
//
// A node of box B with parts L and R costs a random line
//
//   visit + (area(L) |L| + area(R) |R|) / area(B)     primitive tests,
//
// as a line that meets B meets L inside it with the chance area(L) / area(B). The centers of the primitives are
// sorted into 16 bins along the widest axis, and of the 15 cuts between bins the cheapest is taken. That is nearly as
// good as trying all cuts, in O(n) for each level; a median is quicker still, but ignores where the boxes are.
//
// Source: Goldsmith, Salmon, Automatic creation of object hierarchies for ray tracing, IEEE CG&A 7 (1987), for the
// cost; Wald, On fast construction of SAH-based bounding volume hierarchies, IEEE Symposium on Interactive Ray
// Tracing (2007), for the bins.

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

#include <isect/shapes.h>

namespace isect {

struct BvhOptions {
  int largest_leaf = 4;  ///< primitives; less than 1 counts as 1
  double visit = 1;      ///< what it costs to visit a node, in primitive tests
};

namespace bvh {

/// The node's primitives are cut at the coordinate `at` of their centers: so many go left, so many right. By the
/// median, `at` is the least center on the right.
template <class S>
struct Split {
  int node, axis;
  S at;
  int left, right;
  bool median;
};

namespace detail {

/// Below this depth nodes are split at the median, which halves them: none is deeper than 40 + 31.
inline constexpr int balanced_below = 40, deepest = 72;

template <class S, int N>
Aabb<S, N> nothing() {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  return {Point<S, N>::Constant(infinity), Point<S, N>::Constant(-infinity)};
}
template <class S, int N>
void grow(Aabb<S, N>& box, const Aabb<S, N>& other) {
  box.lo = box.lo.cwiseMin(other.lo), box.hi = box.hi.cwiseMax(other.hi);
}

/// A primitive on its way to a leaf.
template <class S, int N>
struct Item {
  Aabb<S, N> box;
  int primitive;

  S center(int axis) const { return box.lo[axis] / 2 + box.hi[axis] / 2; }
};

template <class S, int N>
struct Bounds {
  Aabb<S, N> box = nothing<S, N>(), centers = nothing<S, N>();
};
template <class S, int N>
Bounds<S, N> bounds(std::span<const Item<S, N>> items) {
  Bounds<S, N> all;
  for (const Item<S, N>& item : items) {
    const Point<S, N> center = item.box.lo / 2 + item.box.hi / 2;
    grow(all.box, item.box);
    grow(all.centers, {center, center});
  }
  return all;
}

/// Half the area of a box in 3D, half its outline in 2D, in units of `scale`: that of its surroundings, so that
/// nothing overflows.
template <class S, int N>
S area(const Aabb<S, N>& box, S scale) {
  const Vector<S, N> side = (box.hi / 2 - box.lo / 2) / scale;
  if constexpr (N == 2) return side[0] + side[1];
  return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

/// The greatest half side, 1 for a point.
template <class S, int N>
S scale(const Aabb<S, N>& box) {
  const S greatest = (box.hi / 2 - box.lo / 2).maxCoeff();
  return greatest > 0 ? greatest : S(1);
}

/// The bins of the centers along an axis.
template <class S>
struct Bins {
  static constexpr int count = 16;
  int axis;
  S lo, half;  ///< where the centers begin, and half of how far they reach

  int of(S center) const { return std::min(count - 1, static_cast<int>(count * ((center / 2 - lo / 2) / half))); }
};

/// A cut in front of bin `bin`: what lies left of it, and what both parts cost.
template <class S>
struct Cut {
  int bin = 0, left = 0;
  S cost = std::numeric_limits<S>::infinity();
};

/// The cheapest cut with items on both sides; among equally cheap ones (boxes in a line have no area) the most even.
template <class S, int N>
Cut<S> cheapest(std::span<const Item<S, N>> items, const Bins<S>& bins, S unit) {
  constexpr int count = Bins<S>::count;
  std::array<Aabb<S, N>, count> boxes;
  std::array<int, count> inside = {};
  boxes.fill(nothing<S, N>());
  for (const Item<S, N>& item : items) {
    const int bin = bins.of(item.center(bins.axis));
    grow(boxes[bin], item.box);
    ++inside[bin];
  }

  std::array<S, count> right_cost = {};  // of bins i and on
  Aabb<S, N> box = nothing<S, N>();
  for (int i = count - 1, right = 0; i > 0; --i) {
    grow(box, boxes[i]);
    right += inside[i];
    if (right > 0) right_cost[i] = area(box, unit) * static_cast<S>(right);
  }

  Cut<S> best;
  const int all = static_cast<int>(items.size());
  box = nothing<S, N>();
  for (int i = 1, left = 0; i < count; ++i) {
    grow(box, boxes[i - 1]);
    left += inside[i - 1];
    if (left == 0 || left == all) continue;
    const S cost = area(box, unit) * static_cast<S>(left) + right_cost[i];
    const bool evener = std::abs(2 * left - all) < std::abs(2 * best.left - all);
    if (cost < best.cost || (cost == best.cost && evener)) best = {i, left, cost};
  }
  return best;
}

/// Puts the items with the smaller centers left: half of them, whatever the centers. Equal ones go by index.
template <class S, int N>
int split_at_median(std::span<Item<S, N>> items, int axis) {
  const auto before = [axis](const Item<S, N>& a, const Item<S, N>& b) {
    const S x = a.center(axis), y = b.center(axis);
    return x < y || (x == y && a.primitive < b.primitive);
  };
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), middle, items.end(), before);
  return static_cast<int>(middle - items.begin());
}

/// Splits the items of a node, smaller centers first, and returns how; nothing if they make a leaf.
template <class S, int N>
std::optional<Split<S>> split(std::span<Item<S, N>> items, const Bounds<S, N>& around, int depth,
                              const BvhOptions& options) {
  const int count = static_cast<int>(items.size());
  const bool may_rest = count <= std::max(options.largest_leaf, 1);
  Split<S> result = {};
  const Vector<S, N> reach = around.centers.hi / 2 - around.centers.lo / 2;
  const S half = reach.maxCoeff(&result.axis);

  if (half > 0 && depth < balanced_below && count > 1) {
    const Bins<S> bins = {result.axis, around.centers.lo[result.axis], half};
    const S unit = scale(around.box), whole = area(around.box, unit);
    const Cut<S> cut = cheapest<S, N>(items, bins, unit);
    if (may_rest && !(cut.cost + static_cast<S>(options.visit) * whole < static_cast<S>(count) * whole)) return {};
    if (cut.left > 0) {
      std::partition(items.begin(), items.end(), [&](const auto& x) { return bins.of(x.center(bins.axis)) < cut.bin; });
      result.at = bins.lo + static_cast<S>(2 * cut.bin) / bins.count * half;
      result.left = cut.left, result.right = count - cut.left;
      return result;
    }
  }

  if (may_rest) return {};
  result.left = split_at_median(items, result.axis), result.right = count - result.left;
  result.at = items[result.left].center(result.axis);
  result.median = true;
  return result;
}

}  // namespace detail

}  // namespace bvh

}  // namespace isect
