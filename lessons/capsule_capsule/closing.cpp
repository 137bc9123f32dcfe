// What a reader takes along from two capsules, and what there is to do.

#include "lessons/capsule_capsule/picture.h"

namespace isect::lessons::capsule_capsule_lesson {

using namespace viz;

namespace {

bool they_touch(const Parameters& p) { return setup(p).truth == Relation::touching; }
bool a_lies_inside(const Parameters& p) { return setup(p).truth == Relation::a_inside_b; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two thick segments meet? Characters, limbs and ropes are modelled as capsules, so games test this every "
      "frame.\n"
      "Only the distance between the two segments matters. The radii are added, as for two balls.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Two capsules meet if and only if their segments come within *r*_a + *r*_b. In the plane they cross, or "
          "an end is nearest.",
      .cost =
          "Constant. In the plane: four orientations, then four distances from a point to a segment at most. The "
          "textbook method takes two divisions at most.",
      .choose =
          "For long, round bodies that rotate: only two endpoints are rotated. For flat bodies use oriented "
          "boxes, for short ones balls.",
      .used = "Character controllers, limbs of ragdolls, ropes and hair; a ball that moves sweeps a capsule.",
      .bug = "The nearest points of the lines, not clamped to the segments. They may lie beyond the ends.",
      .bug_preset = "ends",
      .reading =
          {"Christer Ericson, *Real-Time Collision Detection*, 2005, section 4.5: sphere-swept volumes.",
           "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.1.9: closest points of two line "
           "segments.",
           "Vladimir Lumelsky, On Fast Computation of Distance Between Line Segments, *Information Processing Letters* "
           "21, 1985, pages 55–61.",
           "Dan Sunday, Distance between Lines and Segments with their Closest Point of Approach, *softSurfer*, 2001."},
      .exercises = {
          {"Move the ends of b until the capsules touch.",
           "They touch where the segments are *r*_a + *r*_b apart, which is 1.25 where this exercise begins. Ends that "
           "are (0.75, 1) apart have that distance.",
           "ends",
           they_touch,
           {{"p_b", "1.25,0.5,0"}, {"q_b", "2.75,1.25,0"}}},
          {"Enlarge b until a lies inside it.",
           "The balls at both ends of a must lie in b: raise its radius.",
           "crossing",
           a_lies_inside,
           {{"r_b", "4"}}},
          {"a runs from (0, 0) to (4, 0), *r*_a = 1; b is a ball at (6, 3), radius 2. Do they meet? And why do "
           "capsules meet if and only if *d* ≤ *R*?",
           "The nearest point is the end (4, 0), √(4 + 9) = 3.606 away. That is more than 3, so they do not.\n"
           "A common point is at most *r*_a from a point of one segment, and *r*_b from one of the other. So *d* ≤ "
           "*r*_a + *r*_b. Conversely, go from the closest point of a towards that of b by the smaller of *r*_a and "
           "*d*. At most *r*_b is left, so that point lies in both."},
          {"Why may the four ends not be enough in space?",
           "Two segments that pass each other, like diagonals of a box's opposite faces that are not parallel, are "
           "nearest between their "
           "ends."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::capsule_capsule_lesson
