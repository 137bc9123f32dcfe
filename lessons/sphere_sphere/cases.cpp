// All cases of two balls in the plane of two numbers, and the methods side by side.

#include <isect/methods/sphere_sphere.h>
#include "lessons/shared/opinions.h"
#include "lessons/shared/plane.h"
#include "lessons/shared/relation.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

using namespace viz;

namespace {

int branch(const Parameters& p) { return case_of(setup(p).truth); }
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  return {(s.b.center - s.a.center).norm() / s.a.radius, s.b.radius / s.a.radius};
}
/// Puts the second ball at that distance, in the direction in which it lies, and gives it that radius.
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  const Vec3 l = s.b.center - s.a.center;
  const Vec3 direction = l.norm() > 0 ? Vec3(l.normalized()) : Vec3(across() / axis_length);
  Parameters there = p;
  there["b"] = Vec3(s.a.center + to.x() * s.a.radius * direction);
  there["r_b"] = to.y() * s.a.radius;
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"distance *d* between the centres, in units of *r*_a",
                              "radius *r*_b, in units of *r*_a",
                              {0, 0},
                              {6, 3},
                              relation_cases(),
                              branch,
                              place,
                              moved,
                              "Only two numbers matter: the distance and the second radius, both in units of *r*_a.\n"
                              "Touching is not a region but the line *d* = *r*_a + *r*_b; equal balls are one point."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  const Ball3 a = s.tested(s.a), b = s.tested(s.b);
  Opinions all(says_meet(s.truth != Relation::disjoint));
  all.add("squares (<), the note's: *d*^2 < *R*^2", says_meet(sphere_sphere::squared_distance_naive(a, b)));
  all.add("squares: *d*^2 ≤ *R*^2", says_meet(sphere_sphere::closed_squared_distance(a, b)));
  all.add("root: *d* ≤ *R*", says_meet(sphere_sphere::by_distance(a, b)));
  all.add("hypot: *d* ≤ *R*", says_meet(sphere_sphere::by_hypot(a, b)));
  return all.take();
}

}  // namespace isect::lessons::sphere_sphere_lesson
