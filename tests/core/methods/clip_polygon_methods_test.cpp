#include <isect/methods/clip_polygon.h>

#include <isect/counted.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace clip_polygon_methods_test {
using namespace isect;
using bench::Random;

TEST_CASE("floating point agrees on ordinary polygons", "[clip_polygon_methods]") {
  Random random(tests::seed());
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ring<double, 3> r = {random.in_box<3>(1), random.in_box<3>(1), random.in_box<3>(1)};
    const Plane<double, 3> p = {random.in_box<3>(1), random.uniform(-.5, .5)};
    INFO("seed " << tests::seed() << ", case " << i);
    const Ring<double, 3> naive = clip_polygon::sutherland_hodgman(r, p), exact = clip(r, p);
    REQUIRE(naive.size() == exact.size());
    for (std::size_t k = 0; k < naive.size(); ++k) REQUIRE((naive[k] - exact[k]).norm() < 1e-12);
    cut += naive.size() == 4;
  }
  CHECK(cut > 100);
  using C = Counted<double>;
  tally() = {};
  const Ring<C, 2> r = {{C(0), C(0)}, {C(4), C(0)}, {C(0), C(4)}};
  CHECK(clip_polygon::sutherland_hodgman(r, Plane<C, 2>{{C(1), C(0)}, C(-1)}).size() == 3);
  CHECK(tally().div == 2);
}

}  // namespace clip_polygon_methods_test
