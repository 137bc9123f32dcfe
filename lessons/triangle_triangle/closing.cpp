// What a reader takes along from two triangles, and what there is to do.

#include "lessons/triangle_triangle/picture.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;

namespace {

bool now_touching(const Parameters& p) { return setup(p).truth == Relation::touching; }
bool now_neighbours(const Parameters& p) {
  const Setup s = setup(p);
  return s.both_have_area() && s.shared_corners() == 2 && !s.clash();
}
bool now_misled(const Parameters& p) {
  const Setup s = setup(p);
  return s.both_have_area() && triangle_triangle::by_intervals(s.a(), s.b()) != s.meet();
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two triangles in space meet? Many surfaces are meshes of triangles. So this test finds where two surfaces "
      "cross, and whether one crosses itself.\n"
      "The idea: two planes that are not parallel meet in a line. There each triangle has an interval, or nothing.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Two triangles are disjoint if one lies strictly on one side of the other's plane. Else, in two planes, they "
          "meet if their intervals on the common line share a number. In one plane, they meet if no side parts them.",
      .cost =
          "Six heights, then four divisions or two more signs; in one plane, up to six sides. A pair beside a plane "
          "ends after three or six heights.",
      .choose =
          "Signs of volumes, exactly, for meshes without faults. Intervals in doubles where a wrong answer near a "
          "touch does no harm.",
      .used = "Collision of meshes after a broad phase, Boolean operations, checks of meshes for self-intersection.",
      .bug = "Taking “they meet” for a fault in a mesh: it is true of all neighbours.",
      .bug_preset = "neighbours",
      .reading =
          {"Tomas Möller, A Fast Triangle-Triangle Intersection Test, *Journal of Graphics Tools* 2, 1997, pages "
           "25–30.",
           "Philippe Guigue and Olivier Devillers, Fast and Robust Triangle-Triangle Overlap Test Using "
           "Orientation Predicates, *Journal of Graphics Tools* 8, 2003, pages 25–32.",
           "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.2.10: testing triangle against "
           "triangle."},
      .exercises = {
          {"Lower b by one of its corners, until the triangles touch.",
           "They touch where a corner of b lies in a and the others above: **b**_0 = (0, 0, 0) is one such place.",
           "above",
           now_touching,
           {{"b0", "0,0,0"}}},
          {"Make the two triangles neighbours that share an edge, with no fault.",
           "Two corners of b must be corners of a, such as **a**_0 and **a**_1. The third may lie anywhere off the "
           "plane of a.",
           "vertex-on-face",
           now_neighbours,
           {{"b0", "-2,0,1.5"}, {"b1", "2,0,1.5"}, {"b2", "0,1.5,2"}}},
          {"Which three signs show, without any division, that two triangles are disjoint? And how many axes may "
           "separate them?",
           "The sides of one triangle's three corners, seen from the other's plane, if all are + or all −.\n"
           "Eleven, if no plane holds both: the two normals, and nine cross products of a side of each. In one plane "
           "six: the normals of the sides there."},
          wrong_line(),
          {"Find a place of **b**_0 with decimals at which rounding misleads the intervals.",
           "As decimals, (−0.56, 0.26, −0.32) lies on the edge from **a**_0 to **a**_1. But these decimals are no "
           "doubles.\n"
           "Möller's program takes heights up to an *ε* in size for 0. So triangles in one plane, up to rounding, are "
           "tested there. The price: triangles a little apart may count as meeting. And *ε* must fit, as heights, "
           "times the length of **n**, grow with the cube of the size.",
           "decimals",
           now_misled,
           {{"b0", "-0.56,0.26,-0.32"}}},
      }};
  return closing;
}

}  // namespace isect::lessons::triangle_triangle_lesson
