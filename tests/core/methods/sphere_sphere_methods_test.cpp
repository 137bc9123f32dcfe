#include <isect/methods/sphere_sphere.h>

#include <limits>

#include "bench/sphere_sphere/families.h"
#include "bench/sphere_sphere/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace sphere_sphere_methods_test {
using namespace isect;
using namespace isect::sphere_sphere;

TEMPLATE_TEST_CASE("every method agrees with rationals on ordinary balls", "[sphere_sphere_methods]", float, double) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [a, b] = bench::sphere_sphere_families::ordinary<TestType>(random);
    const Relation truth = oracle::relation(a, b);
    const bool meet = truth != Relation::disjoint;
    if (closed_squared_distance(a, b) != meet || by_distance(a, b) != meet || by_hypot(a, b) != meet) FAIL("meet");
    if (squared_relation(a, b) != truth) FAIL("relation");
  }
}

TEST_CASE("touching counts", "[sphere_sphere_methods]") {
  const Sphere<double, 2> a = {{0, 0}, 4}, b = {{3, 4}, 1}, inner = {{0, 3}, 1};
  CHECK(closed_squared_distance(a, b));
  CHECK(by_distance(a, b));
  CHECK(by_hypot(a, b));
  CHECK(squared_relation(a, b) == Relation::touching);
  CHECK(squared_relation(a, inner) == Relation::b_inside_a);
  CHECK(squared_relation(inner, a) == Relation::a_inside_b);
  CHECK(squared_relation(a, a) == Relation::equal);
}

TEST_CASE("a root does not bring back what squares have lost, hypot does", "[sphere_sphere_methods]") {
  const Sphere<float, 3> a = {{0, 0, 0}, 1e-24f}, b = {{1e-23f, 0, 0}, 1e-24f};  // disjoint
  CHECK(closed_squared_distance(a, b));
  CHECK(by_distance(a, b));
  CHECK_FALSE(by_hypot(a, b));
  const Sphere<float, 3> c = {{0, 0, 0}, .1f}, d = {{.3f, 0, 0}, .2f};  // .1f + .2f < .3f, and rounds to it
  CHECK(by_distance(c, d));
  CHECK(by_hypot(c, d));
}

TEST_CASE("empty balls and NaN may meet by the naive methods", "[sphere_sphere_methods]") {
  const Sphere<double, 3> empty = {{0, 0, 0}, -2}, far = {{9, 0, 0}, -8};
  CHECK(closed_squared_distance(empty, far));
  const Sphere<double, 3> nan = {{std::numeric_limits<double>::quiet_NaN(), 0, 0}, 1};
  CHECK_FALSE(closed_squared_distance(nan, nan));
  CHECK(squared_relation(nan, nan) == Relation::overlapping);
}

TEST_CASE("two spheres: the events tell what is compared", "[sphere_sphere_methods]") {
  Record<MethodEvent<double>> record;
  by_distance<double, 3>({{0, 0, 0}, 1}, {{3, 4, 0}, 2}, record);
  squared_relation<double, 3>({{0, 0, 0}, 4}, {{3, 4, 0}, 2}, record);
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<Lengths<double>>(record.events[0]).distance == 5);
  CHECK(std::get<Compared<double>>(record.events[1]).sum2 == 36);
  CHECK(std::get<Compared<double>>(record.events[2]).sum2 == 4);
}

}  // namespace sphere_sphere_methods_test
