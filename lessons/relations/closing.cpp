// What a reader takes along from the six relations, and what there is to do.

#include "lessons/relations/telling.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

namespace {

Relation truth(const Parameters& p) {
  const Kind* const kind = kind_of(p);
  return Pair(kind ? *kind : Kind::balls, pose(p)).truth;
}
bool polygons_touch(const Parameters& p) {
  return kind_of(p) && *kind_of(p) == Kind::polygons && truth(p) == Relation::touching;
}
/// Boxes that share a point where the balls of the same pose have none.
bool boxes_meet_but_not_balls(const Parameters& p) {
  return Pair(Kind::aabbs, pose(p)).meet && !Pair(Kind::balls, pose(p)).meet;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "How can two sets be related? Yes or no is enough to reject a pair, but culling, physics and hierarchies need "
      "more.\n"
      "Three questions tell all cases apart: a common point? one inside the other? a common interior point?";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Two convex sets lie in one of six ways: disjoint, touching, overlapping, a inside b, b inside a, "
          "equal.",
      .cost = "The first question is the cheap one. Containment takes a second test, and touching an exact sign.",
      .choose = "Ask yes or no where a pair is only rejected. Ask for the relation where work is saved by containment.",
      .used =
          "Containment: frustum culling, occlusion, merging of hierarchies. Touching: resting contact in physics. "
          "Equality: welding of vertices.",
      .bug = "Testing whether the boundaries cross. A ball inside a ball then counts as disjoint.",
      .bug_preset = "ball-a-inside-b",
      .reading = {"Lecture note *Intersection Detection*, spatial relationships.",
                  "Max Egenhofer and Robert Franzosa, Point-Set Topological Spatial Relations, *International Journal "
                  "of Geographical Information Systems* 5, 1991, pages 161–174.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, chapter 5."},
      .exercises = {
          {"Move **b** until the two polygons touch.",
           "They touch where a vertex of one lies on an edge of the other, and no interior point is shared.",
           "polygon-disjoint",
           polygons_touch,
           {{"b", "1.392578125,0.1171875,-1.10546875"}}},
          {"Find one pose in which the AABBs meet and the balls do not.",
           "Corners reach farther than balls. Shift b along a diagonal.",
           "all-kinds",
           boxes_meet_but_not_balls,
           {{"b", "1.5,1.125,1"}}},
          {"Which of the six relations can a point and a ball have?",
           "Two, if *r* > 0: disjoint, and the point inside the ball. A point of the surface is a subset of the ball, "
           "too. A ball of radius 0 is a point itself: disjoint, or equal."},
          {"a lies inside b, and b lies inside c. What follows for a and c?",
           "a lies inside c: being a subset is transitive. Overlapping and touching are not."},
          {"Why do two solid sets lie in just one of the six ways? And what of a segment in the plane?",
           "Each question is asked where all before were answered no, and the last way takes what is left.\n"
           "A solid set is the closure of its interior: its interior and the boundary of that. So one inside another "
           "shares interior points with it, and does not just touch it. A segment has no interior in the plane, as no "
           "small disc lies in it. What it crosses would count as touched. So we take its interior along the "
           "segment."},
      }};
  return closing;
}

}  // namespace isect::lessons::relations_lesson
