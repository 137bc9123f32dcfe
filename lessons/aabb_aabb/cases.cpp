// All cases of two boxes, one shifted along two axes, and the methods side by side.

#include <array>
#include <limits>

#include <isect/methods/aabb_aabb.h>
#include "lessons/aabb_aabb/picture.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::aabb_aabb_lesson {

using namespace viz;

namespace {

enum Case { z_gap, x_gap, y_gap, overlapping, touching, inside, equal };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  for (int axis = 0; axis < 3; ++axis)
    if (!intersects(s.a.along(axis), s.b.along(axis))) return std::array{x_gap, y_gap, z_gap}[axis];
  return s.truth == Relation::overlapping ? overlapping
         : s.truth == Relation::touching  ? touching
         : s.truth == Relation::equal     ? equal
                                          : inside;
}
/// The way from the middle of a to the middle of b; NaN if a box is empty.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  if (empty(s.a) || empty(s.b)) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return ((s.b.lo + s.b.hi) / 2 - (s.a.lo + s.a.hi) / 2).head<2>();
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  const Vec2 by = to - ((s.b.lo + s.b.hi) / 2 - (s.a.lo + s.a.hi) / 2).head<2>();
  Parameters there = p;
  there["b_min"] = Vec3(s.b.lo + Vec3(by.x(), by.y(), 0));
  there["b_max"] = Vec3(s.b.hi + Vec3(by.x(), by.y(), 0));
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* from the centre of a to the centre of b",
      "*y* from the centre of a to the centre of b",
      {-7.5, -3},
      {7.5, 3},
      {"gap on *z*", "gap on *x*", "gap on *y*", "overlapping", "touching", "one inside the other", "equal"},
      branch,
      place,
      moved,
      "The second box is shifted along *x* and *y*; its size and its *z* are fixed.\n"
      "A gap on *x* ends the test first, so *y* is tested only between those two bands."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(says_meet(s.truth != Relation::disjoint));
  all.add("axis by axis", says_meet(aabb_aabb::by_axis(s.a, s.b)));
  all.add("the note's figure: *x* alone", says_meet(intersects(s.a.along(0), s.b.along(0))));
  all.add("largest low, smallest high corner", says_meet(aabb_aabb::min_max(s.a, s.b)));
  all.add("centres and half-extents", says_meet(aabb_aabb::by_centers(s.a, s.b)));
  return all.take();
}

}  // namespace isect::lessons::aabb_aabb_lesson
