#include <isect/segment_sphere.h>

#include <limits>

#include "bench/ray_capsule/oracle.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace segment_sphere_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational, oracle::operator-;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// A segment and a ball: any of both, ends on the sphere, lines that touch it up to rounding.
template <class S, int N>
std::pair<Segment<S, N>, Sphere<S, N>> draw(Random& random, Numbers numbers) {
  Sphere<S, N> ball = bench::ball<S, N>(random, numbers);
  Segment<S, N> segment = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
  if (random.one_in(4)) {  // a radius ahead along an axis
    segment.q = ball.center;
    segment.q[random.below(N)] += static_cast<S>(random.sign()) * ball.radius;
  }
  if (random.one_in(4) && finite(segment)) {
    const auto f = oracle::rational(segment.p) - oracle::rational(ball.center),
               d = oracle::rational(segment.q) - oracle::rational(segment.p);
    const Rational dd = oracle::dot(d, d), fd = oracle::dot(f, d);
    const Rational d2 = dd == 0 ? oracle::dot(f, f) : Rational(oracle::dot(f, f) - fd * fd / dd);
    ball.radius = bench::moved(static_cast<S>(std::sqrt(static_cast<double>(d2))), random.integer(-2, 2));
  }
  if (random.one_in(30)) segment.q = segment.p;
  return {segment, ball};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a segment enters a ball, leaves it, touches it or ends before", "[segment_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> ball = {at<S, N>(1, 0), S(5)};
  const auto meet = [&](double x, double y, double to_x, double to_y) {
    return intersect(Segment<S, N>{at<S, N>(x, y), at<S, N>(to_x, to_y)}, ball);
  };
  const auto through = meet(-9, 4, 11, 4);  // 3, 4, 5
  CHECK(through.line_roots == 2);
  CHECK(through.roots == Interval<S>{S(7. / 20), S(13. / 20)});
  CHECK(through.solid == through.roots);
  CHECK(through.surface == S(7. / 20));
  CHECK(through.origin == Location::out);
  const auto tangent = meet(-1, 5, 3, 5);
  CHECK(tangent.line_roots == 1);
  CHECK(tangent.solid == Interval<S>{S(0.5), S(0.5)});
  const auto before = meet(-9, 0, -5, 0);
  CHECK(before.line_roots == 2);
  CHECK_FALSE(before);
  CHECK_FALSE(before.surface);
  const auto from_within = meet(1, 0, 11, 0);
  CHECK(from_within.origin == Location::in);
  CHECK(from_within.solid == Interval<S>{0, S(0.5)});
  CHECK(from_within.surface == S(0.5));
  const auto onto = meet(-9, 4, -2, 4);
  CHECK(onto.solid == Interval<S>{1, 1});
  CHECK(onto.surface == S(1));
  const auto away = meet(-2, 4, -9, 4);
  CHECK(away.origin == Location::on);
  CHECK(away.solid == Interval<S>{0, 0});
  CHECK(meet(-1, -6, -1, -5).line_roots == 2);
  CHECK(meet(9, 6, 9, 5).line_roots == 0);
}

TEMPLATE_TEST_CASE_SIG("segment and sphere: points, empty balls, nothing finite", "[segment_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Segment<S, N> on = {at<S, N>(3, 4), at<S, N>(3, 4)};
  const auto meets = [&](double radius) { return intersect(on, Sphere<S, N>{at<S, N>(0), static_cast<S>(radius)}); };
  CHECK(meets(5).line_roots == 0);
  CHECK(meets(5).surface == S(0));
  CHECK(meets(5).solid == Interval<S>{0, 1});
  CHECK(meets(6).origin == Location::in);
  CHECK_FALSE(meets(6).surface);
  CHECK(meets(6).solid == Interval<S>{0, 1});
  CHECK_FALSE(meets(4));
  for (const double bad : {not_a_number, inf, -5.0}) CHECK_FALSE(meets(bad));
  CHECK_FALSE(intersect(Segment<S, N>{at<S, N>(not_a_number), at<S, N>(0)}, Sphere<S, N>{at<S, N>(0), S(5)}));
}

TEMPLATE_TEST_CASE_SIG("segment and sphere: every answer is that of rational arithmetic", "[segment_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  std::array<int, 3> roots = {};
  int hits = 0, misses = 0, onto = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(500, 50000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto [segment, ball] = draw<S, N>(random, numbers);
      if (!finite(ball) || !finite(segment) || ball.radius < 0 || segment.p == segment.q) continue;
      const Capsule<S, N> capsule = {ball.center, ball.center, ball.radius};
      const oracle::LineInConvex truth = oracle::line_in_capsule(segment, capsule);
      const RaySphere<S> found = intersect(segment, ball);
      REQUIRE(intersects(segment, ball) == found.solid.has_value());
      REQUIRE(first_hit(segment, ball) == (found.solid ? std::optional<S>(found.solid->lo) : std::nullopt));
      Record<segment_sphere::Event> record;
      REQUIRE(intersect(segment, ball, record).solid == found.solid);

      REQUIRE((found.line_roots > 0) == truth.meets());
      ++roots[static_cast<std::size_t>(found.line_roots)];
      REQUIRE(found.solid.has_value() == truth.meets({0, 1}));
      REQUIRE(found.solid == intersect(segment, capsule));
      (found ? hits : misses) += 1;
      if (found.line_roots == 0) continue;
      REQUIRE(truth.is_within(found.roots.lo, false, 0.6));
      REQUIRE(truth.is_within(found.roots.hi, true, 0.6));

      const auto f = oracle::rational(segment.p) - oracle::rational(ball.center),
                 g = oracle::rational(segment.q) - oracle::rational(ball.center), d = g - f;
      const Rational r2 = Rational(ball.radius) * Rational(ball.radius), ff = oracle::dot(f, f), gg = oracle::dot(g, g);
      const Rational dd = oracle::dot(d, d), fd = oracle::dot(f, d);
      REQUIRE(found.line_roots == (dd * (ff - r2) == fd * fd ? 1 : 2));
      REQUIRE(found.origin == (ff < r2 ? Location::in : ff == r2 ? Location::on : Location::out));
      // No point of the segment lies on the sphere iff both ends are within, or it misses the ball
      REQUIRE(found.surface.has_value() == (truth.meets({0, 1}) && !(ff < r2 && gg < r2)));
      if (found.surface && ff != r2 && gg != r2)
        REQUIRE((ff < r2 ? found.surface == found.roots.hi : found.surface == found.roots.lo));
      onto += gg == r2;
      if (found.surface && gg == r2 && ff > r2 && dd + fd <= 0) REQUIRE(*found.surface == 1);
    }
  }
  for (const int often : roots) CHECK(often > 40);
  for (const int often : {hits, misses}) CHECK(often > 300);
  CHECK(onto > 40);
}

}  // namespace segment_sphere_test
