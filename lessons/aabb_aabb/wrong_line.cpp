// A program for two boxes with one wrong line: it compares a box with itself.

#include "lessons/aabb_aabb/picture.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::aabb_aabb_lesson {

using namespace viz;

namespace {

std::string program(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.lo[i] > b.hi[i]) return "DISJOINT";
    if (b.lo[i] > b.hi[i]) return "DISJOINT";
  }
  return "OVERLAP";
}

/// Empty boxes need a test of their own: they are left out.
TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  if (empty(s.a) || empty(s.b)) return {};
  return {program(s.a, s.b), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>("whether two boxes meet, if neither is empty",
                                 {"for each axis i of x, y, z", "    if a.min_i > b.max_i: return DISJOINT",
                                  "    if b.min_i > b.max_i: return DISJOINT", "return OVERLAP"},
                                 {3, "if b.min_i > a.max_i: return DISJOINT",
                                  "The line compares b with itself. So a gap between the upper end of a and b is "
                                  "overlooked, on each axis."},
                                 "overlapping", {{"b_min", "0.5,-0.5,0"}});
}

}  // namespace isect::lessons::aabb_aabb_lesson
