// Balls and aligned boxes in pairs.

#include "bench/aabb_aabb/families.h"
#include "bench/sphere_aabb/families.h"
#include "bench/sphere_aabb/oracle.h"
#include "bench/sphere_sphere/families.h"
#include "bench/sphere_sphere/oracle.h"
#include "tests/cases/shapes.h"

namespace isect::cases {

namespace {

using oracle::dot, oracle::rational, oracle::operator-;

template <class S, int N>
Case boxes(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  const Json in = both(fields(a, "alo", "ahi"), fields(b, "blo", "bhi"));
  if (!finite(a) || !finite(b)) return policy(in, is_f32<S>);
  bool meet = !empty(a) && !empty(b), more = meet, interiors = meet, a_in_b = meet, b_in_a = meet;
  for (int i = 0; i < N; ++i) {
    meet &= a.lo[i] <= b.hi[i] && b.lo[i] <= a.hi[i];
    const bool one_point = a.lo[i] == a.hi[i] && a.lo[i] == b.lo[i] && a.lo[i] == b.hi[i];
    const bool more_here = a.lo[i] < b.hi[i] && b.lo[i] < a.hi[i];
    more &= more_here, interiors &= more_here || one_point;
    a_in_b &= b.lo[i] <= a.lo[i] && a.hi[i] <= b.hi[i];
    b_in_a &= a.lo[i] <= b.lo[i] && b.hi[i] <= a.hi[i];
  }
  const Relation relation = !meet              ? Relation::disjoint
                            : a_in_b && b_in_a ? Relation::equal
                            : a_in_b           ? Relation::a_inside_b
                            : b_in_a           ? Relation::b_inside_a
                            : interiors        ? Relation::overlapping
                                               : Relation::touching;
  Json expected = {{"intersects", meet},
                   {"interiors_intersect", more},
                   {"a_contains_b", b_in_a},
                   {"b_contains_a", a_in_b},
                   {"relation", word(relation)}};
  return {in, expected, is_f32<S>};
}

/// Distinguishes the two ways to touch from inside from plain containment.
template <class S, int N>
std::string tangency(Relation relation, const Sphere<S, N>& a, const Sphere<S, N>& b) {
  if (relation == Relation::touching) return "touch_outer";
  if (relation != Relation::a_inside_b && relation != Relation::b_inside_a) return word(relation);
  const auto f = rational(a.center) - rational(b.center);
  const Rational gap = Rational(a.radius) - Rational(b.radius);
  if (dot(f, f) != gap * gap) return word(relation);
  return a.radius == 0 || b.radius == 0 ? "touch_inner" : "touch_inner_" + word(relation);
}
template <class S, int N>
Case balls(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  const Json in = both(fields(a, "c1", "r1"), fields(b, "c2", "r2"));
  if (!finite(a) || !finite(b)) return policy(in, is_f32<S>);
  const Relation r = oracle::relation(a, b);
  return {in, {{"intersects", r != Relation::disjoint}, {"relation", tangency(r, a, b)}}, is_f32<S>};
}

template <class S, int N>
Case ball_and_box(const Sphere<S, N>& ball, const Aabb<S, N>& box) {
  const Json in = both(fields(ball), fields(box));
  if (!finite(ball) || !finite(box)) return policy(in, is_f32<S>);
  const Relation r = oracle::relation(ball, box);
  const std::string name = r == Relation::a_inside_b   ? "box_contains_sphere"
                           : r == Relation::b_inside_a ? "sphere_contains_box"
                                                       : word(r);
  return {in, {{"intersects", r != Relation::disjoint}, {"relation", name}}, is_f32<S>};
}

}  // namespace

CaseFile box_box() {
  CaseFile file("box_box");
  const auto add = [&](const char* note, Aabb<double, 2> a, Aabb<double, 2> b) { file.add(note, boxes(a, b)); };
  add("a corner at a corner", {{0, 0}, {.7, .7}}, {{.7, .7}, {.9, .9}});
  add("an ulp beside that corner", {{0, 0}, {.7, .7}}, {{std::nextafter(.7, 1), .7}, {.9, .9}});
  add("zeros of either sign touch", {{-1, -1}, {-0., 1}}, {{0, -1}, {1, 1}});
  add("without thickness, piercing the other", {{0, -1}, {0, 1}}, {{-1, -.5}, {1, .5}});
  add("points", {{.3, .1}, {.3, .1}}, {{.3, .1}, {.3, .1}});
  add("an inverted box is empty, even in itself", {{1, 0}, {0, 1}}, {{1, 0}, {0, 1}});
  add("an inner touch", {{0, 0}, {1, 1}}, {{0, .5}, {1, .6}});
  add("centers that overflow", {{most / 2, 0}, {most, 1}}, {{-most, 0}, {most / 2, 1}});
  add("halves that vanish", {{0, 0}, {least, least}}, {{least, least}, {1, 1}});
  const auto ask = [](const auto& c) { return boxes(c.a, c.b); };
  by_families(file, 6, bench::aabb_aabb_draws<double>, bench::aabb_aabb_draws<float>, ask);
  return file;
}

CaseFile sphere_sphere() {
  CaseFile file("sphere_sphere");
  const auto add = [&](const char* note, Sphere<double, 2> a, Sphere<double, 2> b) { file.add(note, balls(a, b)); };
  add(".1 and .2, .3 apart: a touch as typed, not as rounded", {{0, 0}, .1}, {{.3, 0}, .2});
  add("a square that vanishes in floats", {{0, 0}, 0x1p-80}, {{0x1p-76, 0}, 0x1p-80});
  add("a square that overflows in floats", {{0, 0}, 0x1p63}, {{0x1p65, 0}, 0x1p63});
  add("a square that vanishes", {{0, 0}, 1e-200}, {{1e-199, 0}, 1e-200});
  add("a square that overflows", {{0, 0}, 1e200}, {{1e201, 0}, 1e200});
  add("a distance that overflows", {{-most, 0}, most}, {{most, 0}, most});
  add("an inner touch", {{0, 0}, 5}, {{3, 0}, 2});
  add("a point on the surface", {{0, 0}, 5}, {{3, 4}, 0});
  add("two equal points", {{.1, .2}, 0}, {{.1, .2}, -0.});
  add("two different points", {{0, 0}, 0}, {{least, 0}, 0});
  add("an empty ball in a large one", {{0, 0}, 10}, {{0, 0}, -1});
  add("equal but for an ulp of the radius", {{0, 0}, .3}, {{0, 0}, std::nextafter(.3, 1)});
  add("1e-300 beside 1e300", {{1e300, 0}, 1e300}, {{0, 0}, 1e-300});
  const auto ask = [](const auto& c) { return balls(c.a, c.b); };
  by_families(file, 6, bench::sphere_sphere_draws<double>, bench::sphere_sphere_draws<float>, ask);
  return file;
}

CaseFile sphere_box() {
  CaseFile file("sphere_box");
  const auto add = [&](const char* note, Sphere<double, 2> ball, Aabb<double, 2> box) {
    file.add(note, ball_and_box(ball, box));
  };
  add("at a corner, by 3, 4 and 5", {{4, 5}, 5}, {{0, 0}, {1, 1}});
  add("an ulp beside the corner", {{4, 5}, std::nextafter(5., 0.)}, {{0, 0}, {1, 1}});
  add("an inner touch of all four sides", {{0, 0}, 1}, {{-1, -1}, {1, 1}});
  add("all four corners on the sphere", {{0, 0}, 5}, {{-3, -4}, {3, 4}});
  add("a point in a point", {{.1, .1}, 0}, {{.1, .1}, {.1, .1}});
  add("a box without thickness through the center", {{0, 0}, 1}, {{-2, 0}, {2, 0}});
  add("an inverted box around the center", {{0, 0}, 9}, {{1, 1}, {-1, -1}});
  add("an empty ball in the box", {{0, 0}, -1}, {{-9, -9}, {9, 9}});
  add("a square that vanishes", {{2e-200, 0}, .5e-200}, {{0, 0}, {1e-200, 1e-200}});
  add("a square that overflows", {{3e200, 0}, 1e200}, {{0, 0}, {1e200, 1e200}});
  add("distances that overflow", {{most, most}, most}, {{-most, -most}, {0, 0}});
  const auto ask = [](const auto& c) { return ball_and_box(c.a, c.b); };
  by_families(file, 6, bench::sphere_aabb_draws<double>, bench::sphere_aabb_draws<float>, ask);
  return file;
}

}  // namespace isect::cases
