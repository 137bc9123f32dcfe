#include <isect/numbers/arithmetic.h>

#include <cmath>

#include <isect/parts/ray_sphere_arithmetic.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace arithmetic_test {
using namespace isect;
using namespace isect::ray_sphere::detail;
using tests::inf, tests::not_a_number;

namespace {}

TEST_CASE("the unit roundoff is half the gap above 1, and 0 for exact numbers", "[arithmetic]") {
  CHECK(unit<double> == 0x1p-53);
  CHECK(unit<DoubleDouble> == 0x1p-103);
  CHECK(unit<Exact> == 0);
  CHECK(1 + unit<double> == 1);
  CHECK(1 + 2 * unit<double> > 1);
}

TEST_CASE("differences of doubles are exact in the finer arithmetics", "[arithmetic]") {
  CHECK(difference<double>(1, 0x1p-60) == 1);
  const DoubleDouble fine = difference<DoubleDouble>(1, 0x1p-60);
  CHECK(fine.hi == 1);
  CHECK(fine.lo == -0x1p-60);
  CHECK((difference<Exact>(1, 0x1p-60) - Exact(1.0)).rounded() == -0x1p-60);
}

TEMPLATE_TEST_CASE("every arithmetic multiplies doubles and itself", "[arithmetic]", double, DoubleDouble, Exact) {
  const TestType three = product<TestType>(1.5, 2.0);
  CHECK(rounded(three) == 3);
  CHECK(rounded(product<TestType>(three, 2.0)) == 6);
  CHECK(rounded(product<TestType>(2.0, three)) == 6);
  CHECK(rounded(product<TestType>(three, three)) == 9);
  CHECK(quotient(three, product<TestType>(1.0, 4.0)) == 0.75);
}

TEMPLATE_TEST_CASE("products err by at most the unit roundoff, differences too", "[arithmetic]", double, DoubleDouble) {
  bench::Random random(bench::stream(tests::seed(), "filter"));
  INFO("ISECT_SEED=" << tests::seed());
  const auto exact = [](const TestType& x) {
    if constexpr (std::is_same_v<TestType, DoubleDouble>)
      return Exact(x.hi) + Exact(x.lo);
    else
      return Exact(x);
  };
  const auto within = [&](const TestType& got, const Exact& truth) {
    const Exact error = exact(got) - truth, bound = truth * unit<TestType>;
    return (error * error - bound * bound).sign() <= 0;
  };
  for (int i = 0; i < 2000; ++i) {
    const double a = random.magnitude(-20, 20), b = random.magnitude(-20, 20), c = random.magnitude(-20, 20);
    REQUIRE(within(product<TestType>(a, b), Exact(a) * b));
    REQUIRE(within(difference<TestType>(a, b), Exact(a) - b));
    const TestType ab = product<TestType>(a, b);
    REQUIRE(within(product<TestType>(ab, c), exact(ab) * c));
    REQUIRE(within(product<TestType>(ab, ab), exact(ab) * exact(ab)));
  }
}

TEST_CASE("a sign is certain beyond its bound and unknown within it", "[arithmetic]") {
  CHECK(certain_sign(2.0, 1.0) == 1);
  CHECK(certain_sign(-2.0, 1.0) == -1);
  CHECK_FALSE(certain_sign(1.0, 1.0));
  CHECK_FALSE(certain_sign(-0.5, 1.0));
  CHECK_FALSE(certain_sign(0.0, 0.0));
  CHECK(certain_sign(DoubleDouble{3, 0}, 8.0) == 1);
  CHECK_FALSE(certain_sign(DoubleDouble{3, 0}, 9.0));
}

TEST_CASE("NaN has no sign, and neither has a number with an unknown bound", "[arithmetic]") {
  CHECK_FALSE(certain_sign(not_a_number, 0.0));
  CHECK_FALSE(certain_sign(1.0, not_a_number));
  CHECK_FALSE(certain_sign(inf, inf));
}

TEST_CASE("exact numbers always have a sign, zero included", "[arithmetic]") {
  CHECK(certain_sign(Exact(0.0), 0.0) == 0);
  CHECK(certain_sign(Exact(5e-324), 0.0) == 1);
  CHECK(certain_sign(Exact(-1e300), 0.0) == -1);
}

TEST_CASE("sizes out of range are left to exact numbers", "[arithmetic]") {
  CHECK(in_range<double>(1));
  CHECK(in_range<double>(0x1p100));
  CHECK(in_range<DoubleDouble>(0x1p-100));
  CHECK_FALSE(in_range<double>(0));
  CHECK_FALSE(in_range<double>(0x1p101));
  CHECK_FALSE(in_range<DoubleDouble>(0x1p-101));
  CHECK_FALSE(in_range<double>(not_a_number));
  CHECK_FALSE(in_range<double>(inf));
  CHECK(in_range<Exact>(0));
}

TEST_CASE("the leading double of a pair is its high part", "[arithmetic]") {
  CHECK(leading(DoubleDouble{1, 0x1p-60}) == 1);
  CHECK(leading(2.5) == 2.5);
  CHECK(leading(Exact(7.0)) == 0);
  CHECK(rounded(Exact(7.0)) == 7);
}

}  // namespace arithmetic_test
