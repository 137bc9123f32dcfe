#include <isect/methods/point_point.h>

#include "bench/point_point/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_point_methods_test {
using namespace isect;
using namespace isect::point_point;

TEMPLATE_TEST_CASE("squares and roots agree with the exact answer on ordinary points", "[point_point_methods]", float,
                   double) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [p, q, tolerance] = bench::point_point_families::ordinary<TestType>(random);
    const bool near = nearly_equal(p, q, tolerance);
    if (near_by_squares(p, q, tolerance) != near || near_by_distance(p, q, tolerance) != near) FAIL("wrong");
    if (near && !near_by_coordinates(p, q, tolerance)) FAIL("the cube contains the ball");
  }
}

TEST_CASE("a distance equal to the tolerance is near", "[point_point_methods]") {
  const Point<double, 2> p = {0, 0}, q = {3, 4};
  CHECK(near_by_squares(p, q, 5.));
  CHECK(near_by_distance(p, q, 5.));
  CHECK_FALSE(near_by_squares(p, q, 4.9));
  CHECK_FALSE(near_by_distance(p, q, 4.9));
  CHECK(near_by_coordinates(p, q, 4.));  // a cube
}

TEST_CASE("squares that vanish make points near", "[point_point_methods]") {
  const Point<float, 2> p = {0, 0}, q = {1e-23f, 0};
  CHECK_FALSE(nearly_equal(p, q, 1e-24f));
  CHECK(near_by_squares(p, q, 1e-24f));
  CHECK(near_by_distance(p, q, 1e-24f));
  CHECK_FALSE(near_by_coordinates(p, q, 1e-24f));
}

TEST_CASE("two points: the events tell what is compared", "[point_point_methods]") {
  Record<MethodEvent<double>> record;
  near_by_squares<double, 2>({0, 0}, {3, 4}, 6, record);
  near_by_distance<double, 2>({0, 0}, {3, 4}, 6, record);
  near_by_coordinates<double, 2>({0, 0}, {3, 4}, 2, record);
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<Compared<double>>(record.events[0]).distance == 25);
  CHECK(std::get<Compared<double>>(record.events[1]).distance == 5);
  CHECK(std::get<Compared<double>>(record.events[2]).distance == 3);
}

}  // namespace point_point_methods_test
