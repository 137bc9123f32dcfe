// What a reader takes along from a ball and a box, and what there is to do.

#include "lessons/sphere_aabb/picture.h"

namespace isect::lessons::sphere_aabb_lesson {

using namespace viz;

namespace {

bool touches_a_corner(const Parameters& p) {
  const Setup s = setup(p);
  return s.truth == Relation::touching && s.feature() == 3;
}
bool shortcut_errs(const Parameters& p) {
  const Setup s = setup(p);
  return s.truth == Relation::disjoint && s.in_grown;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Does a ball meet an axis-aligned box? Lights and tiles, explosions and buildings, spheres and nodes of a "
      "hierarchy need this.\n"
      "Clamp the centre to the box, axis by axis: that is the nearest point **p**. Its squared distance decides, as in "
      "the lecture note *Intersection Detection*.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The ball meets the box if and only if |**c** − **p**|^2 ≤ *r*^2, where **p** is **c** clamped to the box.",
      .cost = "At most six comparisons, four products and six sums, and one comparison with *r*^2. No square root.",
      .choose =
          "Clamping has no branch and suits SIMD. Early rejections pay where most balls are far away on one axis.",
      .used =
          "Light culling in tiles and clusters, explosions and triggers in games, range queries: neighbours within a "
          "radius.",
      .bug =
          "The box expanded by *r*. Where the Minkowski sum is round, at edges and corners, it accepts balls that "
          "miss: "
          "false positives.",
      .bug_preset = "corner-miss",
      .reading =
          {"Lecture note *Intersection Detection*, sphere and box.",
           "James Arvo, A Simple Method for Box-Sphere Intersection Testing, in: *Graphics Gems*, 1990, pages 335–339.",
           "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.2.5: testing sphere against AABB."},
      .exercises = {
          {"Find a ball that the expanded box accepts, and the exact test rejects.",
           "Bring **c** near an edge or a corner: within *r* on each axis, and farther than *r* in total.",
           "corner",
           shortcut_errs,
           {{"c", "1.25,2,-2"}}},
          {"Let the ball just touch a corner of the box. And when does a ball contain a box?",
           "With gaps 2, 3 and 6 in any unit the distance is 7. So choose gaps 0.25, 0.375, 0.75 and *r* = 0.875.\n"
           "A ball contains the box if it contains the farthest corner. On axis *i* that is max(|*c_i* − *min_i*|, "
           "|*c_i* − *max_i*|) from **c**. Both are equal only if each is one and the same point: else a ball is "
           "round, and a box is not.",
           "corner",
           touches_a_corner,
           {{"c", "0.25,1.125,-1.5"}, {"r", "0.875"}}},
          {"Box from (0, 0, 0) to (4, 2, 2), ball at (6, 1, 4), *r* = 3. Which point is nearest, and do they meet?",
           "Clamped: (4, 1, 2). The squared distance is 4 + 0 + 4 = 8 ≤ 9, so they meet. It lies on an edge. An "
           "oriented box is one in its own frame: the dot products of **c**, seen from its centre, with its axes are "
           "coordinates there. Clamp them to ± its half-lengths, and go back.\n"
           "**c** − **p** is the direction in which to push the ball out. If **c** lies in the box, it is 0: then the "
           "face nearest to **c** gives the direction. The depth is *r* − |**c** − **p**|, and in the box *r* plus the "
           "distance to that face. Moved so far, the ball just touches."},
          {"How much larger is the expanded box than the Minkowski sum, at one corner?",
           "A cube *r*^3 instead of an eighth of a ball: *r*^3 (1 − π/6), about half of the cube. "
           "Along an edge it is *r*^2 (1 − π/4) for each unit of length."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::sphere_aabb_lesson
