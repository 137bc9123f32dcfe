#include <isect/point_point.h>

#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace point_point_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

TEMPLATE_TEST_CASE_SIG("points are equal when all their coordinates are", "[point_point]", FLOATS_AND_DIMENSIONS) {
  CHECK(equal(at<S, N>(1, 2), at<S, N>(1, 2)));
  CHECK(equal(at<S, N>(0.0, 2), at<S, N>(-0.0, 2)));
  for (int i = 0; i < N; ++i) {
    Point<S, N> p = at<S, N>(1, 2);
    p[i] = std::nextafter(p[i], S(9));
    CHECK_FALSE(equal(p, at<S, N>(1, 2)));
  }
}

TEST_CASE("a tenth and two tenths are not three tenths, but nearly", "[point_point]") {
  const Point<double, 2> p = {.1 + .2, 0}, q = {.3, 0};
  CHECK_FALSE(equal(p, q));
  CHECK(nearly_equal(p, q, 1e-15));
  CHECK_FALSE(nearly_equal(p, q, 1e-17));
  CHECK(equal<double, 2>({1e16 + 1, 0}, {1e16, 0}));  // the same double: the sum was rounded before
}

TEMPLATE_TEST_CASE_SIG("NaN and infinite coordinates equal nothing, themselves neither", "[point_point]",
                       FLOATS_AND_DIMENSIONS) {
  for (const double bad : {not_a_number, inf, -inf})
    for (int i = 0; i < N; ++i) {
      Point<S, N> p = at<S, N>(1, 2);
      p[i] = S(bad);
      CHECK_FALSE(equal(p, p));
      CHECK_FALSE(equal(p, at<S, N>(1, 2)));
      CHECK_FALSE(equal(at<S, N>(1, 2), p));
      for (const S tolerance : {S(0), S(9), S(inf)}) {
        CHECK_FALSE(nearly_equal(p, p, tolerance));
        CHECK_FALSE(nearly_equal(p, at<S, N>(1, 2), tolerance));
      }
    }
}

TEMPLATE_TEST_CASE_SIG("a tolerance is a closed ball", "[point_point]", FLOATS_AND_DIMENSIONS) {
  const Point<S, N> p = at<S, N>(1, 1), q = at<S, N>(4, 5);
  CHECK(nearly_equal(p, q, S(5)));
  CHECK(nearly_equal(p, q, std::nextafter(S(5), S(6))));
  CHECK_FALSE(nearly_equal(p, q, std::nextafter(S(5), S(4))));
  CHECK(nearly_equal(p, q, S(inf)));
  CHECK_FALSE(nearly_equal(p, p, S(-1)));
  CHECK_FALSE(nearly_equal(p, p, S(not_a_number)));
  CHECK(nearly_equal(p, p, S(0)));
  CHECK(nearly_equal(p, p, S(-0.0)));
}

TEMPLATE_TEST_CASE_SIG("a tolerance may be of any size", "[point_point]", FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(nearly_equal(at<S, N>(0, 0), at<S, N>(3 * k, 4 * k), S(5 * k)));
    CHECK_FALSE(nearly_equal(at<S, N>(0, 0), at<S, N>(3 * k, 4 * k), std::nextafter(S(5 * k), S(0))));
  }
}

TEST_CASE("the events tell the coordinates up to the first that differs", "[point_point]") {
  Record<point_point::Event<double>> record;
  equal<double, 3>({1, 2, 3}, {1, 5, 3}, record);
  REQUIRE(record.events.size() == 2);
  const auto& last = std::get<point_point::Coordinate<double>>(record.events[1]);
  CHECK((last.axis == 1 && last.p == 2 && last.q == 5 && !last.equal));
  record.events.clear();
  nearly_equal<double, 3>({0, 0, 0}, {3, 4, 0}, 5, record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));
  CHECK(std::get<point_point::Distance>(record.events.back()).sign == 0);
}

TEMPLATE_TEST_CASE_SIG("two points: verdicts are those of rational arithmetic", "[point_point]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int near = 0, far = 0, same = 0, exact = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Point<S, N> p = bench::vector<S, N>(random, numbers);
      Point<S, N> q = random.one_in(10) ? p : bench::vector<S, N>(random, numbers);
      if (random.one_in(3)) q[0] = p[0];
      S tolerance = static_cast<S>((p - q).template cast<double>().stableNorm());
      if (random.one_in(10)) tolerance = 0;
      if (!std::isfinite(tolerance)) continue;
      tolerance = std::max(S(0), bench::moved(tolerance, random.integer(-2, 2)));

      const Coordinates<N> f = rational(p) - rational(q);
      const Rational gap = dot(f, f) - Rational(tolerance) * Rational(tolerance);
      if (equal(p, q) != (dot(f, f) == 0)) FAIL("wrong: equal");
      if (nearly_equal(p, q, tolerance) != (gap <= 0)) FAIL("wrong: nearly equal");
      if (nearly_equal(p, q, S(0)) != equal(p, q)) FAIL("a tolerance of 0 is not equality");
      if (nearly_equal(q, p, tolerance) != (gap <= 0)) FAIL("not symmetric");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (nearly_equal(move(p), move(q), move(tolerance)) != (gap <= 0)) FAIL("not the same when moved");
      }
      near += gap <= 0, far += gap > 0, same += equal(p, q), exact += gap == 0;
    }
  for (const int count : {near, far, same, exact}) CHECK(count > 300);
}

}  // namespace point_point_test
