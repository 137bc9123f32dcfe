#include <isect/methods/ray_obb.h>

#include <isect/counted.h>
#include "bench/random_obb.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_obb_methods_test {
using namespace isect;
using bench::Random;

TEST_CASE("projections agree on ordinary rays", "[ray_obb_methods]") {
  Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray<double, 3> ray = {random.in_box<3>(2), random.in_box<3>(1)};
    const Obb<double, 3> box = {random.in_box<3>(1), bench::rotation<double, 3>(random, 3), {1, .5, .7}};
    INFO("seed " << tests::seed() << ", case " << i);
    const auto naive = ray_obb::projections(ray, box), exact = intersect(ray, box);
    REQUIRE(naive.has_value() == exact.has_value());
    if (!exact) continue;
    ++hits;
    REQUIRE(naive->lo == Approx(exact->lo));
    REQUIRE(naive->hi == Approx(exact->hi));
  }
  CHECK(hits > 200);
  using C = Counted<double>;
  tally() = {};
  const Obb<C, 2> box = {{C(0), C(0)}, Eigen::Matrix<C, 2, 2>{{C(1), C(0)}, {C(0), C(1)}}, {C(1), C(9)}};
  CHECK(ray_obb::projections<C, 2>({{C(-3), C(0)}, {C(1), C(1)}, {C(0), C(9)}}, box));
  CHECK(tally().div == 4);
}

}  // namespace ray_obb_methods_test
