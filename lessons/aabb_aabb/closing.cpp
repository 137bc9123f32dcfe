// What a reader takes along from two boxes, and what there is to do.

#include <isect/interval_interval.h>

#include "lessons/aabb_aabb/picture.h"

namespace isect::lessons::aabb_aabb_lesson {

using namespace viz;

namespace {

bool they_touch(const Parameters& p) { return setup(p).truth == Relation::touching; }
/// Disjoint, although x and y have no gap.
bool apart_on_z_alone(const Parameters& p) {
  const Setup s = setup(p);
  const auto meet = [&](int axis) { return intersects(s.a.along(axis), s.b.along(axis)); };
  return meet(0) && meet(1) && !meet(2);
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two axis-aligned boxes meet? Broad phases and hierarchies answer this millions of times a second.\n"
      "A gap on one axis is enough to say no: that is a separating axis. So the test stops at the first gap.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Two boxes meet if and only if their intervals meet on *x* and on *y* and on *z*. One lies inside the "
          "other if and only if all its intervals do.",
      .cost = "Six comparisons at most, one or two if *x* has a gap, no arithmetic. Exact for ordered ends.",
      .choose =
          "As the first test of any pair, and for boxes at rest. For long, tilted bodies use oriented boxes; of a "
          "turned ball only the centre moves.",
      .used = "Nodes of bounding volume hierarchies, broad phase by sweep and prune, grids, view-volume culling.",
      .bug = "OVERLAP returned inside the loop, or \"or\" for \"and\": one common interval then decides.",
      .bug_preset = "gap-y",
      .reading = {"Lecture note *Intersection Detection*, axis-aligned boxes.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 4.2: axis-aligned bounding boxes.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13."},
      .exercises = {
          {"Drag b towards a until the boxes touch.",
           "They touch if no axis has a gap, and on one an end of a is the opposite end of b. For flat boxes see "
           "the last exercise.",
           "gap-x",
           they_touch,
           {{"b_min", "0,-0.5,-0.5"}, {"b_max", "1.25,1,1"}}},
          {"Find boxes that overlap on *x* and on *y*, and are disjoint.",
           "Move b along *z* alone. Two axes prove nothing if the third has a gap.",
           "overlapping",
           apart_on_z_alone,
           {{"b_min", "-0.75,-0.5,2"}, {"b_max", "1,1.5,3"}}},
          wrong_line(),
          {"Write containment of b in a as comparisons. How many are needed?",
           "a.min_i ≤ b.min_i and b.max_i ≤ a.max_i for each of three axes: six, if both boxes have points. With "
           "exchanged ends a box is empty, yet the six comparisons for a common point may all hold. So store an empty "
           "box with the ends min = ∞ and max = −∞. It has a gap to each bounded box, and the union with it changes "
           "nothing. With a NaN no > holds. That comparison finds no gap, but the axis' other one may."},
          {"What changes if touching boxes should count as disjoint?",
           "Each > becomes ≥. A flat box still meets what it pierces. Two flat boxes in one plane share more than a "
           "rim, "
           "but these comparisons call them disjoint: ask first whether both are flat there."},
      }};
  return closing;
}

}  // namespace isect::lessons::aabb_aabb_lesson
