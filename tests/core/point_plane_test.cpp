#include <isect/point_plane.h>

#include <cmath>
#include <limits>

#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_plane_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational;

TEMPLATE_TEST_CASE("a point lies before a plane, in it or behind it", "[point_plane]", float, double) {
  using S = TestType;
  const Plane<S, 3> plane = {{1, 2, 2}, -9};
  CHECK(side(plane, Point<S, 3>(1, 2, 2)) == 0);
  CHECK(side(plane, Point<S, 3>(std::nextafter(S(1), S(2)), 2, 2)) == 1);
  CHECK(side(plane, Point<S, 3>(1, 2, std::nextafter(S(2), S(0)))) == -1);
  const Plane<S, 2> line = {{S(0.1), S(0.1)}, 0};
  CHECK(side(line, Point<S, 2>(S(0.3), S(-0.3))) == 0);
  const std::vector<Point<S, 3>> points = {{9, 0, 0}, {0, 0, 0}, {8, 0, 0}, {9, 9, 9}};
  CHECK(sides<S, 3>(plane, points) == Sides{2, 1, 1});
  CHECK(sides<S, 3>(plane, {}) == Sides{});
}

TEST_CASE("point and plane: no plane, nothing finite, numbers of any size", "[point_plane]") {
  const double nan_ = std::numeric_limits<double>::quiet_NaN();
  const Point<double, 3> p = {1, 2, 3};
  CHECK(side(Plane<double, 3>{{0, -0., 0}, 1}, p) == 0);
  for (const double bad : {nan_, HUGE_VAL, -HUGE_VAL}) {
    CHECK(side(Plane<double, 3>{{bad, 1, 1}, 1}, p) == 0);
    CHECK(side(Plane<double, 3>{{1, 1, 1}, bad}, p) == 0);
    CHECK(side(Plane<double, 3>{{1, 1, 1}, 1}, Point<double, 3>(1, bad, 3)) == 0);
  }
  CHECK(side(Plane<double, 3>{{1e300, -1e300, 0}, 0}, Point<double, 3>(1e300, 1e300, 0)) == 0);
  CHECK(side(Plane<double, 3>{{1e300, -1e300, 0}, 5e-324}, Point<double, 3>(1e300, 1e300, 0)) == 1);
  CHECK(side(Plane<double, 3>{{1e-300, 0, 0}, 0}, Point<double, 3>(-1e-300, 0, 0)) == -1);
}

TEMPLATE_TEST_CASE_SIG("point and plane: every verdict is that of rational arithmetic", "[point_plane]",
                       FLOATS_AND_DIMENSIONS) {
  std::array<int, 3> seen = {};
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(2000, 200000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Plane<S, N> plane = {bench::vector<S, N>(random, random.one_in(2) ? Numbers::grid : numbers),
                           bench::number<S>(random, numbers)};
      const Point<S, N> p = bench::vector<S, N>(random, numbers);
      if (random.one_in(2))  // through the point, up to rounding
        plane.d = bench::moved(-static_cast<S>(plane.normal.template cast<double>().dot(p.template cast<double>())),
                               random.integer(-1, 1));
      if (!finite(plane)) continue;
      Rational height = plane.d;  // coordinate by coordinate
      for (int k = 0; k < N; ++k) height += Rational(plane.normal[k]) * Rational(p[k]);
      const int truth = plane.normal.isZero(0) ? 0 : oracle::sign(height);
      REQUIRE(side(plane, p) == truth);
      Record<point_plane::Event> record;
      REQUIRE(side(plane, p, record) == truth);
      ++seen[static_cast<std::size_t>(1 + truth)];
    }
  }
  for (const int often : seen) CHECK(often > 1000);
}

}  // namespace point_plane_test
