#include <isect/interval_interval.h>

#include <isect/counted.h>
#include "bench/aabb_aabb/oracle.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace interval_interval_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Relation related(double a_lo, double a_hi, double b_lo, double b_hi) {
  const Interval<S> a = {S(a_lo), S(a_hi)}, b = {S(b_lo), S(b_hi)};
  const Relation r = relate(a, b);
  CHECK(relate(b, a) == reversed(r));
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(intersects(b, a) == (r != Relation::disjoint));
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE("two intervals lie in one of six ways", "[interval_interval]", float, double) {
  CHECK(related<TestType>(0, 1, 2, 3) == Relation::disjoint);
  CHECK(related<TestType>(0, 1, 1, 3) == Relation::touching);
  CHECK(related<TestType>(0, 2, 1, 3) == Relation::overlapping);
  CHECK(related<TestType>(1, 2, 0, 3) == Relation::a_inside_b);
  CHECK(related<TestType>(0, 3, 0, 2) == Relation::b_inside_a);
  CHECK(related<TestType>(0, 3, 0, 3) == Relation::equal);
}

TEMPLATE_TEST_CASE("a point is an interval", "[interval_interval]", float, double) {
  CHECK(related<TestType>(1, 1, 0, 3) == Relation::a_inside_b);
  CHECK(related<TestType>(3, 3, 0, 3) == Relation::a_inside_b);
  CHECK(related<TestType>(1, 1, 1, 1) == Relation::equal);
  CHECK(related<TestType>(1, 1, 2, 2) == Relation::disjoint);
  CHECK(related<TestType>(-0.0, 0, 0, -0.0) == Relation::equal);
}

TEMPLATE_TEST_CASE("two intervals: an ulp decides", "[interval_interval]", float, double) {
  const TestType one = 1, above = std::nextafter(one, TestType(2)), tiny = std::numeric_limits<TestType>::denorm_min();
  CHECK(related<TestType>(0, one, one, 2) == Relation::touching);
  CHECK(related<TestType>(0, one, above, 2) == Relation::disjoint);
  CHECK(related<TestType>(0, above, one, 2) == Relation::overlapping);
  CHECK(related<TestType>(-1, 0, tiny, 2) == Relation::disjoint);
  const TestType most = std::numeric_limits<TestType>::max();
  CHECK(related<TestType>(-most, most, most, most) == Relation::b_inside_a);
  CHECK(related<TestType>(-most, 0, 0, most) == Relation::touching);
}

TEST_CASE("two that share the double 0.7 touch, which centres and extents deny", "[interval_interval]") {
  const Interval<double> a = {.1, .7}, b = {.7, .9};
  CHECK(relate(a, b) == Relation::touching);
  const double gap = (b.lo + b.hi) / 2 - (a.lo + a.hi) / 2, reach = (a.hi - a.lo) / 2 + (b.hi - b.lo) / 2;
  CHECK(gap > reach);
}

TEMPLATE_TEST_CASE("half-lines and the line are intervals too", "[interval_interval]", float, double) {
  CHECK(related<TestType>(0, inf, -inf, 0) == Relation::touching);
  CHECK(related<TestType>(0, inf, 5, inf) == Relation::b_inside_a);
  CHECK(related<TestType>(0, inf, -inf, 5) == Relation::overlapping);
  CHECK(related<TestType>(0, inf, 0, inf) == Relation::equal);
  CHECK(related<TestType>(-inf, inf, -inf, inf) == Relation::equal);
  CHECK(related<TestType>(-inf, inf, 0, 1) == Relation::b_inside_a);
  CHECK(related<TestType>(-inf, 0, 1, inf) == Relation::disjoint);
}

TEMPLATE_TEST_CASE("inverted intervals, NaN and an end at infinity alone hold nothing", "[interval_interval]", float,
                   double) {
  const auto [lo, hi] = GENERATE(table<double, double>({{1, -1},
                                                        {inf, -inf},
                                                        {not_a_number, 1},
                                                        {-1, not_a_number},
                                                        {not_a_number, not_a_number},
                                                        {inf, inf},
                                                        {-inf, -inf},
                                                        {not_a_number, inf}}));
  CHECK(related<TestType>(lo, hi, -5, 5) == Relation::disjoint);
  CHECK(related<TestType>(lo, hi, -inf, inf) == Relation::disjoint);
  CHECK(related<TestType>(lo, hi, lo, hi) == Relation::disjoint);
}

TEST_CASE("the note's comparisons call what holds nothing overlapping", "[interval_interval]") {
  using interval_interval::ends;
  CHECK(ends<double>({0, 1}, {1, 2}));
  CHECK_FALSE(ends<double>({0, 1}, {2, 3}));
  CHECK_FALSE(ends<double>({2, 3}, {0, 1}));
  CHECK(ends<double>({1, -1}, {-5, 5}));
  CHECK(ends<double>({not_a_number, not_a_number}, {0, 1}));
}

TEST_CASE("the note's test compares twice at most, and once where the first decides", "[interval_interval]") {
  using C = Counted<double>;
  tally() = {};
  interval_interval::ends<C>({2., 3.}, {0., 1.});
  CHECK(tally() == Tally{.compare = 1});
  tally() = {};
  interval_interval::ends<C>({0., 1.}, {0., 1.});
  CHECK(tally() == Tally{.compare = 2});
}

TEST_CASE("the events tell the comparisons and the common part", "[interval_interval]") {
  Record<interval_interval::Event<double>> record;
  interval_interval::ends<double>({0, 1}, {2, 3}, record);
  REQUIRE(record.events.size() == 2);
  CHECK_FALSE(std::get<interval_interval::Beyond<double>>(record.events[0]).holds);
  CHECK(std::get<interval_interval::Beyond<double>>(record.events[1]).lo == 2);
  CHECK(std::get<interval_interval::Beyond<double>>(record.events[1]).holds);
  relate<double>({0, 2}, {1, 3}, record);
  CHECK(std::get<interval_interval::Common<double>>(record.events.back()).common == Interval<double>{1, 2});
}

TEMPLATE_TEST_CASE("two intervals: relations are those of the sets of points", "[interval_interval]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(3000, 625000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Interval<S> a = bench::interval<S>(random, numbers), b = bench::interval<S>(random, numbers);
      if (random.one_in(4)) (random.one_in(2) ? b.lo : b.hi) = random.one_in(2) ? a.lo : a.hi;
      if (random.one_in(10)) (random.one_in(2) ? a.lo : b.lo) = -std::numeric_limits<S>::infinity();
      if (random.one_in(10)) (random.one_in(2) ? a.hi : b.hi) = std::numeric_limits<S>::infinity();

      const Relation r = relate(a, b);
      const Relation truth =
          oracle::by_points<S, 1>({Point<S, 1>(a.lo), Point<S, 1>(a.hi)}, {Point<S, 1>(b.lo), Point<S, 1>(b.hi)});
      if (r != truth) FAIL("wrong");  // REQUIRE would take most of the time
      if (relate(b, a) != reversed(r) || intersects(a, b) != (r != Relation::disjoint)) FAIL("not consistent");
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 100);
}

}  // namespace interval_interval_test
