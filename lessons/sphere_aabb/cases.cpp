// All cases of a ball beside a box: the centre's plane, with the box's nearest feature.

#include <array>
#include <limits>

#include "lessons/sphere_aabb/picture.h"

namespace isect::lessons::sphere_aabb_lesson {
namespace {

using namespace viz;

enum Case { disjoint, face, edge, corner, only_grown, within, ball_inside, box_inside, touching };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  switch (s.truth) {
    case Relation::disjoint:
      return s.in_grown ? only_grown : disjoint;
    case Relation::touching:
      return touching;
    case Relation::a_inside_b:
    case Relation::equal:
      return ball_inside;
    case Relation::b_inside_a:
      return box_inside;
    case Relation::overlapping:
      break;
  }
  return std::array{within, face, edge, corner}[s.feature()];
}

/// The way from the middle of the box to the centre of the ball; NaN if the box is empty.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  if (empty(s.box)) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return (s.ball.center - (s.box.lo + s.box.hi) / 2).head<2>();
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  const Vec3 middle = (s.box.lo + s.box.hi) / 2;
  Parameters there = p;
  there["c"] = Vec3(middle.x() + to.x(), middle.y() + to.y(), s.ball.center.z());
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* from the centre of the box to **c**",
      "*y* from the centre of the box to **c**",
      {-5, -2},
      {5, 2},
      {"disjoint", "face", "edge", "corner", "expanded only", "**c** inside", "ball inside", "box inside", "touching"},
      branch,
      place,
      moved,
      "The centre moves over *x* and *y*; its *z* and the radius are fixed.\n"
      "Face, edge, corner: where the box's point nearest to **c** lies. Expanded only: where the expanded box errs, as "
      "its edges and corners are not round."};
  return map;
}

}  // namespace isect::lessons::sphere_aabb_lesson
