// A program that counts crossings, with one wrong line: it looks at an edge's box, not at the edge.

#include <algorithm>

#include <isect/orient.h>
#include "lessons/crossings/telling.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;

namespace {

using Point2 = Point<double, 2>;

bool on(const Point2& p, const Point2& a, const Point2& b) {
  return orient2d(a, b, p) == 0 && (a.cwiseMin(b).array() <= p.array()).all() &&
         (p.array() <= a.cwiseMax(b).array()).all();
}

std::string program(const Point2& p, const Polygon<double, 2>& polygon) {
  int count = 0;
  for (const Ring<double, 2>& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (on(p, a, b)) return "ON";
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < std::max(a.x(), b.x())) ++count;
    }
  return count % 2 != 0 ? "IN" : "OUT";
}

TwoVerdicts verdicts(const Parameters& values) {
  const Setup s(values);
  const Location truth = s.truth.even_odd;
  return {program(s.p, s.polygon), truth == Location::on ? "ON" : truth == Location::in ? "IN" : "OUT"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a point lies in a polygon, outside it or on its boundary",
      {"count ← 0", "for each edge a b", "    if p on a b: return ON", "    if neither or both are above p: next edge",
       "    if p.x < max(a.x, b.x): count ← count + 1", "return count is odd ? IN : OUT"},
      {5, "if p left of a b, seen upwards: count ← count + 1",
       "A point to the right of a slanted edge may still be left of its right end. Then the ray does not cross the "
       "edge."},
      "inside", {{"p", "2,1.25,0"}});
}

}  // namespace isect::lessons::crossings_lesson
