// What a reader takes along from points, and what there is to do.

#include <isect/point_point.h>
#include "lessons/points/picture.h"

namespace isect::lessons::points_lesson {

using namespace viz;

namespace {

/// Whether p is near to q, q near to r, and p not near to r.
bool broken_chain(const Parameters& p) {
  const Setup s(p);
  const auto near = [&](const Point3& a, const Point3& b) { return nearly_equal(a, b, s.tested_within); };
  return near(s.tp, s.tq) && near(s.tq, s.tr) && !near(s.tp, s.tr);
}
/// Whether the point lies in the cube of the tolerance, but not in the ball.
bool cube_only(const Parameters& p) {
  const std::vector<Said> all = said(Setup(p));
  return !all[0].near && all[3].near;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Are two points the same? Meshes are welded, vertices merged and results checked by this question.\n"
      "Copied numbers are compared exactly. Computed ones carry rounding, so they are compared within a tolerance.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result = "Equality of coordinates is exact and transitive. Nearness within a tolerance is not transitive.",
      .cost =
          "Equality: at most three comparisons. Nearness, by the squared distance: four products, five sums, one "
          "comparison, no square root.",
      .choose =
          "Equality for copied numbers. For computed ones a tolerance that grows with the coordinates: absolute "
          "near 0, relative beyond.",
      .used = "Welding of mesh vertices, hash tables of vertices, snapping in CAD, tests of floating-point results.",
      .bug = "A separate tolerance for each coordinate. It accepts the corners of a cube, √3 tolerances away.",
      .bug_preset = "cube",
      .reading = {"Lecture note *Intersection Detection*, points.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, chapter 11: numerical robustness.",
                  "David Goldberg, What Every Computer Scientist Should Know About Floating-Point Arithmetic, *ACM "
                  "Computing Surveys* 23, 1991, pages 5–48."},
      .exercises = {
          {"Place **q** and **r** so that **p** is near **q** and **q** near **r**, but **p** is not near **r**.",
           "Put **r** beyond **q**, seen from **p**: at most one tolerance from **q**, and more than one from **p**. "
           "So weld to a representative, from which all merged points lie within the tolerance. Choose that well below "
           "the spacing of points that differ: chained, all vertices of a curve would merge.\n"
           "Too small a tolerance leaves copies of a vertex apart, and the mesh has cracks. Too large a one lets short "
           "edges collapse, and triangles lose their area.",
           "cube",
           broken_chain,
           {{"question", "chain"}, {"q", "0.75,0,0"}, {"r", "1.5,0,0"}}},
          {"Find a point **q** that is near by coordinates, and far in truth. And how far is a point from a line, or "
           "from a plane?",
           "It lies in the cube, but not in the ball: near a corner of the cube.\n"
           "Let a line pass through **a** along **d**. The squared distance of **p** is |(**p** − **a**) × **d**|^2 / "
           "|**d**|^2. It is 0, so **p** lies on the line, if (**p** − **a**) × **d** is **0**: no division is "
           "needed.\n"
           "From the plane **n** · **x** + *D* = 0 the distance is |**n** · **p** + *D*| / |**n**|. To forget |**n**| "
           "is a usual mistake.",
           "on-sphere",
           cube_only,
           {{"q", "0.7,0.7,0.7"}}},
          {"Coordinates are 32-bit floats near 10^6. What is the smallest tolerance that does more than equality?",
           "10^6 lies between 2^{19} and 2^{20}, so floats there are 2^{−4} = 0.0625 apart. Any smaller one means "
           "equality."},
          {"Coordinates reach 10^6, and each carries a relative error of 10^{−6}. Which tolerance do you choose? And "
           "why not one relative to the two numbers compared?",
           "Each coordinate may be off by 1, a difference by 2, a distance by 2 · √3. A little more than 3.46 will "
           "do.\n"
           "Near 0 that fails: what should be 0, and is computed as 10^{−17}, differs from 0 by all of its size. So "
           "take the size of what was computed with."},
          {"0 and −0 have different bits. What must a hash table of points do?",
           "IEEE 754 compares values, so both are equal. The hash must map −0 to 0 before it takes the bits.\n"
           "To find points within a tolerance, hash cells of that width. A near point may lie in a neighbouring cell: "
           "in space 3 · 3 · 3 = 27 cells are looked up."},
      }};
  return closing;
}

}  // namespace isect::lessons::points_lesson
