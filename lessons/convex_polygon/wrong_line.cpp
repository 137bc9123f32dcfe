// A program for a convex polygon with one wrong line: the edge that ends the fan is not asked.

#include <isect/orient.h>
#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;

namespace {

std::string program(const Point<double, 2>& p, const Ring<double, 2>& v) {
  const auto right_of = [&](std::size_t i, std::size_t j) { return orient2d(v[i], v[j], p) < 0; };
  if (right_of(0, 1)) return "OUT";
  std::size_t lo = 1, hi = v.size() - 1;
  while (hi - lo > 1) {
    const std::size_t mid = (lo + hi) / 2;
    (right_of(0, mid) ? hi : lo) = mid;
  }
  return right_of(lo, hi) ? "OUT" : "IN";
}

TwoVerdicts verdicts(const Parameters& values) {
  const Setup s(std::stoi(std::get<std::string>(values.at("n"))), flat_point(values, "p"));
  return {program(s.p, s.polygon.vertices), s.truth == Location::out ? "OUT" : "IN"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a point lies in a convex polygon, its boundary included",
      {"if p right of v0 v1: return OUT", "lo ← 1, hi ← n − 1", "while hi − lo > 1", "    mid ← (lo + hi) / 2",
       "    p right of v0 v_mid ? hi ← mid : lo ← mid", "return p right of v_lo v_hi ? OUT : IN"},
      {1, "if p right of v0 v1, or left of v0 v_{n−1}: return OUT",
       "The last edge leads back to **v**_0. A point beyond it lies in no wedge. Yet the bisection ends in the last "
       "one, whose far edge may not reject it."},
      "inside", {{"p", "1.75,-1.125,0"}});
}

}  // namespace isect::lessons::convex_polygon_lesson
