#include <isect/methods/ray_aabb.h>

#include <cmath>
#include <limits>

#include "bench/ray_aabb/families.h"
#include "bench/ray_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_aabb_methods_test {
using namespace isect;
using namespace isect::ray_aabb;

namespace {

const Aabb<double, 3> unit_cube = {{0, 0, 0}, {1, 1, 1}};

}  // namespace

TEMPLATE_TEST_CASE("every method agrees with rationals on ordinary rays", "[ray_aabb_methods]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [ray, box] = bench::ray_aabb_families::ordinary<S>(random);
    const auto truth = oracle::ray_aabb(ray, box);
    for (const auto& part :
         {by_min_max(ray, box), by_min_max_exchanged(ray, box), by_fmin_fmax(ray, box), by_sign(ray, box)}) {
      if (part.has_value() != truth.has_value()) FAIL("wrong");
      if (part && (oracle::ulps(part->lo, truth->first) > 4 || oracle::ulps(part->hi, truth->second) > 4))
        FAIL("inaccurate");
    }
  }
}

TEST_CASE("a ray along a face meets the box, and the reciprocals lose it", "[ray_aabb_methods]") {
  const Ray<double, 3> ray = {{1, .5, -1}, {0, 0, 1}};
  CHECK(intersect(ray, unit_cube) == Interval<double>{1, 2});
  CHECK_FALSE(by_min_max(ray, unit_cube));
  CHECK_FALSE(by_fmin_fmax(ray, unit_cube));
  const Ray<double, 3> along_lower = {{0, .5, -1}, {0, 0, 1}};
  CHECK_FALSE(by_fmin_fmax(along_lower, unit_cube));
}

TEST_CASE("with a NaN at a lower plane the order of the arguments of min and max decides", "[ray_aabb_methods]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Ray<double, 3> at_lower_z = {{.5, -1, 0}, {0, 1, 0}}, at_upper_z = {{.5, -1, 1}, {0, 1, 0}};
  CHECK(by_min_max(at_lower_z, unit_cube) == Interval<double>{1, 2});
  CHECK_FALSE(by_min_max_exchanged(at_lower_z, unit_cube));
  CHECK_FALSE(by_min_max(at_upper_z, unit_cube));
  CHECK_FALSE(by_min_max_exchanged(at_upper_z, unit_cube));
  Record<MethodEvent<double>> hidden, kept;
  by_min_max(at_upper_z, unit_cube, hidden);
  CHECK(std::isnan(std::get<Planes<double>>(hidden.events[9]).hi));
  CHECK(std::get<Crossing<double>>(hidden.events[10]).exit == -infinity);
  by_min_max_exchanged(at_lower_z, unit_cube, kept);
  CHECK(std::isnan(std::get<Remains<double>>(kept.events[11]).in));
}

TEST_CASE("a NaN that a later axis replaces takes the ray's own range with it", "[ray_aabb_methods]") {
  const Ray<double, 3> too_short = {{0, .5, -1}, {0, 0, 1}, {0, .5}};
  CHECK_FALSE(intersect(too_short, unit_cube));
  CHECK_FALSE(by_min_max(too_short, unit_cube));
  CHECK(by_min_max_exchanged(too_short, unit_cube) == Interval<double>{1, 2});
}

TEST_CASE("a component of -0 is of another sign than its reciprocal", "[ray_aabb_methods]") {
  const Ray<double, 3> ray = {{.5, .5, -1}, {-0., 0, 1}};
  CHECK(intersect(ray, unit_cube) == Interval<double>{1, 2});
  CHECK(by_min_max(ray, unit_cube) == Interval<double>{1, 2});
  CHECK_FALSE(by_sign(ray, unit_cube));
}

TEST_CASE("an inverted box is taken for another by min and max", "[ray_aabb_methods]") {
  const Aabb<double, 3> inverted = {{1, 1, 1}, {0, 0, 0}};
  const Ray<double, 3> ray = {{.5, .4, -1}, {.1, .2, 1}};
  CHECK(by_min_max(ray, inverted));
  CHECK_FALSE(by_sign(ray, inverted));
  CHECK_FALSE(intersect(ray, inverted));
}

TEST_CASE("the events tell each slab", "[ray_aabb_methods]") {
  Record<MethodEvent<double>> record;
  by_min_max<double, 3>({{-1, .5, .5}, {2, .1, .1}}, unit_cube, record);
  REQUIRE(record.events.size() == 12);
  CHECK(std::get<Reciprocal<double>>(record.events[0]).value == .5);
  CHECK(std::get<Planes<double>>(record.events[1]).lo == .5);
  CHECK(std::get<Crossing<double>>(record.events[2]).exit == 1);
  CHECK(std::get<Remains<double>>(record.events[3]).holds);
}

}  // namespace ray_aabb_methods_test
