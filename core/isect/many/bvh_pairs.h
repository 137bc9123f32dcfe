#pragma once
// All pairs of primitives whose boxes meet: inside one hierarchy, or between two.
//
// Two nodes whose boxes are apart hold no pair: that one comparison rules out all pairs below them. Else the larger
// of the two is opened. Inside one hierarchy a node is first paired with itself, which opens to: left with itself,
// right with itself, left with right. So each pair comes up once. Boxes are compared, not computed: exact for free.
// Source: the note, N09; Gottschalk, Lin, Manocha, OBBTree, SIGGRAPH (1996).

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/many/bvh.h>
#include <isect/parts/index_pair.h>

namespace isect {

namespace bvh_pairs {

/// Two nodes, of the first and the second hierarchy or of one, whose boxes meet: they are opened next.
struct Visited {
  int a, b;
};
/// Two nodes whose boxes are apart.
struct Pruned {
  int a, b;
};
/// Two primitives, and whether their boxes meet.
struct Tested {
  int i, j;
  bool meet;
};
using Event = std::variant<Visited, Pruned, Tested>;

/// A listener that counts.
struct Counts {
  long visited = 0, pruned = 0, tested = 0;

  void operator()(const Visited&) { ++visited; }
  void operator()(const Pruned&) { ++pruned; }
  void operator()(const Tested&) { ++tested; }
};

namespace detail {

/// Whether two boxes meet; both are finite and not empty, as those in a hierarchy are.
template <class S, int N>
bool meet(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  bool result = true;
  for (int axis = 0; axis < N; ++axis) result &= (a.lo[axis] <= b.hi[axis]) & (b.lo[axis] <= a.hi[axis]);
  return result;
}

/// One hierarchy and the boxes it was built of.
template <class S, int N>
struct Tree {
  const Bvh<S, N>& bvh;
  const std::vector<Aabb<S, N>>& boxes;

  const BvhNode<S, N>& operator[](int node) const { return bvh.nodes[node]; }
};

/// Whether a is to be opened rather than b: an inner node rather than a leaf, else the wider one.
template <class S, int N>
bool open_first(const BvhNode<S, N>& a, const BvhNode<S, N>& b) {
  if (a.leaf() || b.leaf()) return b.leaf();
  return (a.box.hi / 2 - a.box.lo / 2).maxCoeff() >= (b.box.hi / 2 - b.box.lo / 2).maxCoeff();
}

/// Reports the pairs of a node of one hierarchy and another node, of the same or of another.
template <class S, int N, class Report, class Trace>
void between(const Tree<S, N>& a, const Tree<S, N>& b, int root_a, int root_b, const Report& report, Trace&& trace) {
  std::vector<std::pair<int, int>> stack = {{root_a, root_b}};
  while (!stack.empty()) {
    const auto [node_a, node_b] = stack.back();
    stack.pop_back();
    const BvhNode<S, N>&x = a[node_a], &y = b[node_b];
    const bool apart = !meet(x.box, y.box);
    if (apart) {
      trace(Pruned{node_a, node_b});
      continue;
    }
    trace(Visited{node_a, node_b});

    if (x.leaf() && y.leaf()) {
      for (int k = x.first; k < x.first + x.count; ++k)
        for (int l = y.first; l < y.first + y.count; ++l) {
          const int i = a.bvh.primitives[k], j = b.bvh.primitives[l];
          const bool met = meet(a.boxes[i], b.boxes[j]);
          trace(Tested{i, j, met});
          if (met) report(i, j);
        }
    } else if (open_first(x, y)) {
      stack.push_back({x.first + 1, node_b});
      stack.push_back({x.first, node_b});
    } else {
      stack.push_back({node_a, y.first + 1});
      stack.push_back({node_a, y.first});
    }
  }
}

}  // namespace detail

}  // namespace bvh_pairs

/// Calls report(i, j) once for every two primitives of one hierarchy whose boxes have a common point, i < j, in the
/// order in which they are found. `boxes` are those that the hierarchy was built of. Exact; the same pairs as
/// intersects(boxes[i], boxes[j]) finds one by one.
template <class S, int N, class Report, class Trace = NoTrace>
void report_pairs(const Bvh<S, N>& bvh, const std::vector<Aabb<S, N>>& boxes, const Report& report,
                  Trace&& trace = {}) {
  const bvh_pairs::detail::Tree<S, N> tree = {bvh, boxes};
  const auto ordered = [&](int i, int j) { report(std::min(i, j), std::max(i, j)); };
  for (std::size_t index = 0; index < bvh.nodes.size(); ++index) {  // every node with itself
    const BvhNode<S, N>& node = bvh.nodes[index];
    if (!node.leaf()) {
      bvh_pairs::detail::between(tree, tree, node.first, node.first + 1, ordered, trace);
      continue;
    }
    for (int k = node.first; k < node.first + node.count; ++k)
      for (int l = k + 1; l < node.first + node.count; ++l) {
        const int i = bvh.primitives[k], j = bvh.primitives[l];
        const bool met = bvh_pairs::detail::meet(boxes[i], boxes[j]);
        trace(bvh_pairs::Tested{i, j, met});
        if (met) report(i, j);  // a leaf's primitives are sorted
      }
  }
}

/// Calls report(i, j) once for every primitive i of the first and j of the second hierarchy whose boxes have a common
/// point.
template <class S, int N, class Report, class Trace = NoTrace>
void report_pairs(const Bvh<S, N>& a, const std::vector<Aabb<S, N>>& boxes_a, const Bvh<S, N>& b,
                  const std::vector<Aabb<S, N>>& boxes_b, const Report& report, Trace&& trace = {}) {
  if (a.nodes.empty() || b.nodes.empty()) return;
  const bvh_pairs::detail::Tree<S, N> first = {a, boxes_a}, second = {b, boxes_b};
  bvh_pairs::detail::between(first, second, 0, 0, report, trace);
}

/// The pairs that report_pairs finds, in its order.
template <class S, int N>
std::vector<IndexPair> overlapping_pairs(const Bvh<S, N>& bvh, const std::vector<Aabb<S, N>>& boxes) {
  std::vector<IndexPair> pairs;
  report_pairs(bvh, boxes, [&](int i, int j) { pairs.push_back({i, j}); });
  return pairs;
}
template <class S, int N>
std::vector<IndexPair> overlapping_pairs(const Bvh<S, N>& a, const std::vector<Aabb<S, N>>& boxes_a, const Bvh<S, N>& b,
                                         const std::vector<Aabb<S, N>>& boxes_b) {
  std::vector<IndexPair> pairs;
  report_pairs(a, boxes_a, b, boxes_b, [&](int i, int j) { pairs.push_back({i, j}); });
  return pairs;
}

}  // namespace isect
