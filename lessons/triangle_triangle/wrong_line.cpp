// A program for two triangles with one wrong line: the edges of one of them are forgotten.

#include <isect/triangle_half_spaces.h>
#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"
#include "lessons/triangle_triangle/picture.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;

namespace {

bool share_a_point(const Segment<double, 3>& edge, const Three& x) { return intersects(x, half_spaces_of(edge)); }

std::string program(const Three& a, const Three& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (share_a_point({a.vertices[i], a.vertices[(i + 1) % 3]}, b)) return "OVERLAP";
  return "DISJOINT";
}

TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  return {program(s.a(), s.b()), says_overlap(s.meet())};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether two triangles meet",
      {"for each edge e of a", "    if e and b share a point: return OVERLAP", "return DISJOINT"},
      {3, "return some edge of b and a share a point ? OVERLAP : DISJOINT",
       "An edge of b may pierce a, or a corner of b touch it, while no edge of a reaches b."},
      "above", {{"b0", "0,-0.5,0"}});
}

}  // namespace isect::lessons::triangle_triangle_lesson
