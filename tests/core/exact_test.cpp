#include <isect/numbers/exact.h>

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace exact_test {
using namespace isect;
using tests::inf;
namespace mp = boost::multiprecision;
using Rational = mp::number<mp::gmp_rational, mp::et_off>;
using Decimal = mp::number<mp::mpfr_float_backend<1000>, mp::et_off>;

namespace {

/// (a b - c d)(a + c) - b (d - e): what predicates are made of.
template <class T>
T polynomial(const T& a, const T& b, const T& c, const T& d, const T& e) {
  return (a * b - c * d) * (a + c) - b * (d - e);
}

double nearest(const Rational& x) { return static_cast<double>(Decimal(x)); }

}  // namespace

TEST_CASE("a double survives the way to the exact scalar and back", "[exact]") {
  for (const double x : {0.0, 1.0, -0.1, 1e300, -1e-300, 5e-324, std::numeric_limits<double>::max(),
                         -std::numeric_limits<double>::min()})
    CHECK(Exact(x).rounded() == x);
  CHECK(Exact(-0.0).sign() == 0);
}

TEST_CASE("polynomials have the sign and the value that rationals give", "[exact]") {
  bench::Random random(bench::stream(tests::seed(), "exact"));
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < 5000; ++i) {
    const double reach = random.one_in(2) ? 2 : 90;
    const auto number = [&] { return random.one_in(6) ? random.integer(-3, 3) : random.magnitude(-reach, reach); };
    const double a = number(), b = number(), c = random.one_in(3) ? -a : number();
    const double d = random.one_in(3) ? -b : number(), e = number();
    const Rational truth = polynomial<Rational>(a, b, c, d, e);
    const Exact value = polynomial<Exact>(a, b, c, d, e);
    REQUIRE(value.sign() == truth.sign());
    REQUIRE(value.rounded() == nearest(truth));
  }
}

TEST_CASE("the smallest and the largest doubles meet without loss", "[exact]") {
  const Exact tiny = 5e-324, huge = 1e308;
  CHECK((huge + tiny - huge).rounded() == 5e-324);
  CHECK((huge * huge - huge * huge).sign() == 0);
  CHECK((huge * huge * tiny - huge * huge).sign() == -1);
  CHECK((tiny * tiny).sign() == 1);
  CHECK((tiny * tiny).rounded() == 0);
  CHECK((huge * huge).rounded() == inf);
  CHECK((-huge * huge).rounded() == -inf);
}

TEST_CASE("rounding goes to the nearest double, and to the even one at a tie", "[exact]") {
  const double even = 0x1p53, odd = even + 2;
  CHECK((Exact(even) + Exact(1.0)).rounded() == even);
  CHECK((Exact(odd) + Exact(1.0)).rounded() == even + 4);
  CHECK((Exact(even) + Exact(1.0) + Exact(5e-324)).rounded() == odd);
  CHECK((Exact(odd) + Exact(1.0) - Exact(5e-324)).rounded() == odd);
}

TEST_CASE("quotients are the nearest doubles", "[exact]") {
  CHECK(quotient(Exact(1.0), Exact(3.0)) == 1.0 / 3.0);
  CHECK(quotient(Exact(0.0), Exact(-7.0)) == 0);
  CHECK(quotient(Exact(1e300), Exact(-1e-300)) == -inf);

  bench::Random random(bench::stream(tests::seed(), "quotient"));
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < 5000; ++i) {
    const double a = random.magnitude(-40, 40), b = random.magnitude(-40, 40), c = random.magnitude(-40, 40);
    REQUIRE(quotient(Exact(a) * b + c, Exact(b) - c) == nearest((Rational(a) * b + c) / (Rational(b) - c)));
  }
}

TEST_CASE("quotients below the normal numbers are the nearest too", "[exact]") {
  bench::Random random(bench::stream(tests::seed(), "subnormal"));
  INFO("ISECT_SEED=" << tests::seed());
  for (int i = 0; i < 5000; ++i) {
    const double a = random.magnitude(-170, -150), b = random.magnitude(150, 160);  // 0 now and then
    REQUIRE(quotient(Exact(a), Exact(b)) == nearest(Rational(a) / Rational(b)));
  }
}

TEST_CASE("square roots are truncated, by a relative 2^-126 at most", "[exact]") {
  CHECK(sqrt(Exact(0.0)).sign() == 0);
  CHECK((sqrt(Exact(1e300) * 1e300) - Exact(1e300)).sign() == 0);

  bench::Random random(bench::stream(tests::seed(), "sqrt"));
  INFO("ISECT_SEED=" << tests::seed());
  const Exact next = Exact(1.0) + Exact(0x1p-126);
  const auto check = [&](const Exact& x) {
    const Exact root = sqrt(x), above = root * next;
    REQUIRE((root * root - x).sign() <= 0);
    REQUIRE((above * above - x).sign() >= 0);
  };
  for (int i = 0; i < 5000; ++i) {
    const double a = std::abs(random.magnitude(-300, 300)), b = std::abs(random.magnitude(-300, 300));
    check(a);
    check(Exact(a) * b + random.unit());
  }
}

}  // namespace exact_test
