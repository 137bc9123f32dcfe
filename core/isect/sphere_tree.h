#pragma once
// A hierarchy of bounding spheres over spheres: the idea of isect/bvh.h in its plainest form.
//
// Every leaf is one of the spheres, every inner node the smallest sphere around its two children. Its center and
// radius are rounded, so it is widened by small steps until both lie inside exactly. Then what misses a node truly
// misses all spheres below. A sphere is less to store than a box and turns with its content
// for free, but fits most content less tightly. Source: the note, N09, N04; Ritter, An efficient bounding sphere,
// Graphics Gems (1990), for the sphere around two; Hubbard, Approximating polyhedra with spheres, ACM TOG 15 (1996).

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include <isect/parts/index_pair.h>
#include <isect/ray_sphere.h>
#include <isect/sphere_sphere.h>

namespace isect {

/// An inner node has its two children at nodes[left] and nodes[left + 1]; a leaf has left = 0 and is itself the
/// sphere of that index. An inner ball may be infinite, around spheres of the largest sizes.
template <class S, int N>
struct SphereTree {
  struct Node {
    Sphere<S, N> ball;
    int left = 0, sphere = -1;

    bool leaf() const { return left == 0; }
  };
  std::vector<Node> nodes;  ///< 2n - 1 for n spheres, the root first
};

namespace sphere_tree {

/// Two nodes (or a node and a ray, b = -1) that may meet: they are opened next.
struct Visited {
  int a, b;
};
struct Pruned {
  int a, b;
};
/// Leaves that meet, by the index of their spheres.
struct Found {
  int i, j;
};
using Event = std::variant<Visited, Pruned, Found>;

namespace detail {

template <class S, int N>
bool holds(const Sphere<S, N>& outer, const Sphere<S, N>& inner) {
  if (std::isinf(outer.radius)) return true;
  const Relation relation = relate(inner, outer);
  return relation == Relation::equal || relation == Relation::a_inside_b;
}

/// A ball that contains both balls exactly: one of them, or the smallest one up to rounding.
template <class S, int N>
Sphere<S, N> around(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  if (holds(a, b)) return a;
  if (holds(b, a)) return b;
  constexpr S infinity = std::numeric_limits<S>::infinity();

  const Vector<S, N> half_way = b.center / 2 - a.center / 2;
  const S half_distance = half_way.stableNorm();
  Sphere<S, N> ball = {a.center, half_distance + (a.radius / 2 + b.radius / 2)};
  if (half_distance > 0) ball.center += half_way * (1 + (b.radius / 2 - a.radius / 2) / half_distance);
  if (!finite(ball)) return {a.center, infinity};

  S step = std::max(ball.radius * std::numeric_limits<S>::epsilon() / 2, std::numeric_limits<S>::denorm_min());
  for (; !holds(ball, a) || !holds(ball, b); step *= 2) ball.radius += step;
  return ball;
}

/// Whether a node can't be ruled out; exact except for infinite balls, which meet everything.
template <class S, int N>
bool may_meet(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  return std::isinf(a.radius) || std::isinf(b.radius) || intersects(a, b);
}

/// Fills nodes[index] with the tree of the spheres [first, last), cut at the median of the widest axis.
template <class S, int N>
void build(SphereTree<S, N>& tree, int index, const std::vector<Sphere<S, N>>& spheres, int* first, int* last) {
  if (last - first == 1) {
    tree.nodes[index] = {spheres[*first], 0, *first};
    return;
  }

  Point<S, N> lo = spheres[*first].center, hi = lo;
  for (const int* i = first; i != last; ++i) lo = lo.cwiseMin(spheres[*i].center), hi = hi.cwiseMax(spheres[*i].center);
  int axis = 0;
  Vector<S, N>(hi / 2 - lo / 2).maxCoeff(&axis);
  int* const middle = first + (last - first) / 2;
  std::nth_element(first, middle, last, [&](int i, int j) {
    return std::pair(spheres[i].center[axis], i) < std::pair(spheres[j].center[axis], j);
  });

  const int left = static_cast<int>(tree.nodes.size());
  tree.nodes.resize(tree.nodes.size() + 2);
  build(tree, left, spheres, first, middle);
  build(tree, left + 1, spheres, middle, last);
  tree.nodes[index] = {around(tree.nodes[left].ball, tree.nodes[left + 1].ball), left, -1};
}

}  // namespace detail

}  // namespace sphere_tree

/// The tree of these spheres, lg n deep: each level is cut at the median. Every ball contains those below it exactly.
/// Empty spheres and those with NaN or an infinite coordinate meet nothing, and are left out.
template <class S, int N>
SphereTree<S, N> build_sphere_tree(const std::vector<Sphere<S, N>>& spheres) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    if (finite(spheres[i]) && !empty(spheres[i])) indices.push_back(static_cast<int>(i));

  SphereTree<S, N> tree;
  if (indices.empty()) return tree;
  tree.nodes.reserve(2 * indices.size() - 1);
  tree.nodes.resize(1);
  sphere_tree::detail::build(tree, 0, spheres, indices.data(), indices.data() + indices.size());
  return tree;
}

/// The pairs (i, j), i < j, of spheres in the tree that have a common point, each once. Exact.
template <class S, int N, class Trace = NoTrace>
std::vector<IndexPair> overlapping_pairs(const SphereTree<S, N>& tree, Trace&& trace = {}) {
  using namespace sphere_tree;
  using namespace sphere_tree::detail;
  std::vector<IndexPair> found, stack;
  if (!tree.nodes.empty()) stack.push_back({0, 0});
  while (!stack.empty()) {
    const auto [a, b] = stack.back();
    stack.pop_back();
    const auto &x = tree.nodes[a], &y = tree.nodes[b];
    const bool meet = a == b || may_meet(x.ball, y.ball);
    if (!meet) {
      trace(Pruned{a, b});
      continue;
    }
    trace(Visited{a, b});

    if (a == b) {
      if (x.leaf()) continue;
      stack.insert(stack.end(), {{x.left, x.left + 1}, {x.left + 1, x.left + 1}, {x.left, x.left}});
    } else if (x.leaf() && y.leaf()) {
      found.push_back({std::min(x.sphere, y.sphere), std::max(x.sphere, y.sphere)});
      trace(Found{found.back().i, found.back().j});
    } else if (y.leaf() || (!x.leaf() && x.ball.radius >= y.ball.radius)) {
      stack.insert(stack.end(), {{x.left + 1, b}, {x.left, b}});
    } else {
      stack.insert(stack.end(), {{a, y.left + 1}, {a, y.left}});
    }
  }
  return found;
}

/// The indices of the spheres whose balls the ray meets, in the order in which they are found. Exact.
template <class S, int N, class Trace = NoTrace>
std::vector<int> hits(const SphereTree<S, N>& tree, const Ray<S, N>& ray, Trace&& trace = {}) {
  using namespace sphere_tree;
  using namespace sphere_tree::detail;
  std::vector<int> found, stack;
  if (!tree.nodes.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const int index = stack.back();
    stack.pop_back();
    const auto& node = tree.nodes[index];
    const bool meet = std::isinf(node.ball.radius) || intersect(ray, node.ball);
    if (!meet) {
      trace(Pruned{index, -1});
      continue;
    }
    trace(Visited{index, -1});

    if (node.leaf()) {
      found.push_back(node.sphere);
      trace(Found{node.sphere, -1});
    } else {
      stack.insert(stack.end(), {node.left + 1, node.left});
    }
  }
  return found;
}

}  // namespace isect
