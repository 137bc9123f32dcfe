#include <isect/parts/squares.h>

#include <limits>

#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace squares_test {
using namespace isect;
using namespace isect::oracle;

TEMPLATE_TEST_CASE("squared lengths that are trusted are in their true order, at every scale", "[squares]", float,
                   double) {
  using S = TestType;
  constexpr bool is_float = std::is_same_v<S, float>;
  bench::Random random(tests::seed());
  int trusted = 0, less = 0, in_doubt = 0;
  for (int i = 0; i < tests::cases(30000, 1000000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    // where squares are ordinary, vanish bit by bit, or overflow
    const int scales[] = {0, is_float ? random.integer(-78, -45) : random.integer(-545, -480),
                          is_float ? random.integer(58, 67) : random.integer(500, 515)};
    const double scale = std::ldexp(1.0, scales[random.below(3)]);
    const Vector<S, 3> p = (scale * random.in_box<3>(1)).template cast<S>(),
                       q = (scale * random.in_box<3>(1)).template cast<S>();
    const double distance = (p - q).template cast<double>().stableNorm();
    const double nudge = 1 + random.integer(-20, 20) * double(unit<S>) * (random.one_in(3) ? 1e6 : 1);
    const double share = random.unit();
    const S r = static_cast<S>(distance * share * nudge), s = static_cast<S>(distance * (1 - share) * nudge);
    const S x = (p - q).squaredNorm(), y = (r + s) * (r + s);

    const Coordinates<3> f = rational<S, 3>(p) - rational<S, 3>(q);
    const Rational sum = Rational(r) + Rational(s);
    const int truth = sign(dot(f, f) - sum * sum);
    if (ordered(x, y) && (x < y ? -1 : 1) != truth) FAIL("wrong");
    if (order_of_squares(x, y, [&] { return truth; }) != truth) FAIL("wrong");
    if (ordered(x, y) != ordered(y, x)) FAIL("not symmetric");
    trusted += ordered(x, y), in_doubt += !ordered(x, y), less += ordered(x, y) && x < y;
  }
  CHECK(less > 1000);
  CHECK(trusted - less > 1000);
  CHECK(in_doubt > 1000);
}

TEST_CASE("the order of NaN, infinities and what vanishes is never trusted", "[squares]") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {inf, nan})
    for (const double y : {0.0, 1.0, inf, nan}) {
      CHECK_FALSE(ordered(x, y));
      CHECK_FALSE(ordered(y, x));
    }
  CHECK_FALSE(ordered(0., 0.));
  CHECK_FALSE(ordered(0., 0x1p-1001));
  CHECK_FALSE(ordered(1., 1 + 0x1p-51));
  CHECK(ordered(1., 1 + 0x1p-47));
  CHECK(ordered(0., 1e-300));
}

}  // namespace squares_test
