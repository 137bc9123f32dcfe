#include <isect/methods/sphere_aabb.h>
#include <isect/sphere_aabb.h>

#include <isect/counted.h>
#include "bench/sphere_aabb/families.h"
#include "bench/sphere_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace sphere_aabb_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Sphere<S, N> ball(double x, double y, double radius) {
  Sphere<S, N> b = {Point<S, N>::Zero(), S(radius)};
  b.center[0] = S(x), b.center[1] = S(y);
  return b;
}

template <class S, int N>
Aabb<S, N> cube(double lo, double hi) {
  return {Point<S, N>::Constant(S(lo)), Point<S, N>::Constant(S(hi))};
}

template <class S, int N>
Relation related(const Sphere<S, N>& a, const Aabb<S, N>& b) {
  const Relation r = relate(a, b);
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ball and a box lie in one of six ways", "[sphere_aabb]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = cube<S, N>(-1, 1);
  CHECK(related(ball<S, N>(4, 5, 4), box) == Relation::disjoint);
  CHECK(related(ball<S, N>(4, 5, 5), box) == Relation::touching);  // in an edge
  CHECK(related(ball<S, N>(3, 0, 2), box) == Relation::touching);  // in a face
  CHECK(related(ball<S, N>(4, 5, 6), box) == Relation::overlapping);
  CHECK(related(ball<S, N>(0, 0, 1), box) == Relation::a_inside_b);  // inscribed
  CHECK(related(ball<S, N>(0, 0, 0.5), box) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(0, 0, 2), box) == Relation::b_inside_a);
  CHECK(related(ball<S, N>(1, 1, 0), cube<S, N>(1, 1)) == (N == 2 ? Relation::equal : Relation::disjoint));
}

TEST_CASE("a ball through all corners contains the box", "[sphere_aabb]") {
  const Aabb<double, 3> box = {{-1, -2, -2}, {1, 2, 2}};
  CHECK(relate<double, 3>({{0, 0, 0}, 3}, box) == Relation::b_inside_a);
  CHECK(relate<double, 3>({{0, 0, 0}, std::nextafter(3., 0)}, box) == Relation::overlapping);
  CHECK(relate<double, 3>({{0, 5e-324, 0}, 3}, box) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("an ulp decides at faces and edges", "[sphere_aabb]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = cube<S, N>(-1, 1);
  CHECK(related(ball<S, N>(4, 5, std::nextafter(S(5), S(0))), box) == Relation::disjoint);
  CHECK(related(ball<S, N>(4, 5, std::nextafter(S(5), S(6))), box) == Relation::overlapping);
  CHECK(related(ball<S, N>(std::nextafter(S(3), S(4)), 0, 2), box) == Relation::disjoint);
  CHECK(related(ball<S, N>(std::nextafter(S(3), S(2)), 0, 2), box) == Relation::overlapping);
  CHECK(related(ball<S, N>(0, 0, std::nextafter(S(1), S(2))), box) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("a point and a flat box are sets like others", "[sphere_aabb]", FLOATS_AND_DIMENSIONS) {
  Aabb<S, N> plate = cube<S, N>(-1, 1);
  plate.lo[1] = plate.hi[1] = 0;
  CHECK(related(ball<S, N>(1, 0, 0.5), plate) == Relation::overlapping);
  CHECK(related(ball<S, N>(1.5, 0, 0.5), plate) == Relation::touching);
  CHECK(related(ball<S, N>(0, 0, 4), plate) == Relation::b_inside_a);
  CHECK(related(ball<S, N>(1, 0, 0), plate) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(1, 0, 0), cube<S, N>(-1, 1)) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(2, 0, 0), cube<S, N>(-1, 1)) == Relation::disjoint);
  CHECK(related(ball<S, N>(0, 0, 0), cube<S, N>(-0.0, 0)) == Relation::equal);
  CHECK(related(ball<S, N>(0, 0, 1), cube<S, N>(0, 0)) == Relation::b_inside_a);
}

TEMPLATE_TEST_CASE_SIG("sphere and box: what is empty, NaN or infinite meets nothing", "[sphere_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = cube<S, N>(-1, 1);
  const Sphere<S, N> good = ball<S, N>(0, 0, 3);
  CHECK(related(ball<S, N>(0, 0, -1), box) == Relation::disjoint);
  for (int i = 0; i < N; ++i) {
    Aabb<S, N> inverted = box;
    inverted.lo[i] = 2;
    CHECK(related(good, inverted) == Relation::disjoint);
    for (const double bad : {not_a_number, inf, -inf}) {
      Sphere<S, N> sphere = good;
      sphere.center[i] = S(bad);
      CHECK(related(sphere, box) == Relation::disjoint);
      for (const bool low : {true, false}) {
        Aabb<S, N> wrong = box;
        (low ? wrong.lo : wrong.hi)[i] = S(bad);
        CHECK(related(good, wrong) == Relation::disjoint);
        CHECK(related(sphere, wrong) == Relation::disjoint);
      }
      CHECK(related(ball<S, N>(0, 0, bad), box) == Relation::disjoint);
    }
  }
  CHECK(related(good, cube<S, N>(-inf, inf)) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("sphere and box: lengths of any size give the same verdict", "[sphere_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(related(ball<S, N>(4 * k, 5 * k, 4 * k), cube<S, N>(-k, k)) == Relation::disjoint);
    CHECK(related(ball<S, N>(4 * k, 5 * k, 5 * k), cube<S, N>(-k, k)) == Relation::touching);
    CHECK(related(ball<S, N>(4 * k, 5 * k, 6 * k), cube<S, N>(-k, k)) == Relation::overlapping);
    CHECK(related(ball<S, N>(0, 0, k), cube<S, N>(-k, k)) == Relation::a_inside_b);
    CHECK(related(ball<S, N>(0, 0, 2 * k), cube<S, N>(-k, k)) == Relation::b_inside_a);
  }
  const S top = std::numeric_limits<S>::max();
  CHECK(related(ball<S, N>(0, 0, top), cube<S, N>(-top, top)) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(top, 0, top), cube<S, N>(-top, top)) == Relation::overlapping);
}

TEST_CASE("the note's sum over the axes calls touching and NaN what they are not", "[sphere_aabb]") {
  using sphere_aabb::accumulate_naive;
  const Aabb<double, 3> box = {{-1, -1, -1}, {1, 1, 1}};
  CHECK(accumulate_naive<double, 3>({{2, 0, 0}, 1.5}, box));
  CHECK_FALSE(accumulate_naive<double, 3>({{4, 5, 0}, 4}, box));
  CHECK_FALSE(accumulate_naive<double, 3>({{3, 0, 0}, 2}, box));  // touching, and a strict <
  CHECK(accumulate_naive<double, 3>({{not_a_number, 0, 0}, 1}, box));
  CHECK(accumulate_naive<double, 3>({{0, 0, 0}, 3}, {{1, 1, 1}, {-1, -1, -1}}));  // inverted
}

TEST_CASE("the note's method needs seven multiplications at most, and no square root", "[sphere_aabb]") {
  using C = Counted<double>;
  tally() = {};
  sphere_aabb::accumulate_naive<C, 3>({{2., 2., 2.}, 1.}, {{-1., -1., -1.}, {1., 1., 1.}});
  CHECK(tally() == Tally{.mul = 4, .add = 6, .compare = 7});
}

TEST_CASE("the events tell each axis, the comparison and the signs", "[sphere_aabb]") {
  Record<sphere_aabb::Event<double>> record;
  const Aabb<double, 2> box = {{-1, -1}, {1, 1}};
  sphere_aabb::accumulate_naive<double, 2>({{4, 5}, 5}, box, record);
  REQUIRE(record.events.size() == 3);
  const auto& last = std::get<sphere_aabb::Axis<double>>(record.events[1]);
  CHECK((last.axis == 1 && last.gap == 4 && last.distance2 == 25));
  CHECK(std::get<sphere_aabb::Compared<double>>(record.events[2]).radius2 == 25);

  record.events.clear();
  relate<double, 2>({{4, 5}, 5}, box, record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));
  const auto& decision = std::get<sphere_aabb::Decision>(record.events.back());
  CHECK((decision.nearest == 0 && decision.farthest == 1 && !decision.ball_inside));
}

TEMPLATE_TEST_CASE_SIG("sphere and box: relations are those of rational arithmetic", "[sphere_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Aabb<S, N> box = bench::box<S, N>(random, numbers);
      if (random.one_in(20)) box.lo[random.below(N)] = box.hi[0];
      Sphere<S, N> sphere = bench::ball<S, N>(random, numbers);
      for (int axis = 0; axis < N; ++axis)  // often beside a face, or in the middle
        if (random.one_in(3)) sphere.center[axis] = box.lo[axis] / 2 + box.hi[axis] / 2;
      if (random.one_in(2)) sphere.radius = bench::critical_radius(random, sphere.center, box);
      if (random.one_in(30)) box = {sphere.center, sphere.center};
      if (!finite(sphere)) continue;

      const Relation r = relate(sphere, box);
      if (r != oracle::relation(sphere, box)) FAIL("wrong");
      if (intersects(sphere, box) != (r != Relation::disjoint)) FAIL("not the same by intersects");
      Record<sphere_aabb::Event<double>> record;
      if (relate(sphere, box, record) != r) FAIL("not the same when traced");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(sphere), move(box)) != r) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 20);
}

}  // namespace sphere_aabb_test
