// Capsules against balls and against each other.

#include "bench/capsule_capsule/families.h"
#include "bench/capsule_capsule/oracle.h"
#include "tests/cases/shapes.h"

namespace isect::cases {

namespace {

template <class S, int N>
Case ball_and_capsule(const Sphere<S, N>& ball, const Capsule<S, N>& capsule) {
  const Json in = both(fields(ball), fields(capsule));
  if (!finite(ball) || !finite(capsule)) return policy(in, is_f32<S>);
  const Relation r = oracle::relation(ball, capsule);
  const std::string name = r == Relation::a_inside_b   ? "capsule_contains_sphere"
                           : r == Relation::b_inside_a ? "sphere_contains_capsule"
                                                       : word(r);
  return {in, {{"intersects", r != Relation::disjoint}, {"relation", name}}, is_f32<S>};
}

template <class S, int N>
Case capsules(const Capsule<S, N>& a, const Capsule<S, N>& b) {
  const Json in = {{"a", fields(a)}, {"b", fields(b)}};
  if (!finite(a) || !finite(b)) return policy(in, is_f32<S>);
  return {in, related(oracle::relation(a, b)), is_f32<S>};
}

}  // namespace

CaseFile sphere_capsule() {
  CaseFile file("sphere_capsule");
  const auto add = [&](const char* note, Sphere<double, 2> ball, Capsule<double, 2> capsule) {
    file.add(note, ball_and_capsule(ball, capsule));
  };
  add("at a slanted side, by 3, 4 and 5", {{-3, 4}, 2}, {{-8, -6}, {12, 9}, 3});
  add("an ulp beside that side", {{-3, 4}, std::nextafter(2., 0.)}, {{-8, -6}, {12, 9}, 3});
  add("at an end, by 3, 4 and 5", {{6, 4}, 3}, {{-3, 0}, {3, 0}, 2});
  add("an inner touch of both sides", {{1, 0}, 2}, {{-3, 0}, {3, 0}, 2});
  add("both ends touch the sphere from inside", {{0, 4}, 6}, {{-3, 0}, {3, 0}, 1});
  add("one end does, the other juts out by an ulp", {{0, 4}, 6}, {{-3, 0}, {std::nextafter(3., 4.), 0}, 1});
  add("a capsule that is the ball", {{.1, .2}, .3}, {{.1, .2}, {.1, .2}, .3});
  add("a segment through the ball", {{0, 0}, 1}, {{-2, 0}, {2, 0}, 0});
  add("a point on a segment", {{.25, .75}, 0}, {{0, 0}, {1, 3}, 0});
  add("a point an ulp beside a segment", {{.25, std::nextafter(.75, 1)}, 0}, {{0, 0}, {1, 3}, 0});
  add("an empty ball in the capsule", {{0, 0}, -1}, {{-9, 0}, {9, 0}, 9});
  add("an empty capsule in the ball", {{0, 0}, 9}, {{-1, 0}, {1, 0}, -1});
  add("the smallest ball beside the longest capsule", {{0, 2 * least}, least}, {{-most, 0}, {most, 0}, least});
  add("lengths that overflow", {{0, most}, most / 2}, {{-most, 0}, {most, 0}, most / 2});
  const auto ask = [](const auto& c) { return ball_and_capsule(c.a, c.b); };
  by_families(file, 4, bench::sphere_capsule_draws<double>, bench::sphere_capsule_draws<float>, ask);
  return file;
}

CaseFile capsule_capsule() {
  CaseFile file("capsule_capsule");
  const auto add = [&](const char* note, Capsule<double, 3> a, Capsule<double, 3> b) {
    file.add(note, capsules(a, b));
  };
  const Capsule<double, 3> lying = {{-4, 0, 0}, {4, 0, 0}, 2}, long_one = {{-1e8, 0, 0}, {1e8, 0, 0}, 1};
  add("passing each other, in touch", lying, {{2, 3, 5}, {-2, -3, 5}, 3});
  add("passing each other, an ulp apart", lying, {{2, 3, 5}, {-2, -3, 5}, std::nextafter(3., 0.)});
  add("at a right angle to the first, but past its end", lying, {{7, -1, 4}, {7, 1, 4}, 3});
  add("two ends, by 3, 4 and 5", lying, {{7, 4, 0}, {9, 9, 1}, 3});
  add("an end at the side", lying, {{1, 3, 4}, {5, 6, 7}, 3});
  add("parallel, in touch along a stretch", lying, {{0, 3, 4}, {9, 3, 4}, 3});
  add("parallel, in touch at the ends", lying, {{7, 4, 0}, {9, 4, 0}, 3});
  add("one behind the other", lying, {{9, 0, 0}, {11, 0, 0}, 3});
  add("nearly parallel, in touch where they pass", long_one, {{-1e8, -1e-8, 3}, {1e8, 1e-8, 3}, 2});
  add("nearly parallel, an ulp apart", long_one, {{-1e8, -1e-8, 3}, {1e8, 1e-8, 3}, std::nextafter(2., 0.)});
  add("nearly parallel, one end lower by a hair", long_one, {{-1e8, 0, 3}, {1e8, 0, std::nextafter(3., 0.)}, 2});
  add("equal, with the ends swapped", lying, {{4, 0, 0}, {-4, 0, 0}, 2});
  add("an inner touch at both ends", lying, {{-4, 1, 0}, {4, 0, -1}, 1});
  add("segments that cross", {{-1, -1, 0}, {1, 1, 0}, 0}, {{-1, 1, 0}, {1, -1, 0}, 0});
  add("segments that miss by the least", {{-1, -1, 0}, {1, 1, 0}, 0}, {{-1, 1, least}, {1, -1, least}, 0});
  add("segments that share a stretch", {{0, 0, 0}, {2, 4, 6}, 0}, {{1, 2, 3}, {3, 6, 9}, 0});
  add("a segment in a capsule", lying, {{-4, 2, 0}, {4, 0, 2}, -0.});
  add("two equal points", {{.1, .2, .3}, {.1, .2, .3}, 0}, {{.1, .2, .3}, {.1, .2, .3}, 0});
  add("an empty one in the other", lying, {{-1, 0, 0}, {1, 0, 0}, -1});
  add("lengths that overflow", {{-most, 0, 0}, {most, 0, 0}, most / 2}, {{0, -most, most}, {0, most, most}, most / 2});
  const auto ask = [](const auto& c) { return capsules(c.a, c.b); };
  by_families(file, 3, bench::capsule_capsule_draws<double>, bench::capsule_capsule_draws<float>, ask);
  return file;
}

}  // namespace isect::cases
