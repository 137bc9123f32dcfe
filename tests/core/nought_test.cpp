#include <isect/numbers/nought.h>

#include <isect/numbers/predicate.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace nought_test {
using namespace isect;
using oracle::Rational;

namespace {

struct Both {
  Nought nought;
  Rational truth;
};

Both expression(bench::Random& random, int depth) {
  if (depth == 0) {
    const double x = random.integer(-1, 1), y = random.integer(-1, 1);
    if (random.one_in(2)) return {Nought(x), Rational(x)};
    return {Nought::difference(x, y), Rational(x) - Rational(y)};
  }
  const Both a = expression(random, depth - 1), b = expression(random, random.below(depth));
  switch (random.below(5)) {
    case 0:
      return {a.nought + b.nought, a.truth + b.truth};
    case 1:
      return {a.nought - b.nought, a.truth - b.truth};
    case 2:
      return {-a.nought, -a.truth};
    case 3:
      return {abs(a.nought), abs(a.truth)};
    default:
      return {a.nought * b.nought, a.truth * b.truth};
  }
}

}  // namespace

TEST_CASE("what is said to be 0 is 0", "[nought]") {
  bench::Random random(tests::seed());
  int known = 0, unknown = 0;
  for (int i = 0; i < 20000; ++i) {
    INFO("seed " << tests::seed() << ", expression " << i);
    const Both x = expression(random, 1 + random.below(4));
    if (x.nought.sign()) REQUIRE(x.truth == 0);
    known += x.nought.sign().has_value(), unknown += !x.nought.sign() && x.truth != 0;
  }
  CHECK(known > 2000);
  CHECK(unknown > 2000);
}

TEST_CASE("the least double and NaN are not 0", "[nought]") {
  CHECK(Nought(-0.).sign() == 0);
  CHECK_FALSE(Nought(5e-324).sign());
  CHECK_FALSE(Nought(std::numeric_limits<double>::quiet_NaN()).sign());
  CHECK_FALSE(Nought::difference(5e-324, 0).sign());
}

TEST_CASE("products of vectors along different axes are 0 to it", "[nought]") {
  const Vector<double, 3> x = {3, 0, 0}, y = {0, -.1, .7};
  CHECK(dot(exactly<Nought>(x), exactly<Nought>(y)).sign() == 0);
  CHECK(cross(exactly<Nought>(x), exactly<Nought>(x))[1].sign() == 0);
  CHECK_FALSE(dot(exactly<Nought>(y), exactly<Nought>(y)).sign());
}

}  // namespace nought_test
