// A program that culls a box, with one wrong line: it asks the n-vertex where the p-vertex decides.

#include <isect/aabb_frustum.h>
#include "lessons/culling/picture.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

namespace {

std::string program(const Box& box, const Frustum<double>& view) {
  for (const Plane<double, 3>& plane : view.planes) {
    const Vec3& n = plane.normal;
    const Vec3 v = (n.array() < 0).select(box.hi, box.lo);
    if (n.dot(v) + plane.d < 0) return "OUTSIDE";
  }
  return "DRAWN";
}

/// The question is asked of one box alone.
TwoVerdicts verdicts(const Parameters& p) {
  if (std::get<std::string>(p.at("volume")) != "box") return {};
  const Vec3 &center = std::get<Vec3>(p.at("p")), half = Vec3::Constant(std::get<double>(p.at("size")));
  const Box box = {center - half, center + half};
  const Frustum<double> view = frustum(std::get<Vec3>(p.at("eye")));
  return {program(box, view), isect::cull(box, view) == Culling::outside ? "OUTSIDE" : "DRAWN"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a box lies beyond a plane of the frustum, or is to be drawn",
      {"for each plane n · x + D ≥ 0 of the frustum", "    v ← the corner of the box least far along n",
       "    if n · v + D < 0: return OUTSIDE", "return DRAWN"},
      {2, "v ← the corner of the box farthest along n",
       "A box is beyond a plane if its p-vertex is: (*b*_{max,x}, *b*_{min,y}, *b*_{max,z}) for **n** = (1, −2, 1/2). "
       "The n-vertex, opposite, only tells whether all of the box is on the inner side."},
      "inside", {{"p", "1.5,0.25,2.25"}});
}

}  // namespace isect::lessons::culling_lesson
