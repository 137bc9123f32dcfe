#include <isect/methods/sphere_aabb.h>

#include <limits>

#include "bench/sphere_aabb/families.h"
#include "bench/sphere_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace sphere_aabb_methods_test {
using namespace isect;
using namespace isect::sphere_aabb;
using tests::not_a_number;

namespace {

const Aabb<double, 3> box = {{-1, -1, -1}, {1, 1, 1}};

}  // namespace

TEMPLATE_TEST_CASE("every method agrees with rationals on ordinary input", "[sphere_aabb_methods]", float, double) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [ball, other] = bench::sphere_aabb_families::ordinary<TestType>(random);
    const bool meet = oracle::relation(ball, other) != Relation::disjoint;
    if (clamped(ball, other) != meet || with_rejections(ball, other) != meet) FAIL("wrong");
  }
}

TEST_CASE("touching a face, an edge or a corner counts", "[sphere_aabb_methods]") {
  for (const Sphere<double, 3>& ball : {Sphere<double, 3>{{3, 0, 0}, 2}, {{4, 5, 0}, 5}, {{3, -3, 2}, 3}}) {
    CHECK(clamped(ball, box));
    CHECK(with_rejections(ball, box));
    CHECK_FALSE(accumulate_naive(ball, box));  // the note's <
  }
}

TEST_CASE("squares that vanish make far things meet", "[sphere_aabb_methods]") {
  const Sphere<float, 3> ball = {{1e-24f, 1e-24f, 0}, 1.2e-24f};  // at 1.4e-24 of the corner 0
  const Aabb<float, 3> corner = {{-1, -1, -1}, {0, 0, 0}};
  CHECK_FALSE(intersects(ball, corner));
  CHECK(clamped(ball, corner));
  CHECK(with_rejections(ball, corner));
}

TEST_CASE("NaN and inverted boxes are decided by chance", "[sphere_aabb_methods]") {
  CHECK_FALSE(clamped<double, 3>({{not_a_number, 0, 0}, 1}, box));
  CHECK(with_rejections<double, 3>({{not_a_number, 0, 0}, 1}, box));
  CHECK(clamped<double, 3>({{0, 0, 0}, 3}, {{1, 1, 1}, {-1, -1, -1}}));
}

TEST_CASE("the events tell the nearest point, each axis, and what rejects", "[sphere_aabb_methods]") {
  Record<MethodEvent<double, 3>> record;
  clamped<double, 3>({{4, 5, 0}, 4}, box, record);
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<Nearest<double, 3>>(record.events[0]).p == Point<double, 3>(1, 1, 0));
  CHECK(std::get<Compared<double>>(record.events[1]).distance2 == 25);

  record.events.clear();
  CHECK_FALSE(with_rejections<double, 3>({{2, 9, 0}, 4}, box, record));
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<Axis<double>>(record.events[0]).gap == 1);
  CHECK(std::get<Rejected<double>>(record.events[1]).axis == 1);
}

}  // namespace sphere_aabb_methods_test
