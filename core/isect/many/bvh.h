#pragma once
// A hierarchy of axis-aligned boxes over any primitives, which it knows by their boxes alone.
//
// What misses a node's box misses all primitives below it. So a question that touches few of n primitives visits
// about lg n nodes. Every box is the plain min and max of the primitives' boxes: nothing is rounded, so nothing is
// lost. isect/parts/bvh_split.h tells where nodes are split. Source: the note, N09.

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include <isect/parts/bvh_split.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// A leaf has `count` primitives from bvh.primitives[first] on; an inner node, with count 0, has its two children at
/// nodes[first] and nodes[first + 1].
template <class S, int N>
struct BvhNode {
  Aabb<S, N> box;
  int first = 0, count = 0;

  bool leaf() const { return count > 0; }
};

/// Node 0 is the root, if there are nodes. Memory: at most 2n - 1 nodes and n integers for n primitives, which is 116
/// bytes a primitive in 3D and double, 68 in float; two thirds of that where leaves hold several primitives.
template <class S, int N>
struct Bvh {
  std::vector<BvhNode<S, N>> nodes;
  std::vector<int> primitives;  ///< indices of boxes, leaf after leaf
};

namespace bvh {

struct Leaf {
  int node, first, count;
};
template <class S>
using Event = std::variant<Split<S>, Leaf>;

}  // namespace bvh

/// The hierarchy of the primitives with these boxes, from the top down; see isect/parts/bvh_split.h. A box that is
/// empty or has a NaN or infinite coordinate meets nothing, and is left out. The same boxes give the same hierarchy on
/// every machine. O(n lg n): each level takes O(n), and none is deeper than 40 + lg n.
template <class S, int N, class Trace = NoTrace>
Bvh<S, N> build_bvh(const std::vector<Aabb<S, N>>& boxes, const BvhOptions& options = {}, Trace&& trace = {}) {
  std::vector<bvh::detail::Item<S, N>> items;
  items.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (finite(boxes[i]) && !empty(boxes[i])) items.push_back({boxes[i], static_cast<int>(i)});

  Bvh<S, N> result;
  if (items.empty()) return result;
  result.nodes.reserve(2 * items.size() - 1);
  result.primitives.resize(items.size());

  struct Task {
    int node, first, count, depth;
  };
  std::vector<Task> tasks = {{0, 0, static_cast<int>(items.size()), 0}};
  result.nodes.resize(1);
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const auto all =
        std::span(items).subspan(static_cast<std::size_t>(task.first), static_cast<std::size_t>(task.count));
    const bvh::detail::Bounds<S, N> around = bvh::detail::bounds<S, N>(all);

    if (const auto split = bvh::detail::split<S, N>(all, around, task.depth, options)) {
      const int left = static_cast<int>(result.nodes.size());
      result.nodes[task.node] = {around.box, left, 0};
      result.nodes.resize(result.nodes.size() + 2);
      tasks.push_back({left + 1, task.first + split->left, split->right, task.depth + 1});
      tasks.push_back({left, task.first, split->left, task.depth + 1});
      if constexpr (heard<Trace>)
        trace(bvh::Split<S>{task.node, split->axis, split->at, split->left, split->right, split->median});
      continue;
    }

    result.nodes[task.node] = {around.box, task.first, task.count};
    const auto own = result.primitives.begin() + task.first;
    std::transform(all.begin(), all.end(), own, [](const bvh::detail::Item<S, N>& item) { return item.primitive; });
    std::sort(own, own + task.count);
    trace(bvh::Leaf{task.node, task.first, task.count});
  }
  result.nodes.shrink_to_fit();
  return result;
}

/// How a hierarchy came out. The cost is that of isect/parts/bvh_split.h: the expected number of node visits, each
/// weighed as one primitive test, and of primitive tests of a random line that meets the root's box.
struct BvhStatistics {
  int nodes = 0, leaves = 0, depth = 0;  ///< depth: edges from the root to the lowest leaf
  int primitives = 0, least_leaf = 0, largest_leaf = 0;
  double cost = 0;
  std::size_t bytes = 0;
};

template <class S, int N>
std::size_t bytes(const Bvh<S, N>& bvh) {
  return bvh.nodes.capacity() * sizeof(BvhNode<S, N>) + bvh.primitives.capacity() * sizeof(int);
}

template <class S, int N>
BvhStatistics statistics(const Bvh<S, N>& bvh) {
  BvhStatistics result;
  result.bytes = bytes(bvh);
  result.nodes = static_cast<int>(bvh.nodes.size());
  result.primitives = static_cast<int>(bvh.primitives.size());
  if (bvh.nodes.empty()) return result;

  const Aabb<double, N> root = cast<double>(bvh.nodes[0].box);
  const double unit = bvh::detail::scale(root), whole = bvh::detail::area(root, unit);
  std::vector<int> depth(bvh.nodes.size(), 0);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {  // children come after their parent
    const BvhNode<S, N>& node = bvh.nodes[i];
    const double chance = whole > 0 ? bvh::detail::area(cast<double>(node.box), unit) / whole : 1;
    result.cost += chance * (node.leaf() ? node.count : 1);
    if (!node.leaf()) {
      depth[node.first] = depth[node.first + 1] = depth[i] + 1;
      continue;
    }
    result.leaves += 1;
    result.depth = std::max(result.depth, depth[i]);
    result.largest_leaf = std::max(result.largest_leaf, node.count);
    result.least_leaf = result.leaves == 1 ? node.count : std::min(result.least_leaf, node.count);
  }
  return result;
}

}  // namespace isect
