#include <isect/numbers/short_exact.h>

#include <cmath>
#include <limits>

#include <isect/numbers/predicate.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace short_exact_test {
using namespace isect;
using oracle::Rational;

namespace {

template <class Number>
struct Both {
  Number number;
  Rational truth;
};

template <class Number, class Leaf>
Both<Number> expression(bench::Random& random, int depth, const Leaf& leaf) {
  if (depth == 0) {
    const double x = leaf(), y = leaf();
    if (random.one_in(2)) return {Number(x), Rational(x)};
    return {difference<Number>(x, y), Rational(x) - Rational(y)};
  }
  const Both<Number> a = expression<Number>(random, depth - 1, leaf),
                     b = expression<Number>(random, random.below(depth), leaf);
  switch (random.below(5)) {
    case 0:
      return {a.number + b.number, a.truth + b.truth};
    case 1:
      return {a.number - b.number, a.truth - b.truth};
    case 2:
      return {-a.number, -a.truth};
    case 3:
      return {abs(a.number), abs(a.truth)};
    default:
      return {a.number * b.number, a.truth * b.truth};
  }
}

/// How many of `count` expressions have a known sign, which must be the true one.
template <class Number, class Leaf>
int known(bench::Random& random, int count, int depth, const Leaf& leaf) {
  int result = 0;
  for (int i = 0; i < count; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", expression " << i);
    const Both<Number> x = expression<Number>(random, 1 + random.below(depth), leaf);
    if (x.number.sign()) REQUIRE(*x.number.sign() == x.truth.sign());
    result += x.number.sign().has_value();
  }
  return result;
}

}  // namespace

TEST_CASE("a sign that is known is the true one", "[short_exact]") {
  bench::Random random(bench::stream(tests::seed(), "short_exact"));
  const auto small = [&] { return static_cast<double>(random.integer(-1, 1)); };
  const auto tenth = [&] { return random.integer(-30, 30) / 10; };
  const auto wide = [&] { return random.one_in(8) ? 0. : random.magnitude(-20, 20); };
  const auto extreme = [&] { return random.one_in(3) ? 0. : random.magnitude(-320, 308); };
  CHECK(known<ShortExact>(random, 20000, 4, small) == 20000);
  CHECK(known<ShortExact>(random, 20000, 4, tenth) > 10000);
  const int of_wide = known<ShortExact>(random, 20000, 5, wide),
            more_of_wide = known<MediumExact>(random, 20000, 5, wide);
  CHECK(of_wide > 2000);
  CHECK(of_wide < more_of_wide);
  CHECK(more_of_wide < 20000);
  CHECK(known<ShortExact>(random, 20000, 5, extreme) > 2000);
  CHECK(known<MediumExact>(random, 20000, 5, extreme) > 2000);
}

TEST_CASE("tenths settle a polynomial of degree four in 255 bits", "[short_exact]") {
  bench::Random random(bench::stream(tests::seed(), "tenths"));
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&] { return random.integer(-9, 9) / 10.; };
    const double a = number(), b = number(), c = random.one_in(2) ? a : number(), d = random.one_in(2) ? b : number();
    const auto polynomial = [&]<class W>(W) -> W { return (W(a) * W(b) - W(c) * W(d)) * (W(a) * W(a) + W(d) * W(c)); };
    const auto sign = polynomial(MediumExact()).sign();
    REQUIRE(sign == polynomial(Rational()).sign());
    zeros += sign == 0;
  }
  CHECK(zeros > 2000);
}

TEST_CASE("quotients and roots of short numbers err by less than a double shows", "[short_exact]") {
  bench::Random random(bench::stream(tests::seed(), "quotients"));
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&] { return random.magnitude(-2, 2); };
    const double a = number(), b = number(), c = number();
    const MediumExact num = MediumExact(a) * MediumExact(b) - MediumExact(c), den = MediumExact(c) * MediumExact(a);
    const Rational truth = (Rational(a) * Rational(b) - Rational(c)) / (Rational(c) * Rational(a));
    REQUIRE(oracle::ulps(quotient(num, den), oracle::real(truth)) <= 0.501);
    const MediumExact square = den * den + MediumExact(a) * MediumExact(a), root = sqrt(square);
    const Rational of_root = (Rational(c) * Rational(c) + 1) * Rational(a) * Rational(a);
    const Rational r = Rational(quotient(root, MediumExact(1.0))), left = of_root - r * r;
    REQUIRE(abs(left) <= of_root * Rational(0x1p-52));
    const Rational rest = Rational(quotient(square - root * root, square));
    REQUIRE(abs(rest) <= Rational(0x1p-101));
  }
  CHECK(quotient(MediumExact(), MediumExact(3.0)) == 0);
  CHECK(quotient(MediumExact(5e-324), MediumExact(-0x1p-1000)) == -0x1p-74);
  CHECK(sqrt(MediumExact(0x1p-1073)).sign() == 1);
  CHECK(quotient(sqrt(MediumExact(9.)), MediumExact(1.)) == 3);
  const MediumExact unknown = MediumExact(0x1p500) + MediumExact(1.0);
  CHECK(std::isnan(quotient(unknown, MediumExact(1.0))));
  CHECK(std::isnan(quotient(MediumExact(1.0), unknown)));
  CHECK_FALSE(sqrt(unknown).sign());
}

TEST_CASE("whole numbers of 28 bits settle a polynomial of degree four", "[short_exact]") {
  bench::Random random(bench::stream(tests::seed(), "degree four"));
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&] { return random.integer(-(1 << 28), 1 << 28); };
    const double a = number(), b = number(), c = number(), d = number();
    const auto polynomial = [&]<class W>(W) -> W { return (W(a) * W(b) - W(c) * W(d)) * (W(a) * W(a) + W(d) * W(c)); };
    REQUIRE(polynomial(ShortExact()).sign() == polynomial(Rational()).sign());
  }
}

TEST_CASE("it knows 127 bits, and no more", "[short_exact]") {
  const double p = 0x1p63;
  CHECK((ShortExact(p) + ShortExact(1.0)).sign() == 1);
  CHECK((ShortExact(0x1p126) - ShortExact(0x1p126)).sign() == 0);
  CHECK((ShortExact(0x1p125) + ShortExact(1.0)).sign() == 1);
  CHECK_FALSE((ShortExact(0x1p126) + ShortExact(1.0)).sign());
  const ShortExact wide = ShortExact(0x1p60) + ShortExact(1.0);
  CHECK((wide * wide).sign() == 1);
  CHECK_FALSE((wide * wide * wide).sign());
}

TEST_CASE("the longer kind knows 255 bits, and no more", "[short_exact]") {
  for (int shift = 1; shift < 250; ++shift) {
    const MediumExact far = MediumExact(std::ldexp(1.0, shift)), both = far + MediumExact(3.0);
    REQUIRE((both - far - MediumExact(3.0)).sign() == 0);
    REQUIRE((both - far).rounded() == 3);
    REQUIRE((-both + far).rounded() == -3);
  }
  CHECK((MediumExact(0x1p253) + MediumExact(1.0)).sign() == 1);
  CHECK_FALSE((MediumExact(0x1p255) + MediumExact(1.0)).sign());
}

TEST_CASE("0 times the unknown is 0, all else made of the unknown is unknown", "[short_exact]") {
  const ShortExact unknown = ShortExact(0x1p500) + ShortExact(1.0), zero;
  CHECK_FALSE(unknown.sign());
  CHECK((unknown * zero).sign() == 0);
  CHECK((zero * unknown).sign() == 0);
  CHECK_FALSE((unknown - unknown).sign());
  CHECK_FALSE((unknown + zero).sign());
  CHECK_FALSE((zero - unknown).sign());
  CHECK_FALSE((unknown * ShortExact(5e-324)).sign());
  CHECK_FALSE((-unknown).sign());
  CHECK_FALSE(abs(unknown).sign());
}

TEST_CASE("the ends of the doubles are known, infinity and NaN are not", "[short_exact]") {
  CHECK(ShortExact(-0.).sign() == 0);
  CHECK(ShortExact(5e-324).sign() == 1);
  CHECK(difference<ShortExact>(5e-324, 0).sign() == 1);
  CHECK(ShortExact(-std::numeric_limits<double>::max()).sign() == -1);
  CHECK_FALSE(ShortExact(std::numeric_limits<double>::infinity()).sign());
  CHECK_FALSE(ShortExact(std::numeric_limits<double>::quiet_NaN()).sign());
}

TEST_CASE("products of vectors along different axes are 0 to it", "[short_exact]") {
  const Vector<double, 3> x = {3, 0, 0}, y = {0, -1e-300, 1e300};
  CHECK(dot(exactly<ShortExact>(x), exactly<ShortExact>(y)).sign() == 0);
  CHECK(cross(exactly<ShortExact>(x), exactly<ShortExact>(x))[1].sign() == 0);
  CHECK_FALSE(dot(exactly<ShortExact>(y), exactly<ShortExact>(y)).sign());
}

}  // namespace short_exact_test
