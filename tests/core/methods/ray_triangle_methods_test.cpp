#include <isect/counted.h>
#include <isect/methods/ray_triangle.h>

#include "bench/ray_triangle/families.h"
#include "bench/ray_triangle/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_triangle_methods_test {
using namespace isect;
using namespace isect::ray_triangle;

namespace {

const Triangle<double, 3> tile = {{Point<double, 3>{0, 0, 0}, Point<double, 3>{4, 0, 0}, Point<double, 3>{0, 4, 0}}};

}  // namespace

TEMPLATE_TEST_CASE("signed volumes agree with rationals on ordinary rays", "[ray_triangle_methods]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [ray, triangle] = bench::ray_triangle_families::ordinary<S>(random);
    const oracle::RayTriangle truth = oracle::ray_triangle(ray, triangle);
    const oracle::Rational least = std::min({truth.u, truth.v, oracle::Rational(1 - truth.u - truth.v)});
    if (abs(least) < 1e-4 || abs(truth.t) < 1e-4) continue;  // an edge, where rounding may decide
    for (const auto& hit : {signed_volumes(ray, triangle), woop(ray, triangle)}) {
      if (hit.has_value() != truth.hit) FAIL("wrong");
      if (hit && std::abs(hit->t / static_cast<S>(static_cast<double>(truth.t)) - 1) > S(1e-3)) FAIL("inaccurate");
      if (hit && std::abs(hit->u - static_cast<S>(static_cast<double>(truth.u))) > S(1e-2)) FAIL("u");
      if (hit && std::abs(hit->v - static_cast<S>(static_cast<double>(truth.v))) > S(1e-2)) FAIL("v");
      hits += truth.hit;
    }
  }
  CHECK(hits > 200);
}

TEST_CASE("a ray meets the triangle from either side, inside, on an edge and at a vertex", "[ray_triangle_methods]") {
  for (const double z : {2., -2.})
    for (const auto& [x, y] : {std::pair{1., 2.}, {2., 0.}, {2., 2.}, {0., 4.}}) {
      const Ray<double, 3> ray = {{x, y, z}, {0, 0, -z / 2}};
      for (const auto& hit : {signed_volumes(ray, tile), woop(ray, tile)}) {
        REQUIRE(hit);
        CHECK(hit->t == 2);
        CHECK(hit->u == x / 4);
        CHECK(hit->v == y / 4);
      }
    }
  const Ray<double, 3> beside = {{3, 3, 2}, {0, 0, -1}}, behind = {{1, 1, -2}, {0, 0, -1}};
  CHECK_FALSE(signed_volumes(beside, tile));
  CHECK_FALSE(woop(beside, tile));
  CHECK_FALSE(signed_volumes(behind, tile));
  CHECK_FALSE(woop(behind, tile));
}

TEST_CASE("a ray in the plane has no t", "[ray_triangle_methods]") {
  const Ray<double, 3> ray = {{-1, 1, 0}, {1, 0, 0}};
  CHECK_FALSE(signed_volumes(ray, tile));
  CHECK_FALSE(woop(ray, tile));
}

TEST_CASE("the texts run on scalars that count, and both divide a few times alone", "[ray_triangle_methods]") {
  using C = Counted<double>;
  const Ray<C, 3> ray = cast<C>(Ray<double, 3>{{1, 1, 2}, {0, 0, -1}});
  const Triangle<C, 3> counted = cast<C>(tile);
  tally() = {};
  CHECK(signed_volumes(ray, counted));
  CHECK(tally().div == 3);
  tally() = {};
  CHECK(woop(ray, counted));
  CHECK(tally().div == 6);
}

TEST_CASE("the events tell the volumes, the shear and each corner", "[ray_triangle_methods]") {
  const Ray<double, 3> ray = {{1, 1, 2}, {0, 0, -1}};
  Record<VolumesEvent<double>> record;
  signed_volumes(ray, tile, record);
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<SignedVolumes<double>>(record.events[0]).holds);
  record.events.clear();
  woop(ray, tile, record);
  REQUIRE(record.events.size() == 7);
  CHECK(std::get<Sheared<double>>(record.events[0]).z == 2);
  CHECK(std::get<Corner<double>>(record.events[3]).index == 2);
  CHECK(std::get<InRange<double>>(record.events[6]).t == 2);
}

}  // namespace ray_triangle_methods_test
