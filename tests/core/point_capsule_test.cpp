#include <isect/point_capsule.h>

#include <cmath>
#include <limits>

#include "bench/simple_shapes.h"
#include "bench/sphere_capsule/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_capsule_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational;

TEMPLATE_TEST_CASE("a point lies in a capsule, on it or out of it", "[point_capsule]", float, double) {
  using S = TestType;
  const Capsule<S, 3> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto where = [&](S x, S y, S z) { return locate(Point<S, 3>(x, y, z), c); };
  CHECK(where(0, 0, 0) == Location::in);
  CHECK(where(1, 3, 4) == Location::on);
  CHECK(where(1, 3, std::nextafter(S(4), S(5))) == Location::out);
  CHECK(where(1, 3, std::nextafter(S(4), S(3))) == Location::in);
  CHECK(where(6, 4, 0) == Location::on);  // on an end, by 3, 4, 5
  CHECK(where(std::nextafter(S(6), S(7)), 4, 0) == Location::out);
  CHECK(where(-8, 0, 0) == Location::on);
  const Capsule<S, 3> thin = {{S(0.1), S(0.1), 0}, {S(0.7), S(0.7), 0}, 0};
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), 0), thin) == Location::on);
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), std::numeric_limits<S>::denorm_min()), thin) == Location::out);
  CHECK(locate(Point<S, 3>(0, 0, 0), Capsule<S, 3>{c.p, c.q, -1}) == Location::out);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    CHECK(where(static_cast<S>(bad), 0, 0) == Location::out);
    CHECK(locate(Point<S, 3>(0, 0, 0), Capsule<S, 3>{c.p, c.q, static_cast<S>(bad)}) == Location::out);
  }
}

TEMPLATE_TEST_CASE_SIG("point and capsule: every verdict is that of rational arithmetic", "[point_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  std::array<int, 3> seen = {};
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(1500, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Capsule<S, N> capsule = bench::capsule<S, N>(random, numbers);
      const Point<S, N> p = random.one_in(20) ? capsule.q : bench::vector<S, N>(random, numbers);
      const Rational d2 = oracle::distance2<N>(oracle::rational(p), oracle::stretch(capsule));
      if (random.one_in(2))
        capsule.radius = bench::moved(static_cast<S>(std::sqrt(static_cast<double>(d2))), random.integer(-2, 2));
      if (!finite(capsule)) continue;
      const Rational r = capsule.radius;
      const Location truth = !oracle::at_most(d2, r) ? Location::out : d2 == r * r ? Location::on : Location::in;
      REQUIRE(locate(p, capsule) == truth);
      Record<point_capsule::Event> record;
      REQUIRE(locate(p, capsule, record) == truth);
      ++seen[static_cast<std::size_t>(truth)];
    }
  }
  for (const int often : seen) CHECK(often > 100);
}

}  // namespace point_capsule_test
