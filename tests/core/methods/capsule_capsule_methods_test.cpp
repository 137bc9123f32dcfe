#include <isect/methods/capsule_capsule.h>

#include <limits>

#include "bench/capsule_capsule/families.h"
#include "bench/capsule_capsule/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace capsule_capsule_methods_test {
using namespace isect;
using namespace isect::capsule_capsule;
using tests::not_a_number;

namespace {

constexpr double small = 1e-8;
using Capsule3 = Capsule<double, 3>;
const Capsule3 lying = {{-3, 0, 0}, {3, 0, 0}, 2};

}  // namespace

TEMPLATE_TEST_CASE_SIG("two capsules: every method agrees with rationals on ordinary input",
                       "[capsule_capsule_methods]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto a = bench::capsule<S, N>(random, bench::Numbers::ordinary),
               b = bench::capsule<S, N>(random, bench::Numbers::ordinary);
    if (empty(a) || empty(b) || b.p == b.q) continue;
    if (a.radius + b.radius == 0) continue;  // segments: rounding decides whether they meet
    const bool meet = oracle::relation(a, b) != Relation::disjoint;
    if (clamped(a, b) != meet) FAIL("clamped is wrong");
    if (sunday(a, b, S(small)) != meet) FAIL("sunday is wrong");
  }
}

TEST_CASE("two capsules: touching counts at ends, at sides, and where they pass each other",
          "[capsule_capsule_methods]") {
  for (const Capsule3& b : {Capsule3{{1, 4, 0}, {5, 7, 0}, 2},
                            {{6, 4, 0}, {9, 9, 0}, 3},
                            {{-9, 4, 0}, {9, 4, 0}, 2},
                            {{0, -3, 5}, {1, 3, 5}, 3},
                            {{8, 0, 0}, {9, 0, 0}, 3}}) {
    const Capsule3 smaller = {b.p, b.q, b.radius - 0.001};
    CHECK(clamped(lying, b));
    CHECK(sunday(lying, b, small));
    CHECK_FALSE(clamped(lying, smaller));
    CHECK_FALSE(sunday(lying, smaller, small));
  }
}

TEST_CASE("a tolerance takes small capsules for parallel ones", "[capsule_capsule_methods]") {
  const Capsule3 a = {{-0.01, 0, 0}, {0.01, 0, 0}, 0.001}, b = {{0, -0.009, 0}, {0, 0.002, 0}, 0.001};  // a cross
  CHECK(intersects(a, b));
  CHECK(clamped(a, b));
  CHECK_FALSE(sunday(a, b, 1e-6));
}

TEST_CASE("a segment that is a point is clamped to, and unknown to Sunday's", "[capsule_capsule_methods]") {
  const Capsule3 point = {{1, 2.5, 0}, {1, 2.5, 0}, 1};
  CHECK(clamped(lying, point));
  CHECK(clamped(point, lying));
  CHECK(clamped(point, point));
  CHECK_FALSE(sunday(lying, point, small));
}

TEST_CASE("the determinant of nearly parallel lines is lost to rounding", "[capsule_capsule_methods]") {
  // Both pass through the middle of the other, 3 apart, at an angle of 1e-9
  const Capsule3 a = {{-1, -1, -1}, {1, 1, 1}, 1.5};
  bool lost = false;
  for (int i = 1; i < 50; ++i) {
    const double tilt = i * 1e-9;
    Record<MethodEvent<double, 3>> record;
    clamped<double, 3>(a, {{-1 - tilt, -1, -1}, {1, 1 + tilt, 1}, 1.5}, record);
    lost |= std::get<Lines<double>>(record.events[0]).parallel;
  }
  CHECK(lost);
}

TEST_CASE("two capsules: squares that vanish make far things meet", "[capsule_capsule_methods]") {
  const Capsule<float, 3> a = {{-1, 0, 0}, {1, 0, 0}, 0}, b = {{-1, 2e-24f, 0}, {1, 2e-24f, 0}, 1e-24f};
  CHECK_FALSE(intersects(a, b));
  CHECK(clamped(a, b));
  CHECK(sunday(a, b, 1e-8f));
}

TEST_CASE("two capsules: NaN meets nothing, and a negative radius is taken off the other",
          "[capsule_capsule_methods]") {
  const Capsule3 bad = {{not_a_number, 0, 0}, {1, 1, 1}, 1}, negative = {{0, -3, 1}, {0, 3, 1}, -1};
  CHECK_FALSE(clamped(lying, bad));
  CHECK_FALSE(sunday(lying, bad, small));
  CHECK(clamped(lying, negative));
  CHECK(sunday(lying, negative, small));
}

TEST_CASE("two capsules: the methods tell the determinant, the nearest points and the squares",
          "[capsule_capsule_methods]") {
  Record<MethodEvent<double, 3>> record;
  for (const bool by_clamping : {true, false}) {
    record.events.clear();
    const Capsule3 b = {{0, -2, 5}, {0, 2, 5}, 1};
    if (by_clamping)
      clamped(lying, b, record);
    else
      sunday(lying, b, small, record);
    REQUIRE(record.events.size() == 3);
    CHECK(std::get<Lines<double>>(record.events[0]).determinant == 36 * 16);
    CHECK_FALSE(std::get<Lines<double>>(record.events[0]).parallel);
    const auto& closest = std::get<Closest<double, 3>>(record.events[1]);
    CHECK((closest.s == 0.5 && closest.t == 0.5));
    CHECK(closest.on_b == Point<double, 3>(0, 0, 5));
    CHECK(std::get<Compared<double>>(record.events[2]).distance2 == 25);
    CHECK(std::get<Compared<double>>(record.events[2]).reach2 == 9);
  }
}

}  // namespace capsule_capsule_methods_test
