// The smallest ball against the true one in rationals, where rounding hurts: far away, flat, nearly on one sphere, at
// the ends of the range. And on many points, where what it rests on is its own proof.

#include <isect/parts/smallest_sphere.h>

#include <boost/multiprecision/mpfr.hpp>
#include <limits>

#include <isect/fit_tight.h>
#include <isect/point_sphere.h>
#include "bench/random_shapes.h"
#include "tests/catch.h"
#include "tests/core/ball_oracle.h"
#include "tests/settings.h"

namespace smallest_sphere_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using oracle::operator-;
using Decimal =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>, boost::multiprecision::et_off>;

namespace {

template <class S, int N>
using Points = std::vector<Point<S, N>>;

template <class S>
Rational ulp_of(S x) {
  constexpr S most = std::numeric_limits<S>::max();
  return x < most ? Rational(std::nextafter(x, most)) - Rational(x) : Rational(x) - Rational(std::nextafter(x, S(0)));
}

/// All that isect/fit_tight.h promises of the smallest ball.
template <class S, int N>
void check_promises(const Points<S, N>& points) {
  const Sphere<S, N> ball = fit_sphere_smallest(points);
  const oracle::Ball<N> truth = oracle::smallest_ball<S, N>(points);
  for (int k = 0; k < N; ++k)
    if (oracle::ulps(ball.center[k], truth.center[k]) > 0.501) FAIL("the center is off");
  if (std::isinf(ball.radius)) {
    const Rational most = std::numeric_limits<S>::max();
    if (truth.radius2 * 4 < most * most) FAIL("infinite for nothing");
    return;
  }

  const auto center = oracle::rational<S, N>(ball.center);
  Rational farthest2 = 0;
  for (const Point<S, N>& p : points) {
    const auto f = oracle::rational<S, N>(p) - center;
    farthest2 = std::max(farthest2, oracle::dot(f, f));
  }
  const Rational radius = ball.radius, ulp = ulp_of(ball.radius);
  if (radius * radius < farthest2) FAIL("a point is outside");
  const Rational less = ball.radius > 0 ? Rational(std::nextafter(ball.radius, S(0))) : Rational(-1);
  if (less >= 0 && less * less >= farthest2) FAIL("a smaller radius would do");

  const auto off = center - truth.center;
  const Rational d2 = oracle::dot(off, off);
  const Decimal d = sqrt(Decimal(d2)), least = sqrt(Decimal(truth.radius2)), found = Decimal(radius - ulp),
                best = sqrt(Decimal(truth.radius2 + d2)), room = 1 + Decimal(1e-50);
  if (found > (least + d) * room) FAIL("larger than the center's rounding makes it");
  if (found > Decimal(1.42) * best) FAIL("too large beside the best of all centers");
  Rational largest = 0;
  for (const Rational& c : truth.center) largest = std::max(largest, Rational(abs(c)));
  if (largest * largest <= truth.radius2 && Decimal(radius) > least + 2 * Decimal(ulp)) FAIL("off by more than 2 ulp");
}

/// Points on a sphere or a circle of it, nearly; on a needle; one or few ulps apart; or anywhere.
template <int N>
std::vector<Point<double, N>> shape(Random& random, int n) {
  std::vector<Point<double, N>> points(n);
  const int kind = random.below(6);
  const Vector<double, N> axis = random.heading<N>();
  const double thin = std::ldexp(1., -random.below(60));
  for (Point<double, N>& p : points) {
    p = random.heading<N>();
    if (kind == 0) p *= random.unit();
    if (kind == 1) p = random.uniform(-1, 1) * axis + thin * p;                              // a needle
    if (kind == 2) p = points[0] + thin * p;                                                 // nearly coincident
    if (kind == 3) p *= 1 + thin * random.uniform(-1, 1);                                    // nearly on a sphere
    if (kind == 4 && random.one_in(2)) p = -points[0] * (1 + thin * random.uniform(-1, 1));  // a diameter
    if (kind == 5) p = (p - p.dot(axis) * axis).normalized() + thin * axis;                  // nearly on a great circle
  }
  return points;
}

}  // namespace

TEST_CASE("three points that were 1,594 ulp off are within 2", "[smallest_sphere]") {
  const Points<double, 3> points = {{1, -1, 1e-6}, {-1, -1, 0}, {-0.9999999999999999, 1, 1e-6}};
  check_promises(points);
  CHECK(fit_sphere_smallest(points).radius == Approx(1.414213562373095).epsilon(1e-15));
}

TEMPLATE_TEST_CASE_SIG("the center is the rounded one, and the radius the least for it, near and far",
                       "[smallest_sphere]", FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "smallest ball"));
  for (int i = 0; i < tests::cases(300, 30000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const double far = random.one_in(3) ? 0 : random.magnitude(1, 9);
    const Vector<double, N> away = far * random.heading<N>();
    const double size = random.one_in(2) ? 1 : std::abs(random.magnitude(-9, 3));
    Points<S, N> points;
    for (const Point<double, N>& p : shape<N>(random, 2 + random.below(6)))
      points.push_back((away + size * p).template cast<S>());
    check_promises(points);
  }
}

TEMPLATE_TEST_CASE_SIG("so for lattices, decimals, and numbers of any magnitude", "[smallest_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "smallest ball of numbers"));
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(40, 3000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Points<S, N> points(1 + random.below(7));
      for (Point<S, N>& p : points) p = bench::vector<S, N>(random, numbers);
      check_promises(points);
    }
  using Limits = std::numeric_limits<S>;
  for (int i = 0; i < tests::cases(100, 5000); ++i) {  // at the ends of the range
    INFO("seed " << tests::seed() << ", end " << i);
    Points<S, N> points(1 + random.below(6));
    for (Point<S, N>& p : points)
      for (S& x : p)
        x = i % 2 ? static_cast<S>(random.integer(-9, 9)) * Limits::denorm_min()
                  : static_cast<S>(random.uniform(-1, 1)) * Limits::max();
    check_promises(points);
  }
}

TEMPLATE_TEST_CASE_SIG("the ball of what it rests on holds all of many points", "[smallest_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "smallest ball of many"));
  for (int i = 0; i < tests::cases(40, 1000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Points<S, N> points;
    for (const Point<double, N>& p : shape<N>(random, 5 + random.below(300))) points.push_back(p.template cast<S>());
    Record<fit_tight::Event> record;
    const Sphere<S, N> ball = fit_sphere_smallest(points, record);
    REQUIRE(ball.radius == fit_sphere_smallest(points).radius);
    Points<S, N> support;
    for (const int k : std::get<fit_tight::Supported>(record.events.at(0)).points) support.push_back(points[k]);
    REQUIRE(support.size() <= N + 1);

    const oracle::Ball<N> truth = oracle::smallest_ball<S, N>(support);
    for (const Point<S, N>& p : points) {
      const auto f = oracle::rational<S, N>(p) - truth.center;
      if (oracle::dot(f, f) > truth.radius2) FAIL("a point is outside");
    }
    for (int k = 0; k < N; ++k) REQUIRE(oracle::ulps(ball.center[k], truth.center[k]) <= 0.501);
  }
}

TEMPLATE_TEST_CASE_SIG("points that are the same rest on one", "[smallest_sphere]", FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> ball = fit_sphere_smallest(Points<S, N>(5, Point<S, N>::Constant(S(0.1))));
  CHECK(ball.radius == 0);
  CHECK(ball.center == Point<S, N>::Constant(S(0.1)));
}

}  // namespace smallest_sphere_test
