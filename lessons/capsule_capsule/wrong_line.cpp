// A program for two capsules with one wrong line: half of the test whether segments cross.

#include <algorithm>

#include <isect/methods/nearest_features.h>
#include <isect/orient.h>
#include "lessons/capsule_capsule/picture.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::capsule_capsule_lesson {

using namespace viz;

namespace {

bool on_both_sides(const Vec2& p, const Vec2& q, const Capsule2& line) {
  return orient2d(line.p, line.q, p) * orient2d(line.p, line.q, q) < 0;
}

double squared_distance(const Vec2& p, const Capsule2& to) {
  return nearest_features::distance2<double, 2>(p, Segment<double, 2>{to.p, to.q});
}

std::string program(const Capsule2& a, const Capsule2& b) {
  if (on_both_sides(b.p, b.q, a)) return "OVERLAP";
  const double d2 = std::min(
      {squared_distance(a.p, b), squared_distance(a.q, b), squared_distance(b.p, a), squared_distance(b.q, a)});
  if (d2 <= (a.radius + b.radius) * (a.radius + b.radius)) return "OVERLAP";
  return "DISJOINT";
}

TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  return {program(s.a, s.b), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether two capsules in the plane meet",
      {"if p_b, q_b lie on both sides of a: return OVERLAP",
       "d² ← the least squared distance of an end to the other segment", "if d² ≤ (r_a + r_b)²: return OVERLAP",
       "return DISJOINT"},
      {1, "if p_b, q_b lie on both sides of a, and p_a, q_a of b: return OVERLAP",
       "The first half says only that b crosses the line of a. It may cross it beyond the ends of a."},
      "ends", {{"p_b", "1.75,-1.75,0"}});
}

}  // namespace isect::lessons::capsule_capsule_lesson
