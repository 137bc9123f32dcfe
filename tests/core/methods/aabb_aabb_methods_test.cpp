#include <isect/methods/aabb_aabb.h>

#include <limits>

#include "bench/aabb_aabb/families.h"
#include "bench/aabb_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace aabb_aabb_methods_test {
using namespace isect;
using namespace isect::aabb_aabb;

TEMPLATE_TEST_CASE("every method agrees with the sets of points on ordinary boxes", "[aabb_aabb_methods]", float,
                   double) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [a, b] = bench::aabb_aabb_families::ordinary<TestType>(random);
    const bool meet = oracle::by_points(a, b) != Relation::disjoint;
    if (min_max(a, b) != meet || by_centers(a, b) != meet) FAIL("wrong");
  }
}

TEST_CASE("centers come apart where boxes touch", "[aabb_aabb_methods]") {
  const Aabb<double, 2> a = {{.1, 0}, {.7, 1}}, b = {{.7, 0}, {.9, 1}};
  CHECK(intersects(a, b));
  CHECK(min_max(a, b));
  CHECK_FALSE(by_centers(a, b));
}

TEST_CASE("an inverted box meets nothing by min and max, NaN may", "[aabb_aabb_methods]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Aabb<double, 2> a = {{0, 0}, {3, 3}}, inverted = {{2, 2}, {1, 1}}, none = {{nan, nan}, {nan, nan}};
  CHECK_FALSE(min_max(a, inverted));
  CHECK(by_axis(a, inverted));
  CHECK(min_max(a, none));
  CHECK_FALSE(by_centers(a, none));
}

TEST_CASE("the events tell each axis, all of them by min and max", "[aabb_aabb_methods]") {
  const Aabb<double, 2> a = {{0, 0}, {1, 1}}, b = {{2, 0}, {3, 1}};
  Record<MethodEvent<double>> record;
  CHECK_FALSE(min_max(a, b, record));
  CHECK(record.events.size() == 2);
  record.events.clear();
  CHECK_FALSE(by_centers(a, b, record));
  REQUIRE(record.events.size() == 1);
  CHECK(std::get<interval_interval::Middles<double>>(record.events[0]).distance == 2);
}

}  // namespace aabb_aabb_methods_test
