// A program for two intervals with one wrong line: it takes closed intervals for open ones.

#include <algorithm>

#include "lessons/intervals/picture.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::intervals_lesson {

using namespace viz;

namespace {

std::string program(const Interval<double>& a, const Interval<double>& b) {
  const double lo = std::max(a.lo, b.lo);
  const double hi = std::min(a.hi, b.hi);
  if (lo < hi) return "OVERLAP";
  return "DISJOINT";
}

TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  return {program(s.a, s.b), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether two intervals share a number",
      {"lo ← max(a_min, b_min)", "hi ← min(a_max, b_max)", "if lo < hi: return OVERLAP", "return DISJOINT"},
      {3, "if lo ≤ hi: return OVERLAP",
       "Closed intervals contain their ends: two that touch share one number. So does an interval of one number with "
       "any that contains it."},
      "overlapping", {{"b_min", "1"}});
}

}  // namespace isect::lessons::intervals_lesson
