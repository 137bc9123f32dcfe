// The bound that isect/numbers/triple_double.h derives, and the signs and quotients that are taken from it, against
// rationals.

#include <isect/numbers/triple_double.h>

#include <cmath>

#include <isect/numbers/quotient.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace triple_double_test {
using namespace isect;
using oracle::Rational;

namespace {

Rational rational(const TripleDouble& x) { return Rational(x.hi) + Rational(x.lo) + Rational(x.rest); }

/// A number tracked as predicates do it: with the size and the roundings of its double, and the grid.
struct Tracked {
  Bounded<double> quick;
  TripleDouble split, fused;  ///< by products of either kind
  Grid grid;
  Rational truth;
};

Tracked sum(const Tracked& a, const Tracked& b) {
  return {a.quick + b.quick, a.split + b.split, a.fused + b.fused, a.grid + b.grid, a.truth + b.truth};
}
Tracked opposite(const Tracked& a) { return {-a.quick, -a.split, -a.fused, -a.grid, -a.truth}; }
Tracked product(const Tracked& a, const Tracked& b) {
  return {a.quick * b.quick, detail::product<false>(a.split, b.split), detail::product<true>(a.fused, b.fused),
          a.grid * b.grid, a.truth * b.truth};
}

template <class Number>
Tracked expression(bench::Random& random, int depth, const Number& number) {
  if (depth == 0) {
    const double x = number(), y = random.one_in(2) ? number() : 0;
    if (y == 0) return {Bounded<double>(x), TripleDouble(x), TripleDouble(x), Grid(x), Rational(x)};
    return {Bounded<double>::difference(x, y), TripleDouble::difference(x, y), TripleDouble::difference(x, y),
            Grid::difference(x, y), Rational(x) - Rational(y)};
  }
  const Tracked a = expression(random, depth - 1, number);
  const Tracked b = random.one_in(8) ? a : expression(random, random.below(depth), number);
  switch (random.below(4)) {
    case 0:
      return sum(a, b);
    case 1:
      return sum(a, opposite(b));
    case 2:
      return {abs(a.quick), abs(a.split), abs(a.fused), abs(a.grid), abs(a.truth)};
    default:
      return product(a, b);
  }
}

/// How many signs were certain, how many of those were 0, and the largest ratio of an error to its bound.
struct Seen {
  int certain = 0, zeros = 0;
  double worst = 0;
};
template <class Number>
Seen attacked(bench::Random& random, int count, const Number& number) {
  Seen seen;
  for (int i = 0; i < count; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", expression " << i);
    const Tracked x = expression(random, 1 + random.below(4), number);
    const double size = x.quick.size();
    if (!(0x1p-800 < size && size < 0x1p900) || !(x.grid.step() > 0)) continue;
    REQUIRE(x.split.hi == x.fused.hi);
    REQUIRE(x.split.lo == x.fused.lo);
    REQUIRE(x.split.rest == x.fused.rest);
    const Bounded<TripleDouble> fine(x.split, size, x.quick.roundings());
    const Rational error = abs(rational(x.split) - x.truth);
    REQUIRE(error <= Rational(fine.error()));
    seen.worst = std::max(seen.worst, static_cast<double>(error / Rational(fine.error())));
    const std::optional<int> sign = detail::sign_on_grid(fine, x.grid.step());
    if (sign) REQUIRE(*sign == x.truth.sign());
    seen.certain += sign.has_value(), seen.zeros += sign == 0;
  }
  return seen;
}

}  // namespace

TEST_CASE("the error of a triple-double expression stays within its bound", "[triple_double]") {
  bench::Random random(bench::stream(tests::seed(), "threefold"));
  const auto close = [&] { return 1 + random.integer(-3, 3) * 0x1p-52; };  // all differences cancel
  const auto integer = [&] { return static_cast<double>(random.integer(-4, 4)); };
  const auto tenth = [&] { return random.integer(-30, 30) / 10.; };
  const auto any = [&] { return random.magnitude(-2, 2); };
  const auto wide = [&] { return random.one_in(8) ? 0. : random.magnitude(-60, 60); };
  const int count = 10000;
  const Seen of_close = attacked(random, count, close), of_tenths = attacked(random, count, tenth),
             of_any = attacked(random, count, any), of_wide = attacked(random, count, wide);
  CHECK(attacked(random, count, integer).zeros > count / 20);
  CHECK(of_tenths.certain > 9 * count / 10);
  CHECK(of_tenths.zeros > count / 50);
  CHECK(of_close.certain > 3 * count / 4);
  CHECK(of_any.certain > 9 * count / 10);
  CHECK(of_wide.certain > count / 2);
  CHECK(std::max({of_close.worst, of_tenths.worst, of_any.worst, of_wide.worst}) > 1e-4);  // the bound is not too loose
}

TEST_CASE("what two doubles leave is kept in the third", "[triple_double]") {
  const TripleDouble sum = (TripleDouble(1.) + TripleDouble(0x1p-60)) + TripleDouble(0x1p-120);
  CHECK(sum.hi == 1);
  CHECK(sum.lo == 0x1p-60);
  CHECK(sum.rest == 0x1p-120);
  const TripleDouble far = sum - TripleDouble(1.) - TripleDouble(0x1p-60);
  CHECK(in_two(far).hi == 0x1p-120);
  CHECK(quotient(far, sum) == 0x1p-120);
  const TripleDouble cube = TripleDouble(1 + 0x1p-40) * TripleDouble(1 + 0x1p-40) * TripleDouble(1 + 0x1p-40);
  CHECK(rational(cube) ==
        (Rational(1) + Rational(0x1p-40)) * (Rational(1) + Rational(0x1p-40)) * (Rational(1) + Rational(0x1p-40)));
}

TEST_CASE("quotients are within 0.51 ulp, however the three parts cancel", "[triple_double]") {
  bench::Random random(bench::stream(tests::seed(), "threefold quotient"));
  for (int i = 0; i < 20000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", numbers " << i);
    const auto number = [&]() -> TripleDouble {
      const double hi = random.one_in(3) ? 0 : random.magnitude(-20, 20);
      const double lo = random.one_in(3) ? -hi + 0x1p-50 * hi : random.magnitude(-20, 20) * 0x1p-53;
      return {hi, lo, random.magnitude(-20, 20) * 0x1p-106};
    };
    const TripleDouble x = number(), y = number();
    if (rational(y) == 0 || rational(x) == 0) continue;
    const Rational truth = rational(x) / rational(y);
    REQUIRE(abs(Rational(quotient(x, y)) - truth) <= abs(truth) * Rational(0x1p-53 + 0x1p-60));
  }
}

TEST_CASE("signs and quotient come together as they do alone", "[triple_double]") {
  bench::Random random(bench::stream(tests::seed(), "signs and value"));
  int zeros = 0, found = 0;
  for (int i = 0; i < 20000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", vectors " << i);
    const double scale = random.one_in(10) ? random.magnitude(-200, 200) : 1;
    const bool on_grid = random.one_in(2);
    const auto number = [&] { return on_grid ? random.integer(-30, 30) / 8. * scale : random.uniform(-3, 3); };
    std::array<double, 9> x;
    for (double& component : x) component = number();
    for (const int k : {3, 6})  // y and z nearly across n
      if (random.one_in(2)) x[k + 2] = -(x[0] * x[k] + x[1] * x[k + 1]) / x[2];
    const auto text = [&]<class W>() -> Ratio<W> {
      const auto times = [&](int k) -> W { return W(x[0]) * W(x[k]) + W(x[1]) * W(x[k + 1]) + W(x[2]) * W(x[k + 2]); };
      return {times(3), times(6)};
    };
    const bool finite = std::isfinite(x[5]) && std::isfinite(x[8]);
    if (!finite) continue;
    const auto both = signs_of<double>(text);
    const Ratio<Exact> truth = text.operator()<Exact>();
    REQUIRE(both.num == truth.num.sign());
    REQUIRE(both.den == truth.den.sign());
    REQUIRE(both.value.has_value() == (!small_code && both.den != 0));  // small code finds it by itself
    if (both.value) REQUIRE(*both.value == value_of<double>(text));
    zeros += both.num == 0, found += both.value.has_value();
  }
  CHECK(zeros > 100);
  CHECK((small_code || found > 10000));
}

}  // namespace triple_double_test
