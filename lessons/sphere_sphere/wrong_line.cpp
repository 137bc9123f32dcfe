// A program for two balls with one wrong line: it adds squares where it should square a sum.

#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

using namespace viz;

namespace {

std::string program(const Ball3& a, const Ball3& b) {
  const Vec3 l = b.center - a.center;
  const double d2 = l.dot(l);
  if (d2 <= a.radius * a.radius + b.radius * b.radius) return "OVERLAP";
  return "DISJOINT";
}

/// In the unit that is chosen, in which neither overflow nor underflow is to be feared.
TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  return {program(s.a, s.b), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether two balls meet", {"l ← b − a", "d² ← l · l", "if d² ≤ r_a² + r_b²: return OVERLAP", "return DISJOINT"},
      {3, "if d² ≤ (r_a + r_b)²: return OVERLAP",
       "The square of the sum is larger than the sum of the squares, by 2 *r*_a *r*_b. So balls that "
       "overlap only a little are called disjoint."},
      "disjoint", {{"b", "1.015625,0,-0.76171875"}});
}

}  // namespace isect::lessons::sphere_sphere_lesson
