#include <isect/shapes.h>

#include <cmath>
#include <limits>

#include <isect/conventions.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace shapes_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {}

TEMPLATE_TEST_CASE("an interval holds both of its ends", "[shapes]", float, double) {
  const Interval<TestType> interval = {TestType(-1), TestType(2)};
  CHECK(interval.contains(-1));
  CHECK(interval.contains(0));
  CHECK(interval.contains(2));
  CHECK_FALSE(interval.contains(std::nextafter(TestType(2), TestType(3))));
  CHECK_FALSE(interval.contains(std::nextafter(TestType(-1), TestType(-2))));
}

TEST_CASE("an interval with lo > hi holds nothing, not even its ends", "[shapes]") {
  const Interval<double> empty = {1, -1};
  CHECK_FALSE(empty.contains(1));
  CHECK_FALSE(empty.contains(0));
  CHECK_FALSE(empty.contains(-1));
}

TEST_CASE("an interval of one point holds that point, and minus zero equals zero", "[shapes]") {
  const Interval<double> zero = {0, 0};
  CHECK(zero.contains(0));
  CHECK(zero.contains(-0.0));
  CHECK(zero == Interval<double>{-0.0, -0.0});
  CHECK_FALSE(zero.contains(5e-324));
}

TEST_CASE("NaN lies in no interval, and an interval with NaN holds nothing", "[shapes]") {
  CHECK_FALSE(infinite<double>.contains(not_a_number));
  CHECK_FALSE((Interval<double>{not_a_number, 1}).contains(0));
  CHECK_FALSE((Interval<double>{0, not_a_number}).contains(0));
  CHECK_FALSE(Interval<double>{not_a_number, 1} == Interval<double>{not_a_number, 1});
}

TEMPLATE_TEST_CASE("the named ranges reach as far as their names say", "[shapes]", float, double) {
  constexpr TestType most = std::numeric_limits<TestType>::max();
  CHECK(semi_infinite<TestType>.contains(0));
  CHECK(semi_infinite<TestType>.contains(most));
  CHECK_FALSE(semi_infinite<TestType>.contains(-std::numeric_limits<TestType>::denorm_min()));
  CHECK(infinite<TestType>.contains(-most));
  CHECK(infinite<TestType>.contains(most));
}

TEMPLATE_TEST_CASE_SIG("a ray is semi-infinite unless told otherwise", "[shapes]", ((class S, int N), S, N), (float, 2),
                       (double, 2), (float, 3), (double, 3)) {
  const Ray<S, N> ray = {Point<S, N>::Zero(), Vector<S, N>::Unit(0)};
  CHECK(ray.range == semi_infinite<S>);
}

TEMPLATE_TEST_CASE_SIG("r(t) = o + t d, in units of the direction's length", "[shapes]", ((class S, int N), S, N),
                       (float, 2), (double, 2), (float, 3), (double, 3)) {
  const Ray<S, N> ray = {Point<S, N>::Constant(1), 4 * Vector<S, N>::Unit(1)};
  CHECK(ray.at(0) == ray.origin);
  CHECK(ray.at(S(0.5)) == Point<S, N>::Constant(1) + 2 * Vector<S, N>::Unit(1));
  CHECK(ray.at(-1)[1] == -3);
}

TEMPLATE_TEST_CASE_SIG("a segment runs from t = 0 at p to t = 1 at q", "[shapes]", ((class S, int N), S, N), (float, 2),
                       (double, 2), (float, 3), (double, 3)) {
  const Point<S, N> p = Point<S, N>::Constant(-1), q = Point<S, N>::Constant(3);
  const Ray<S, N> ray = segment<S, N>(p, q);
  CHECK(ray.range == Interval<S>{0, 1});
  CHECK(ray.at(0) == p);
  CHECK(ray.at(1) == q);
}

TEST_CASE("a segment's direction is rounded, so that t = 1 may miss q by an ulp", "[shapes]") {
  const Point<double, 2> p = {1e16, 0}, q = {1, 1};
  CHECK(segment<double, 2>(p, q).at(1)[0] != q[0]);
  CHECK(segment<double, 2>(p, q).at(1)[1] == q[1]);
}

TEST_CASE("an infinite range is a line, and t may be infinite only there", "[shapes]") {
  CHECK(infinite<double> == Interval<double>{-inf, inf});
  CHECK(std::isinf(semi_infinite<float>.hi));
}

TEMPLATE_TEST_CASE_SIG("a capsule is empty below radius 0, and finite where each of its numbers is", "[shapes]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> good = {Point<S, N>::Zero(), Point<S, N>::Ones(), S(0)};
  CHECK_FALSE(empty(good));
  CHECK_FALSE(empty(Capsule<S, N>{good.p, good.q, S(-0.0)}));
  CHECK(empty(Capsule<S, N>{good.p, good.q, -std::numeric_limits<S>::denorm_min()}));
  CHECK(empty(Capsule<S, N>{good.p, good.q, S(not_a_number)}));
  CHECK(finite(good));
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(finite(Capsule<S, N>{good.p, good.q, S(bad)}));
    for (int i = 0; i < N; ++i) {
      Capsule<S, N> p = good, q = good;
      p.p[i] = q.q[i] = S(bad);
      CHECK_FALSE(finite(p));
      CHECK_FALSE(finite(q));
    }
  }
}

TEMPLATE_TEST_CASE("a cylinder and a cone are empty below radius 0 or without an axis, and finite where each number is",
                   "[shapes]", float, double) {
  using S = TestType;
  const auto ask = [](const Point<S, 3>& p, const Point<S, 3>& q, S radius, bool has_none, bool is_finite) {
    const Cylinder<S> cylinder = {p, q, radius};
    const Cone<S> cone = {p, q, radius};
    CHECK((empty(cylinder) == has_none && empty(cone) == has_none));
    CHECK((finite(cylinder) == is_finite && finite(cone) == is_finite));
    if (!is_finite) return;
    CHECK((cast<float>(cylinder).q == q.template cast<float>() && cast<float>(cone).base == q.template cast<float>()));
    CHECK((cast<double>(cylinder).p == p.template cast<double>() && cast<double>(cone).radius == double(radius)));
  };
  const Point<S, 3> p = {0, 1, 2}, q = {0, 1, S(2.1)};
  ask(p, q, 0, false, true);
  ask(p, q, S(-0.0), false, true);
  ask(p, q, -std::numeric_limits<S>::denorm_min(), true, true);
  ask(p, p, 1, true, true);
  ask({0, 0, 0}, {0, S(-0.0), 0}, 1, true, true);
  ask(p, q, S(not_a_number), true, false);
  ask(p, {0, 1, S(inf)}, 1, false, false);
  ask({0, S(not_a_number), 0}, q, 1, false, false);
}

TEST_CASE("a capsule in another scalar is that of its ends and its radius", "[shapes]") {
  const Capsule<double, 3> c = {{1, 2, 3}, {4, 5, 1.1}, 0.1};
  const Capsule<float, 3> rounded = cast<float>(c);
  CHECK((rounded.p == Point<float, 3>(1, 2, 3) && rounded.q == Point<float, 3>(4, 5, 1.1f) && rounded.radius == 0.1f));
  CHECK(cast<double>(rounded).radius == static_cast<double>(0.1f));
}

TEMPLATE_TEST_CASE_SIG("a point of a ray is within its bound of the true one", "[shapes]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(bench::stream(tests::seed(), "points of rays"));
  using oracle::Rational;
  const Rational eps = std::numeric_limits<S>::epsilon(), least = std::numeric_limits<S>::denorm_min();
  int asked = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(2000, 50000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Ray<S, N> ray = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
      const S t = bench::number<S>(random, random.one_in(2) ? numbers : bench::Numbers::ordinary);
      const Point<S, N> p = ray.at(t);
      for (int k = 0; k < N; ++k) {
        if (!std::isfinite(p[k])) continue;
        const Rational o = ray.origin[k], way = Rational(t) * Rational(ray.direction[k]);
        REQUIRE(abs(Rational(p[k]) - (o + way)) <= eps * (abs(o) + abs(way)) + least);
        ++asked;
      }
    }
  CHECK(asked > 10000);
}

}  // namespace shapes_test
