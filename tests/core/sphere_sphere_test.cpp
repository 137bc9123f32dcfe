#include <isect/methods/sphere_sphere.h>
#include <isect/sphere_sphere.h>

#include <isect/counted.h>
#include "bench/sphere_sphere/families.h"
#include "bench/sphere_sphere/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace sphere_sphere_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Sphere<S, N> ball(double x, double y, double radius) {
  Sphere<S, N> b = {Point<S, N>::Zero(), S(radius)};
  b.center[0] = S(x), b.center[1] = S(y);
  return b;
}

/// The relation, checked in both orders.
template <class S, int N>
Relation related(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  const Relation r = relate(a, b);
  CHECK(relate(b, a) == reversed(r));
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(intersects(b, a) == (r != Relation::disjoint));
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("two balls lie in one of six ways", "[sphere_sphere]", FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> a = ball<S, N>(0, 0, 5);
  CHECK(related(a, ball<S, N>(5, 5, 2)) == Relation::disjoint);
  CHECK(related(a, ball<S, N>(6, 8, 5)) == Relation::touching);
  CHECK(related(a, ball<S, N>(3, 4, 3)) == Relation::overlapping);
  CHECK(related(a, ball<S, N>(1, 1, 2)) == Relation::b_inside_a);
  CHECK(related(ball<S, N>(1, 1, 2), a) == Relation::a_inside_b);
  CHECK(related(a, ball<S, N>(0, 0, 5)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("inner tangency is containment, and an ulp ends it", "[sphere_sphere]", FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> a = ball<S, N>(0, 0, 10);
  CHECK(related(a, ball<S, N>(3, 4, 5)) == Relation::b_inside_a);
  CHECK(related(a, ball<S, N>(3, 4, std::nextafter(S(5), S(6)))) == Relation::overlapping);
  CHECK(related(a, ball<S, N>(3, std::nextafter(S(4), S(5)), 5)) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("two spheres: an ulp decides between apart, touching and overlapping", "[sphere_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> a = ball<S, N>(-3, -4, 4);
  CHECK(related(a, ball<S, N>(0, 0, 1)) == Relation::touching);
  CHECK(related(a, ball<S, N>(0, 0, std::nextafter(S(1), S(0)))) == Relation::disjoint);
  CHECK(related(a, ball<S, N>(0, 0, std::nextafter(S(1), S(2)))) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("concentric balls contain one another", "[sphere_sphere]", FLOATS_AND_DIMENSIONS) {
  const S larger = std::nextafter(S(0.3), S(1));
  CHECK(related(ball<S, N>(0.1, 0.7, 0.3), ball<S, N>(0.1, 0.7, larger)) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(0.1, 0.7, 0.3), ball<S, N>(0.1, 0.7, 0.3)) == Relation::equal);
  CHECK(related(ball<S, N>(0.0, 0, 0.3), ball<S, N>(-0.0, 0, 0.3)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("a ball of radius 0 is a point", "[sphere_sphere]", FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> a = ball<S, N>(0, 0, 5);
  CHECK(related(ball<S, N>(3, 4, 0), a) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(1, 1, -0.0), a) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(4, 4, 0), a) == Relation::disjoint);
  CHECK(related(ball<S, N>(4, 4, 0), ball<S, N>(4, 4, 0)) == Relation::equal);
  CHECK(related(ball<S, N>(4, 4, 0), ball<S, N>(4, std::nextafter(S(4), S(5)), 0)) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("empty balls, NaN and infinite coordinates meet nothing", "[sphere_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> good = ball<S, N>(0, 0, 5);
  CHECK(related(good, ball<S, N>(0, 0, -1)) == Relation::disjoint);
  CHECK(related(ball<S, N>(0, 0, -1), ball<S, N>(0, 0, -1)) == Relation::disjoint);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(related(good, ball<S, N>(0, 0, bad)) == Relation::disjoint);
    CHECK(related(ball<S, N>(0, 0, bad), ball<S, N>(0, 0, bad)) == Relation::disjoint);
    for (int i = 0; i < N; ++i) {
      Sphere<S, N> b = good;
      b.center[i] = S(bad);
      CHECK(related(good, b) == Relation::disjoint);
      CHECK(related(b, b) == Relation::disjoint);
      CHECK(related(ball<S, N>(0, 0, bad), b) == Relation::disjoint);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("two spheres: lengths of any size give the same verdict", "[sphere_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 5;
  for (const int e : {-most, -most / 2, 0, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(related(ball<S, N>(0, 0, 2 * k), ball<S, N>(3 * k, 4 * k, 2 * k)) == Relation::disjoint);
    CHECK(related(ball<S, N>(0, 0, 2 * k), ball<S, N>(3 * k, 4 * k, 3 * k)) == Relation::touching);
    CHECK(related(ball<S, N>(0, 0, 2 * k), ball<S, N>(3 * k, 4 * k, 4 * k)) == Relation::overlapping);
    CHECK(related(ball<S, N>(0, 0, 12 * k), ball<S, N>(3 * k, 4 * k, 7 * k)) == Relation::b_inside_a);
  }
  const S top = std::numeric_limits<S>::max();
  CHECK(related(ball<S, N>(top, 0, top), ball<S, N>(-top, 0, top)) == Relation::touching);
  CHECK(related(ball<S, N>(top, top, top), ball<S, N>(-top, -top, top)) == Relation::disjoint);
}

TEST_CASE("the published cases that naive code gets wrong are decided rightly", "[sphere_sphere]") {
  const auto apart = [](float d, float r) {
    const Sphere<float, 3> a = {{0, 0, 0}, r}, b = {{d, 0, 0}, r};
    CHECK_FALSE(intersects(a, b));
    return sphere_sphere::squared_distance_naive(a, b);
  };
  CHECK_FALSE(apart(1e-23f, 1e-24f));  // both squares vanish
  CHECK_FALSE(apart(3e19f, 1e19f));    // both squares are infinite
  const Sphere<float, 3> a = {{0, 0, 0}, .1f}, b = {{.3f, 0, 0}, .2f};
  CHECK(relate(a, b) == Relation::disjoint);  // .1f + .2f < .3f exactly, and rounds to it
  CHECK_FALSE(
      sphere_sphere::squared_distance_naive<float, 3>({{0, 0, 0}, 1}, {{2, 0, 0}, 1}));  // touching: the note's <
  CHECK(intersects(Sphere<float, 3>{{0, 0, 0}, 1}, Sphere<float, 3>{{2, 0, 0}, 1}));
}

TEST_CASE("the note's test needs no square root", "[sphere_sphere]") {
  using C = Counted<double>;
  const Sphere<C, 3> a = {{0., 0., 0.}, 1.}, b = {{1., 1., 1.}, 1.};
  tally() = {};
  CHECK(sphere_sphere::squared_distance_naive(a, b));
  CHECK(tally().sqrt == 0);
  CHECK(tally().div == 0);
  CHECK(tally().compare == 1);
}

TEST_CASE("the events tell the signs, the note's numbers and each fallback", "[sphere_sphere]") {
  using Ball = Sphere<double, 3>;
  Record<sphere_sphere::Event> record;
  relate(Ball{{0, 0, 0}, 1}, Ball{{1, 0, 0}, 1}, record);
  REQUIRE(record.events.size() == 1);
  CHECK(std::get<sphere_sphere::Decision>(record.events[0]).outer == -1);
  CHECK(std::get<sphere_sphere::Decision>(record.events[0]).inner == 1);
  record.events.clear();
  relate(Ball{{0, 0, 0}, .1}, Ball{{.3, 0, 0}, .2}, record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));
  Record<sphere_sphere::Compared<double>> naive;
  sphere_sphere::squared_distance_naive<double, 3>({{0, 0, 0}, 1}, {{3, 0, 0}, 1}, naive);
  CHECK(naive.events.at(0).distance2 == 9);
  CHECK(naive.events.at(0).sum2 == 4);
}

TEMPLATE_TEST_CASE_SIG("two spheres: relations are those of rational arithmetic", "[sphere_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Sphere<S, N> a = bench::ball<S, N>(random, numbers);
      Sphere<S, N> b = bench::ball<S, N>(random, numbers);
      if (random.one_in(3)) b = bench::neighbour(random, a);
      if (random.one_in(10)) b.center = a.center;
      if (random.one_in(20)) b = a;
      if (!finite(b)) continue;

      Record<sphere_sphere::Event> record;
      const Relation r = relate(a, b, record);
      if (r != oracle::relation(a, b)) FAIL("wrong");
      if (relate(a, b) != r || relate(b, a) != reversed(r)) FAIL("not consistent");
      if (intersects(a, b) != (r != Relation::disjoint)) FAIL("not the same by intersects");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(a), move(b)) != r) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 50);
}

}  // namespace sphere_sphere_test
