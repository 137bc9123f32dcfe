#include <isect/numbers/grid.h>

#include <cmath>
#include <limits>

#include <isect/numbers/predicate.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace grid_test {
using namespace isect;
using oracle::Rational;

namespace {

bool is_whole(const Rational& x) { return denominator(x) == 1; }

}  // namespace

TEST_CASE("a double is a multiple of its grid, but of none twice as coarse", "[grid]") {
  bench::Random random(bench::stream(tests::seed(), "grid"));
  for (int i = 0; i < 20000; ++i) {
    const double x = random.one_in(2) ? random.magnitude(-290, 300) : random.integer(-64, 64) / 8.;
    if (x == 0) continue;
    const double step = Grid(x).step();
    INFO(x);
    REQUIRE(is_whole(Rational(x) / Rational(step)));
    REQUIRE_FALSE(is_whole(Rational(x) / (2 * Rational(step))));
    int exponent = 0;
    REQUIRE(std::frexp(step, &exponent) == 0.5);
  }
}

TEST_CASE("grids at the ends of the doubles", "[grid]") {
  CHECK(Grid(0.).step() == 0x1p256);
  CHECK(Grid(-0.).step() == 0x1p256);
  CHECK(Grid().step() == 0x1p256);
  CHECK(Grid(6.).step() == 2);
  CHECK(Grid(-0.75).step() == 0.25);
  CHECK(Grid(0x1p-1022).step() == 0x1p-1022);
  CHECK(Grid(0x1.8p-1022).step() == 0);  // its last bit is subnormal
  CHECK(Grid(5e-324).step() == 0);
  CHECK(Grid(std::numeric_limits<double>::max()).step() == 0x1p971);
  CHECK(Grid::difference(3, 3).step() == 0x1p256);
  CHECK(Grid::difference(3, 0.5).step() == 0.5);
  CHECK(Grid::difference(0, 4).step() == 4);
}

TEST_CASE("a polynomial is a multiple of its grid", "[grid]") {
  bench::Random random(bench::stream(tests::seed(), "polynomials"));
  for (int i = 0; i < 20000; ++i) {
    const double reach = random.one_in(4) ? 150 : 2;
    const auto number = [&] { return random.one_in(2) ? random.integer(-3, 3) : random.magnitude(-reach, reach); };
    const double a = number(), b = number(), c = random.one_in(3) ? a : number(), d = number();
    const auto of = [&]<class W>(W) -> W { return (W(a) * W(b) - W(c) * W(d)) * (W(a) + W(d)) + abs(-W(b)); };
    const double step = of(Grid()).step();
    if (step > 0 && std::isfinite(step)) REQUIRE(is_whole(of(Rational()) / Rational(step)));
  }
}

TEST_CASE("zeros of huge and of tiny numbers are told, or left open", "[grid]") {
  const auto sign = [](double a, double b, double c, double d) {
    return sign_of([&]<class W>() -> W { return W(a) * W(b) - W(c) * W(d); });
  };
  CHECK(sign(0x1p600, 0x1p600, 0x1p500, 0x1p700) == 0);
  CHECK(sign(0x1p600, 0x1p600, 0x1p500, 0x1.0000000000001p700) == -1);
  CHECK(sign(0x1p-600, 0x1p-600, 0x1p-500, 0x1p-700) == 0);
  CHECK(sign(0x1p-600, 0x1p-600, 0, 0x1p700) == 1);
  CHECK(sign(0x1p-600, 0x1p-600, 0x1.0000000000001p-500, 0x1p-700) == -1);
  CHECK(sign(5e-324, 5e-324, 0, 0) == 1);
  CHECK(sign(5e-324, 0, 0, 1e308) == 0);
  CHECK(sign(1e308, 1e308, 5e-324, 5e-324) == 1);
  CHECK(sign(0.1, 0.3, 0.3, 0.1) == 0);
  CHECK(sign(0.1, 0.3, 0.3, 0.1 + 0x1p-56) == -1);
}

}  // namespace grid_test
