// What a reader takes along from two oriented boxes, and what there is to do.

#include "lessons/obb_obb/picture.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;

namespace {

bool b_lies_inside(const Parameters& p) { return setup(p).truth == Relation::b_inside_a; }
bool only_edges_separate(const Parameters& p) { return cases().branches[cases().branch(p)] == "edge × edge"; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two oriented boxes meet? They fit long, tilted bodies far better than axis-aligned ones.\n"
      "Each has a centre, three half-lengths and a right-handed frame of unit axes, made from two given directions.\n"
      "Compact convex sets are disjoint if and only if some axis separates their projections.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Two oriented boxes are disjoint if and only if |**n** · **l**| > *r*_a + *r*_b on one of 15 axes. "
          "*r*_b is the sum of *h*_j |**b**_j · **n**| over the axes of b, and likewise *r*_a.",
      .cost = "Up to 15 axes, about 250 operations. Pairs far apart are mostly rejected by the first axes.",
      .choose =
          "For long, tilted bodies, after a cheaper test of balls or AABBs. For general polytopes use GJK (Gilbert, "
          "Johnson and Keerthi).",
      .used = "Rigid bodies in physics engines, OBB trees of meshes, picking handles in editors, vehicles in games.",
      .bug =
          "An absolute tolerance ε. Without it, parallel edges give false gaps; with a coarse one, thin boxes give "
          "false hits.",
      .bug_preset = "slender",
      .reading = {"Stefan Gottschalk, Ming Lin and Dinesh Manocha, OBBTree: A Hierarchical Structure for Rapid "
                  "Interference Detection, *SIGGRAPH*, 1996, pages 171–180.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 4.4: oriented bounding boxes.",
                  "Lecture note *Intersection Detection*, oriented boxes."},
      .exercises = {
          {"Shrink b until it lies inside a.",
           "Halve its half-lengths, and bring its centre into a.",
           "overlapping",
           b_lies_inside,
           {{"b", "-1.25,0,0"}, {"b_half", "0.5,0.25,0.25"}}},
          {"Move b until only a cross product of edges separates the boxes.",
           "Let the boxes pass each other edge against edge, as two sticks held crosswise.",
           "normal-of-b",
           only_edges_separate,
           {{"b_u", "-1,0.25,0"}, {"b_v", "-1,-0.75,1"}}},
          wrong_line(),
          {"How many axes do two rectangles in the plane need? And two boxes with a common face normal, or with three?",
           "Rectangles: 4 normals, no cross products. With one common direction, the remaining candidates are 5: that "
           "direction and 4 in the plane. With all three in common 3 are left, in the plane 2: cross products are "
           "these or 0. The test is then that of two AABBs."},
          {"Why are the cross products needed, if no face has such a normal? And what becomes of axes that are turned "
           "a little in each frame?",
           "The Minkowski sum of a and −b has faces that two edges span. Their normals are the cross products. "
           "What lies outside a convex polytope lies beyond one of its faces, so other axes are not needed.\n"
           "Axes turned so drift by rounding from unit length and right angles, and the test takes them as they are. "
           "Renew them by Gram and Schmidt, or keep a unit quaternion."},
      }};
  return closing;
}

}  // namespace isect::lessons::obb_obb_lesson
