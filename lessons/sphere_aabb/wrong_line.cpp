// A program for a ball and a box with one wrong line: a gap is counted on the wrong axis, too.

#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"
#include "lessons/sphere_aabb/picture.h"

namespace isect::lessons::sphere_aabb_lesson {

using namespace viz;

namespace {

std::string program(const Sphere<double, 3>& ball, const Aabb<double, 3>& b) {
  double d2 = 0, gap = 0;
  for (int i = 0; i < 3; ++i) {
    const double c_i = ball.center[i];
    if (c_i < b.lo[i]) gap = b.lo[i] - c_i;
    if (c_i > b.hi[i]) gap = c_i - b.hi[i];
    d2 += gap * gap;
  }
  if (d2 <= ball.radius * ball.radius) return "OVERLAP";
  return "DISJOINT";
}

/// An empty box needs a test of its own: it is left out.
TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  if (empty(s.box)) return {};
  return {program(s.ball, s.box), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a ball meets a box that is not empty",
      {"d² ← 0, gap ← 0", "for each axis i of x, y, z", "    if c_i < b.min_i: gap ← b.min_i − c_i",
       "    if c_i > b.max_i: gap ← c_i − b.max_i", "    d² ← d² + gap²", "if d² ≤ r²: return OVERLAP",
       "return DISJOINT"},
      {2, "for each axis i of x, y, z: gap ← 0",
       "Without that, an axis without a gap keeps the gap of the axis before it. So that gap counts twice, or three "
       "times."},
      "corner", {{"c", "1.25,0,0"}});
}

}  // namespace isect::lessons::sphere_aabb_lesson
