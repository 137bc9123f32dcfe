#include <isect/methods/ray_polygon.h>

#include "bench/ray_polygon/families.h"
#include "bench/ray_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_polygon_methods_test {
using namespace isect;

namespace {

/// An L of the plane z = 0: [0, 4]^2 without (2, 4]^2.
const Ring<double, 3> angle = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}};

Ray<double, 3> down(double x, double y) { return {{x, y, 2}, {0, 0, -1}}; }

}  // namespace

TEST_CASE("a fan from a vertex that does not see all counts by parity", "[ray_polygon_methods]") {
  const Ring<double, 3> turned = {angle[1], angle[2], angle[3], angle[4], angle[5], angle[0]};
  for (const Ring<double, 3>& ring : {angle, turned}) {
    CHECK(ray_polygon::fan(down(1, 3.5), ring) == 2.);
    CHECK(ray_polygon::fan(down(3.5, 1), ring) == 2.);
    CHECK_FALSE(ray_polygon::fan(down(3, 3.5), ring));
    CHECK_FALSE(ray_polygon::fan(down(-1, 1), ring));
  }
}

TEMPLATE_TEST_CASE("the fan nearly always agrees with rationals on ordinary rays", "[ray_polygon_methods]", float,
                   double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int wrong = 0, hits = 0;
  for (int i = 0; i < tests::cases(1000, 50000); ++i) {
    const auto [ray, ring] = bench::ray_polygon_families::ordinary<S>(random);
    const oracle::RayPolygon truth = oracle::ray_polygon(ray, ring);
    wrong += ray_polygon::fan(ray, ring).has_value() != truth.hit;
    hits += truth.hit;
  }
  CHECK(wrong <= tests::cases(1000, 50000) / 100);
  CHECK(hits > 100);
}

TEST_CASE("the events tell each triangle", "[ray_polygon_methods]") {
  Record<ray_polygon::FanEvent<double>> record;
  ray_polygon::fan(down(3, 0.5), angle, record);
  REQUIRE(record.events.size() == 4);
  CHECK(std::get<ray_polygon::FanTriangle<double>>(record.events[0]).hit);
  CHECK_FALSE(std::get<ray_polygon::FanTriangle<double>>(record.events[3]).hit);
}

}  // namespace ray_polygon_methods_test
