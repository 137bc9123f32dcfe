// Every bound that isect/numbers/double_double.h states, against rational numbers.

#include <isect/numbers/double_double.h>

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace double_double_test {
using namespace isect;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

namespace {

constexpr int rounds = 20000;
const Rational u2 = Rational(1) / Rational(std::ldexp(1.0, 106));

Rational exact(double x) { return Rational(x); }
Rational exact(const DoubleDouble& x) { return Rational(x.hi) + Rational(x.lo); }
Rational size(const Rational& x) { return x < 0 ? Rational(-x) : x; }

/// Draws numbers with full mantissas, and sometimes numbers close to each other, whose sums cancel.
struct Operands {
  bench::Random random{bench::stream(tests::seed(), "double_double")};
  DoubleDouble last = {1, 0};

  double number() { return random.magnitude(-40, 40); }
  DoubleDouble pair() {
    if (random.one_in(4)) return last = {-last.hi, -last.lo + random.integer(-4, 4) * std::ldexp(last.hi, -105)};
    const double hi = number();
    return last = fast_two_sum(hi, random.uniform(-0.5, 0.5) * std::ldexp(1.0, std::ilogb(hi) - 52));
  }
};

bool normalised(const DoubleDouble& x) { return x.hi + x.lo == x.hi; }

}  // namespace

TEST_CASE("sums and products of two doubles are exact", "[double_double]") {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds; ++i) {
    const double a = operands.number(), b = operands.random.one_in(4) ? -a * (1 + 0x1p-50) : operands.number();
    REQUIRE(exact(two_sum(a, b)) == exact(a) + exact(b));
    REQUIRE(exact(two_product(a, b)) == exact(a) * exact(b));
    const bool ordered = std::abs(a) >= std::abs(b);
    REQUIRE(exact(ordered ? fast_two_sum(a, b) : fast_two_sum(b, a)) == exact(a) + exact(b));
  }
}

TEST_CASE("what a sum or a product leaves is known to the last bit", "[double_double]") {
  const DoubleDouble sum = two_sum(1, 0x1p-60);
  CHECK(sum.hi == 1);
  CHECK(sum.lo == 0x1p-60);
  const DoubleDouble product = two_product(1 + 0x1p-30, 1 + 0x1p-30);
  CHECK(product.hi == 1 + 0x1p-29);
  CHECK(product.lo == 0x1p-60);
}

TEST_CASE("double-double sums err by at most 4 u^2 (|x| + |y|)", "[double_double]") {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds; ++i) {
    const DoubleDouble x = operands.pair(), y = operands.pair();
    REQUIRE(normalised(x + y));
    REQUIRE(size(exact(x + y) - (exact(x) + exact(y))) <= 4 * u2 * (size(exact(x)) + size(exact(y))));
    REQUIRE(size(exact(x - y) - (exact(x) - exact(y))) <= 4 * u2 * (size(exact(x)) + size(exact(y))));
  }
}

TEST_CASE("double-double products err by at most 6 u^2 |x y|", "[double_double]") {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds; ++i) {
    const DoubleDouble x = operands.pair(), y = operands.pair();
    REQUIRE(normalised(x * y));
    REQUIRE(size(exact(x * y) - exact(x) * exact(y)) <= 6 * u2 * size(exact(x) * exact(y)));
    REQUIRE(size(exact(x * y.hi) - exact(x) * exact(y.hi)) <= 6 * u2 * size(exact(x) * exact(y.hi)));
  }
}

TEMPLATE_TEST_CASE_SIG("compensated dot products err by at most 11 n u^2 sum |x_i y_i|", "[double_double]",
                       ((int N), N), 2, 3, 4) {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds / 2; ++i) {
    std::array<DoubleDouble, N> x, y;
    std::array<double, N> plain;
    Rational sum = 0, sizes = 0, plain_sum = 0, plain_sizes = 0;
    for (int k = 0; k < N; ++k) {
      x[k] = operands.pair(), y[k] = operands.pair(), plain[k] = y[k].hi;
      if (k > 0 && operands.random.one_in(2)) x[k] = -x[k - 1], y[k] = y[k - 1], plain[k] = plain[k - 1];  // cancels
      sum += exact(x[k]) * exact(y[k]), sizes += size(exact(x[k]) * exact(y[k]));
      plain_sum += exact(x[k]) * exact(plain[k]), plain_sizes += size(exact(x[k]) * exact(plain[k]));
    }
    REQUIRE(size(exact(compensated_dot<N>(x, y)) - sum) <= 11 * N * u2 * sizes);
    REQUIRE(size(exact(compensated_dot<N>(x, plain)) - plain_sum) <= 11 * N * u2 * plain_sizes);
  }
}

TEST_CASE("double-double roots err by at most 4 u^2 sqrt(x)", "[double_double]") {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds; ++i) {
    const DoubleDouble p = operands.pair(), x = p.hi < 0 ? -p : p;
    const Rational root = exact(sqrt(x)), below = root * (1 - 4 * u2), above = root * (1 + 4 * u2);
    REQUIRE(below * below <= exact(x));
    REQUIRE(exact(x) <= above * above);
  }
}

TEST_CASE("a quotient rounds once, after a relative error of at most 8 u^2", "[double_double]") {
  Operands operands;
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < rounds; ++i) {
    const DoubleDouble x = operands.pair(), y = operands.pair();
    const double t = quotient(x, y);
    const Rational truth = exact(x) / exact(y), half_ulp = exact(std::ldexp(1.0, std::ilogb(t) - 53));
    REQUIRE(size(exact(t) - truth) <= half_ulp + 8 * u2 * size(truth));
  }
}

}  // namespace double_double_test
