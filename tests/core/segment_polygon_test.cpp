#include <isect/segment_polygon.h>

#include <cmath>
#include <limits>

#include "bench/random_shapes.h"
#include "bench/ray_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace segment_polygon_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational, oracle::operator-;

TEST_CASE("a segment crosses a polygon, ends on it, lies in its plane", "[segment_polygon]") {
  const Ring<double, 3> square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto meet = [&](double x, double y, double z, double to_x, double to_y, double to_z) {
    return intersect(Segment<double, 3>{{x, y, z}, {to_x, to_y, to_z}}, square);
  };
  CHECK(meet(1, 1, 1, 1, 1, -3).t == 0.25);
  CHECK(meet(1, 1, 1, 1, 1, -3).location == Location::in);
  CHECK(meet(1, 1, 3, 1, 1, 0).t == 1.0);
  CHECK(meet(1, 1, 3, 1, 1, 5e-324).t == std::nullopt);
  CHECK(meet(1, 1, 3, 1, 1, 1).line == 1.5);
  CHECK(meet(4, 1, 1, 4, 1, -1).location == Location::on);
  CHECK(meet(5, 1, 1, 5, 1, -1).location == Location::out);
  CHECK(meet(1, 1, 0, 9, 1, 0).coplanar);
  CHECK(meet(1, 1, 1, 9, 1, 1).line == std::nullopt);
  CHECK(meet(1, 1, 0, 1, 1, 0).coplanar);
  CHECK_FALSE(meet(1, 1, 0, 1, 1, 0));
  CHECK(intersect(Segment<double, 3>{{1, 1, 1}, {1, 1, -1}}, Ring<double, 3>{{0, 0, 0}, {1, 1, 0}, {4, 4, 0}}).flat);
  CHECK(intersect(Segment<double, 3>{{1, 1, 1}, {1, 1, -1}}, Ring<double, 3>{}).flat);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    CHECK_FALSE(meet(1, 1, bad, 1, 1, -3));
    CHECK_FALSE(
        intersect(Segment<double, 3>{{1, 1, 1}, {1, 1, -1}}, Ring<double, 3>{{0, 0, 0}, {4, 0, bad}, {4, 4, 0}}));
  }
  // A hole
  const Ring<double, 3> hole = {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  CHECK_FALSE(intersect(Segment<double, 3>{{2, 2, 1}, {2, 2, -1}}, Polygon<double, 3>{{square, hole}}));
  CHECK(intersect(Segment<double, 3>{{2, 2, 1}, {2, 2, -1}}, Polygon<double, 3>{{square, hole}}, FillRule::nonzero));
}

TEMPLATE_TEST_CASE("segment and polygon in space: every answer is that of rational arithmetic", "[segment_polygon]",
                   float, double) {
  using S = TestType;
  int hits = 0, misses = 0, on = 0, coplanar = 0;
  double worst = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(1000, 80000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Ring<S, 3> ring;
      for (int k = random.integer(3, 6); k > 0; --k) ring.push_back(bench::vector<S, 3>(random, numbers));
      if (random.one_in(2)) {  // all in one plane along two axes
        const int axis = random.below(3);
        for (Point<S, 3>& v : ring) v[axis] = ring[0][axis];
      }
      Segment<S, 3> segment = {bench::vector<S, 3>(random, numbers), bench::vector<S, 3>(random, numbers)};
      if (random.one_in(3)) segment.q = ring[static_cast<std::size_t>(random.below(3))];
      if (random.one_in(4)) segment.p[0] = ring[0][0];
      if (random.one_in(6)) segment.p = ring[1] / 2 + ring[2] / 2;
      const RayPolygon<S> found = intersect(segment, ring);
      const auto p = oracle::rational<S, 3>(segment.p);
      const auto d = oracle::rational<S, 3>(segment.q) - p;
      const oracle::RayPolygon truth = oracle::ray_polygon(p, d, Interval<S>{S(0), S(1)}, ring);
      REQUIRE(found.flat == truth.flat);
      if (truth.flat) continue;
      REQUIRE(found.coplanar == truth.coplanar);
      REQUIRE(found.line.has_value() == !truth.parallel);
      coplanar += truth.coplanar;
      if (truth.parallel) continue;
      REQUIRE(found.location == truth.location);
      REQUIRE(found.t.has_value() == truth.hit);
      (found.t ? hits : misses) += 1, on += found.location == Location::on;
      worst = std::max(worst, oracle::ulps(*found.line, truth.t));
      if (found.t) REQUIRE((0 <= *found.t && *found.t <= 1 && oracle::ulps(*found.t, truth.t) <= 2));
      Record<segment_polygon::Event> record;
      REQUIRE(intersect(segment, ring, FillRule::even_odd, record).t == found.t);
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses, on, coplanar}) CHECK(often > 100);
}

}  // namespace segment_polygon_test
