#include <isect/point_sphere.h>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace point_sphere_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

TEMPLATE_TEST_CASE_SIG("a point lies in a ball, on its surface, or outside, and an ulp decides", "[point_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> ball = {at<S, N>(1, 2), S(5)};
  CHECK(locate(at<S, N>(1, 2), ball) == Location::in);
  CHECK(locate(at<S, N>(4, 6), ball) == Location::on);
  CHECK(locate(at<S, N>(5, 7), ball) == Location::out);
  CHECK(locate(at<S, N>(4, std::nextafter(S(6), S(0))), ball) == Location::in);
  CHECK(locate(at<S, N>(4, std::nextafter(S(6), S(9))), ball) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("a sphere of radius 0 is its center, one of negative radius nothing", "[point_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Point<S, N> c = at<S, N>(1, 2);
  CHECK(locate(c, Sphere<S, N>{c, S(0)}) == Location::on);
  CHECK(locate(c, Sphere<S, N>{c, S(-0.0)}) == Location::on);
  CHECK(locate(at<S, N>(1, 3), Sphere<S, N>{c, S(0)}) == Location::out);
  CHECK(locate(c, Sphere<S, N>{c, S(-1)}) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("point and sphere: NaN and infinite coordinates are outside", "[point_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> ball = {at<S, N>(1, 2), S(5)};
  for (const double bad : {not_a_number, inf, -inf}) {
    for (int i = 0; i < N; ++i) {
      Point<S, N> p = ball.center;
      p[i] = S(bad);
      CHECK(locate(p, ball) == Location::out);
      CHECK(locate(ball.center, Sphere<S, N>{p, S(5)}) == Location::out);
      CHECK(locate(p, Sphere<S, N>{p, S(5)}) == Location::out);
    }
    CHECK(locate(ball.center, Sphere<S, N>{ball.center, S(bad)}) == Location::out);
  }
}

TEMPLATE_TEST_CASE_SIG("point and sphere: lengths of any size give the same verdict", "[point_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(locate(at<S, N>(3 * k, 4 * k), Sphere<S, N>{at<S, N>(0, 0), S(5 * k)}) == Location::on);
    CHECK(locate(at<S, N>(3 * k, 4 * k), Sphere<S, N>{at<S, N>(0, 0), S(6 * k)}) == Location::in);
    CHECK(locate(at<S, N>(3 * k, 4 * k), Sphere<S, N>{at<S, N>(0, 0), S(4 * k)}) == Location::out);
  }
}

TEST_CASE("the events tell the sign, and each fallback", "[point_sphere]") {
  Record<point_sphere::Event> record;
  locate<double, 3>({3, 4, 0}, {{0, 0, 0}, 5}, record);
  REQUIRE(record.events.size() == 2);
  CHECK(std::holds_alternative<Fallback>(record.events[0]));
  CHECK(std::get<point_sphere::Distance>(record.events[1]).sign == 0);
}

TEMPLATE_TEST_CASE_SIG("point and sphere: locations are those of rational arithmetic", "[point_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Sphere<S, N> ball = bench::ball<S, N>(random, numbers);
      Point<S, N> p = random.one_in(20) ? ball.center : bench::vector<S, N>(random, numbers);
      if (random.one_in(3)) p.template tail<N - 1>() = ball.center.template tail<N - 1>();
      if (random.one_in(2)) {
        const double distance = (p - ball.center).template cast<double>().stableNorm();
        ball.radius = bench::moved(static_cast<S>(distance), random.integer(-2, 2));
      }
      if (!finite(ball)) continue;

      const Coordinates<N> f = rational(p) - rational(ball.center);
      const Rational radius = ball.radius, depth = radius * radius - dot(f, f);
      const Location truth = depth < 0 || radius < 0 ? Location::out : depth == 0 ? Location::on : Location::in;
      if (locate(p, ball) != truth) FAIL("wrong");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (locate(move(p), move(ball)) != truth) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(truth)];
    }
  for (const int count : seen) CHECK(count > 300);
}

}  // namespace point_sphere_test
