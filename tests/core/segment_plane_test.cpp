#include <isect/segment_plane.h>

#include <cmath>
#include <limits>

#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace segment_plane_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational;

TEMPLATE_TEST_CASE("a segment crosses a plane, ends on it, lies in it or beside it", "[segment_plane]", float, double) {
  using S = TestType;
  const Plane<S, 3> plane = {{1, 2, 2}, -9};
  const auto meet = [&](Point<S, 3> p, Point<S, 3> q) { return intersect(Segment<S, 3>{p, q}, plane); };
  CHECK(meet({0, 0, 0}, {9, 9, 9}).t == S(0.2));
  CHECK(meet({0, 0, 0}, {1, 2, 2}).t == S(1));
  CHECK(meet({1, 2, 2}, {0, 0, 0}).t == S(0));
  CHECK(meet({0, 0, 0}, {1, 2, std::nextafter(S(2), S(0))}).t == std::nullopt);
  CHECK(meet({0, 0, 0}, {S(0.5), 1, 1}).line == S(2));
  CHECK_FALSE(meet({0, 0, 0}, {S(0.5), 1, 1}));
  CHECK(meet({1, 2, 2}, {3, 1, 2}).coplanar);
  CHECK(meet({1, 2, 2}, {3, 1, 2}).meets);
  CHECK(meet({1, 2, 3}, {3, 1, 3}).parallel);
  CHECK_FALSE(meet({1, 2, 3}, {3, 1, 3}).meets);
  CHECK(meet({1, 2, 2}, {1, 2, 2}).coplanar);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    CHECK_FALSE(meet({0, 0, 0}, {9, 9, static_cast<S>(bad)}).meets);
    CHECK_FALSE(intersect(Segment<S, 3>{{0, 0, 0}, {9, 9, 9}}, Plane<S, 3>{{1, 0, 0}, static_cast<S>(bad)}).meets);
  }
  CHECK_FALSE(intersect(Segment<S, 3>{{0, 0, 0}, {9, 9, 9}}, Plane<S, 3>{{0, -0., 0}, 0}).meets);
}

TEMPLATE_TEST_CASE_SIG("segment and plane: every answer is that of rational arithmetic", "[segment_plane]",
                       FLOATS_AND_DIMENSIONS) {
  int hits = 0, misses = 0, coplanar = 0;
  double worst = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(1500, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Plane<S, N> plane = {bench::vector<S, N>(random, random.one_in(2) ? Numbers::grid : numbers),
                           bench::number<S>(random, numbers)};
      Segment<S, N> segment = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
      if (random.one_in(3)) {  // along an axis, so that both ends are as high
        segment.q = segment.p, segment.q[0] = bench::number<S>(random, numbers);
        if (random.one_in(2)) plane.normal[0] = 0;
      }
      if (random.one_in(2))  // through an end, up to rounding
        plane.d = -static_cast<S>(plane.normal.template cast<double>().dot(
            (random.one_in(2) ? segment.p : segment.q).template cast<double>()));
      if (!finite(plane) || plane.normal.isZero(0)) continue;
      const auto height = [&](const Point<S, N>& x) {
        Rational sum = plane.d;
        for (int k = 0; k < N; ++k) sum += Rational(plane.normal[k]) * Rational(x[k]);
        return sum;
      };
      const Rational p = height(segment.p), q = height(segment.q);
      const RayPlane<S> found = intersect(segment, plane);
      REQUIRE(found.parallel == (p == q));
      REQUIRE(intersects(segment, plane) == found.meets);
      REQUIRE(first_hit(segment, plane) == (found.coplanar ? S(0) : found.t));
      REQUIRE(found.coplanar == (p == 0 && q == 0));
      REQUIRE(found.meets == (std::min(p, q) <= 0 && 0 <= std::max(p, q)));
      REQUIRE(found.line.has_value() == (p != q));
      REQUIRE(found.t.has_value() == (found.meets && p != q));
      (found ? hits : misses) += 1, coplanar += found.coplanar;
      Record<segment_plane::Event> record;
      REQUIRE(intersect(segment, plane, record).t == found.t);
      if (p == q) continue;
      const Rational truth = p / (p - q);
      worst = std::max(worst, oracle::ulps(*found.line, truth));
      if (found.t) REQUIRE((0 <= *found.t && *found.t <= 1 && oracle::ulps(*found.t, truth) <= 2));
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses}) CHECK(often > 1000);
  CHECK(coplanar > 100);
}

}  // namespace segment_plane_test
