#include <isect/methods/sphere_capsule.h>

#include <limits>

#include <isect/counted.h>
#include "bench/sphere_capsule/families.h"
#include "bench/sphere_capsule/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace sphere_capsule_methods_test {
using namespace isect;
using namespace isect::sphere_capsule;
using tests::not_a_number;

namespace {

const Capsule<double, 3> capsule = {{-3, 0, 0}, {3, 0, 0}, 2};

}  // namespace

TEMPLATE_TEST_CASE("sphere and capsule: every method agrees with rationals on ordinary input",
                   "[sphere_capsule_methods]", float, double) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto other = bench::capsule<TestType, 3>(random, bench::Numbers::ordinary);
    const auto ball = bench::ordinary_sphere<TestType>(random);
    if (empty(other)) continue;
    const bool meet = oracle::relation(ball, other) != Relation::disjoint;
    if (clamped(ball, other) != meet || by_pythagoras(ball, other) != meet) FAIL("wrong");
  }
}

TEST_CASE("sphere and capsule: touching a side or an end counts", "[sphere_capsule_methods]") {
  for (const Sphere<double, 3>& ball : {Sphere<double, 3>{{1, 3, 4}, 3}, {{5, 2, 1}, 1}, {{-6, 4, 0}, 3}}) {
    CHECK(clamped(ball, capsule));
    CHECK(by_pythagoras(ball, capsule));
    CHECK_FALSE(clamped<double, 3>({ball.center, ball.radius - 0.001}, capsule));
    CHECK_FALSE(by_pythagoras<double, 3>({ball.center, ball.radius - 0.001}, capsule));
  }
}

TEST_CASE("a difference of two large squares loses a small distance", "[sphere_capsule_methods]") {
  const Capsule<double, 3> slanted = {{0, 0, 0}, {3e8, 1e8, 2e8}, 0.25};
  const Sphere<double, 3> ball = {{1.5e8, 0.5e8, 1e8 + 1}, 0.5};  // 0.845 beside the middle
  CHECK_FALSE(intersects(ball, slanted));
  CHECK_FALSE(clamped(ball, slanted));
  CHECK(by_pythagoras(ball, slanted));
}

TEST_CASE("sphere and capsule: squares that vanish make far things meet", "[sphere_capsule_methods]") {
  const Sphere<float, 3> ball = {{0, 2e-24f, 0}, 1e-24f};
  const Capsule<float, 3> segment = {{-1, 0, 0}, {1, 0, 0}, 0};
  CHECK_FALSE(intersects(ball, segment));
  CHECK(clamped(ball, segment));
  CHECK(by_pythagoras(ball, segment));
}

TEST_CASE("a capsule that is a ball needs no division", "[sphere_capsule_methods]") {
  using C = Counted<double>;
  const Sphere<C, 3> ball = {{1., 2., 2.}, 1.};
  const Capsule<C, 3> other = {{0., 0., 0.}, {0., 0., 0.}, 2.};
  tally() = {};
  CHECK(clamped(ball, other));
  CHECK(by_pythagoras(ball, other));
  CHECK(tally().div == 0);
}

TEST_CASE("sphere and capsule: NaN meets nothing, and a negative radius is taken off the other",
          "[sphere_capsule_methods]") {
  CHECK_FALSE(clamped<double, 3>({{not_a_number, 0, 0}, 1}, capsule));
  CHECK_FALSE(by_pythagoras<double, 3>({{not_a_number, 0, 0}, 1}, capsule));
  CHECK(clamped<double, 3>({{0, 1, 0}, -1}, capsule));
  CHECK(by_pythagoras<double, 3>({{0, 1, 0}, -1}, capsule));
}

TEST_CASE("sphere and capsule: the methods tell the foot and the squares", "[sphere_capsule_methods]") {
  Record<MethodEvent<double, 3>> record;
  clamped<double, 3>({{1.5, 3, 4}, 1}, capsule, record);
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<Foot<double, 3>>(record.events[0]).t == 0.75);
  CHECK(std::get<Foot<double, 3>>(record.events[0]).at == Point<double, 3>(1.5, 0, 0));
  CHECK(std::get<Compared<double>>(record.events[1]).distance2 == 25);
  CHECK(std::get<Compared<double>>(record.events[1]).reach2 == 9);

  record.events.clear();
  by_pythagoras<double, 3>({{1.5, 3, 4}, 1}, capsule, record);
  REQUIRE(record.events.size() == 1);
  CHECK(std::get<Compared<double>>(record.events[0]).distance2 == 25);
}

}  // namespace sphere_capsule_methods_test
