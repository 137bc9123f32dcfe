#pragma once
// Boxes in the plane, the hierarchy that the core builds of them, and both as pictures: nested boxes beside a tree.

#include <string>
#include <vector>

#include <isect/many/bvh.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::hierarchy_lesson {

using Boxes = std::vector<Aabb<double, 2>>;

Boxes scattered(const viz::Vec3& p, double size = 1);  ///< twelve; the middle of box 0 is p; `size` scales it alone
Boxes cluster(const viz::Vec3& middle);                ///< six, for a second object
/// The twelve of a setting: box k is centred at the parameter pk where the setting has it.
Boxes boxes_of(const viz::Parameters&);
inline constexpr int count_of_boxes = 12;
/// Adds a handle for each box but box 0, at a corner: its number stands in its middle.
void add_handles_of_others(const Boxes&, viz::Scene&);

/// Leaves hold up to three boxes, as a node's test costs twice a box's here: small trees that are clear when drawn.
inline constexpr BvhOptions options = {.largest_leaf = 3, .visit = 2};

/// The place of a drawn tree beside its boxes, and the length of the lesson's unit there.
struct TreePlace {
  viz::Vec2 lo = {1.25, -1.5}, hi = {5, 1.625};
  double unit = 1;
};
TreePlace place_beside(const Boxes&);

struct Tree {
  explicit Tree(Boxes, const TreePlace& = {});

  Boxes boxes;
  TreePlace place;
  Bvh<double, 2> bvh;

  int size() const { return static_cast<int>(bvh.nodes.size()); }
  const BvhNode<double, 2>& node(int i) const { return bvh.nodes[i]; }
  const Aabb<double, 2>& box(int i) const { return boxes[i]; }
  std::vector<int> below(int node) const;  ///< primitives, in order
  int height(int node) const;              ///< 0 of a leaf
};

/// How a step shows a node.
enum class State {
  hidden,   ///< not built yet
  unseen,   ///< not tested yet
  seen,     ///< opened
  waiting,  ///< met, to be opened later
  pruned,   ///< ruled out with all below it
  current
};

struct Drawn {
  std::vector<State> states;  ///< of each node
  std::vector<int> hits;      ///< primitives drawn as hit
  viz::Role role = viz::Role::second;
  std::string prefix = {};  ///< before a primitive's number
};

/// The boxes, and around them those of the nodes: dashed, crossed out where pruned.
std::vector<viz::Item> nested(const Tree&, const Drawn&);
/// The tree in its place, or within another rectangle; what its leaves hold stands below them.
std::vector<viz::Item> branches(const Tree&, const Drawn&, const viz::Vec2& lo, const viz::Vec2& hi);
inline std::vector<viz::Item> branches(const Tree& tree, const Drawn& drawn) {
  return branches(tree, drawn, tree.place.lo, tree.place.hi);
}

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

// The walks.

/// Over any two or more boxes that are not all one point; with the lesson's own place for the tree, or beside them.
viz::Walk build(const Boxes&, const TreePlace&);
viz::Walk build(const Boxes&);
/// The walk to the closest hit of a ray.
viz::Walk ray(const Boxes&, const Ray<double, 2>&, const TreePlace&);
viz::Walk ray(const Boxes&, const Ray<double, 2>&);
/// The walk to all pairs between the boxes and those of a second object, whose middle is q.
viz::Walk pairs(const Boxes&, const viz::Vec3& q);
viz::Walk growth();

/// The cost of a query in n boxes: node and box tests, as the mean of many rays, and for all pairs.
struct Cost {
  int n;
  double ray, pairs;
  int depth;
};
const std::vector<Cost>& costs();

}  // namespace isect::lessons::hierarchy_lesson
