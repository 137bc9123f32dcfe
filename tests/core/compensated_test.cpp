// The bound that isect/numbers/compensated.h derives, and the signs that predicates take from it, against rationals.

#include <isect/numbers/compensated.h>

#include <array>
#include <cmath>
#include <tuple>

#include <isect/numbers/predicate.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace compensated_test {
using namespace isect;
using oracle::Rational;

namespace {

/// A number tracked as predicates do it: with the size and the roundings of its double, and the grid.
struct Tracked {
  Bounded<double> quick;
  Compensated fine;
  Grid grid;
  Rational truth;
};

template <class Number>
Tracked leaf(const Number& number) {
  const double x = number(), y = number();
  return {Bounded<double>::difference(x, y), Compensated::difference(x, y), Grid::difference(x, y),
          Rational(x) - Rational(y)};
}

template <class Number>
Tracked expression(bench::Random& random, int depth, const Number& number) {
  if (depth == 0) {
    if (random.one_in(2)) return leaf(number);
    const double x = number();
    return {Bounded<double>(x), Compensated(x), Grid(x), Rational(x)};
  }
  const Tracked a = expression(random, depth - 1, number);
  const Tracked b = random.one_in(8) ? a : expression(random, random.below(depth), number);
  switch (random.below(5)) {
    case 0:
      return {a.quick + b.quick, a.fine + b.fine, a.grid + b.grid, a.truth + b.truth};
    case 1:
      return {a.quick - b.quick, a.fine - b.fine, a.grid - b.grid, a.truth - b.truth};
    case 2:
      return {-a.quick, -a.fine, -a.grid, -a.truth};
    case 3:
      return {abs(a.quick), abs(a.fine), abs(a.grid), abs(a.truth)};
    default:
      return {a.quick * b.quick, a.fine * b.fine, a.grid * b.grid, a.truth * b.truth};
  }
}

/// How many signs of `count` expressions were certain, and how many of those were 0.
template <class Number>
std::pair<int, int> certain(bench::Random& random, int count, const Number& number) {
  std::pair<int, int> result;
  for (int i = 0; i < count; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", expression " << i);
    const Tracked x = expression(random, 1 + random.below(4), number);
    const double size = x.quick.size();
    if (!(0x1p-800 < size && size < 0x1p900)) continue;
    const Bounded<Compensated> fine(x.fine, size, x.quick.roundings());
    REQUIRE(abs(Rational(x.fine.hi) + Rational(x.fine.lo) - x.truth) <= Rational(fine.error()));
    const std::optional<int> sign = detail::sign_on_grid(fine, x.grid.step());
    if (sign) REQUIRE(*sign == x.truth.sign());
    result.first += sign.has_value(), result.second += sign == 0;
  }
  return result;
}

}  // namespace

TEST_CASE("the error of a compensated expression stays within its bound", "[compensated]") {
  bench::Random random(bench::stream(tests::seed(), "compensated"));
  const auto close = [&] { return 1 + random.integer(-3, 3) * 0x1p-52; };  // all differences cancel
  const auto integer = [&] { return static_cast<double>(random.integer(-4, 4)); };
  const auto tenth = [&] { return random.integer(-30, 30) / 10.; };
  const auto any = [&] { return random.magnitude(-2, 2); };
  const auto wide = [&] { return random.one_in(8) ? 0. : random.magnitude(-60, 60); };
  const int count = 10000;
  const auto of_integers = certain(random, count, integer), of_tenths = certain(random, count, tenth);
  CHECK(of_integers.first > 9 * count / 10);
  CHECK(of_integers.second > count / 20);
  CHECK(of_tenths.first > 9 * count / 10);
  CHECK(of_tenths.second > 10);
  CHECK(certain(random, count, close).first > count / 2);
  CHECK(certain(random, count, any).first > 9 * count / 10);
  CHECK(certain(random, count, wide).first > count / 2);
}

TEST_CASE("what a sum, a difference or a product leaves is kept in full", "[compensated]") {
  const Compensated sum = Compensated(1.) + Compensated(0x1p-60), far = Compensated::difference(1, -0x1p-60);
  CHECK(sum.hi == 1);
  CHECK(sum.lo == 0x1p-60);
  CHECK(far.lo == 0x1p-60);
  const Compensated product = Compensated(1 + 0x1p-30) * Compensated(1 + 0x1p-30);
  CHECK(product.hi == 1 + 0x1p-29);
  CHECK(product.lo == 0x1p-60);
  CHECK((product - product).lo == 0);
  CHECK(quotient(sum + sum, sum) == 2);
  CHECK(quotient(sum - Compensated(1.), sum) == 0x1p-60);
}

TEST_CASE("quotients and square roots miss by less than a hundredth of an ulp before they are rounded",
          "[compensated]") {
  bench::Random random(bench::stream(tests::seed(), "quotient"));
  for (int i = 0; i < 20000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", numbers " << i);
    const auto number = [&]() -> Compensated {
      const double x = random.magnitude(-20, 20);
      return {x, x * random.uniform(-1, 1) * 0x1p-32};
    };
    const auto rational = [](const Compensated& t) -> Rational { return Rational(t.hi) + Rational(t.lo); };
    const Compensated x = number(), y = number();
    const Rational true_q = rational(x) / rational(y);
    REQUIRE(abs(Rational(quotient(x, y)) - true_q) <= abs(true_q) * Rational(0x1p-53 + 0x1p-60));
    const Compensated square = x.hi < 0 ? -x : x;
    const Rational root = rational(sqrt(square));  // |root^2 - x| is about twice the relative error
    REQUIRE(abs(root * root - rational(square)) <= rational(square) * Rational(0x1p-59));
  }
}

TEST_CASE("fused and split products give the same numbers, side by side as alone", "[compensated]") {
  bench::Random random(bench::stream(tests::seed(), "fused"));
  const auto [lo, hi] = GENERATE(std::tuple{-2., 2.}, std::tuple{-100., 100.});
  for (int i = 0; i < 20000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", vectors " << i);
    std::array<double, 15> x;
    for (double& component : x) component = random.magnitude(lo, hi);
    const auto vector = [&]<bool fused>(int from) -> std::array<CompensatedBy<fused>, 3> {
      return {CompensatedBy<fused>(x[from], x[from] * 0x1p-54), CompensatedBy<fused>(x[from + 1]),
              CompensatedBy<fused>::difference(x[from + 2], x[from + 3])};
    };
    const Vector<double, 3> leaf(x[12], x[13], x[14]);
    const auto all = [&]<bool fused>() -> std::array<double, 8> {
      using V = std::array<CompensatedBy<fused>, 3>;
      const V n = vector.template operator()<fused>(0), u = vector.template operator()<fused>(4),
              v = vector.template operator()<fused>(8);
      const auto both = two_dots<fused, 3>(n, u, v), with_leaf = two_dots<fused, 3>(leaf, u, leaf);
      return {both.x.hi,      both.x.lo,      both.y.hi,      both.y.lo,
              with_leaf.x.hi, with_leaf.x.lo, with_leaf.y.hi, with_leaf.y.lo};
    };
    const std::array<double, 8> split = all.operator()<false>(), fused = all.operator()<true>();
    REQUIRE(split == fused);

    const auto n = vector.operator()<true>(0), u = vector.operator()<true>(4), v = vector.operator()<true>(8);
    const Fused alone[] = {dot(n, u), dot(n, v), dot(exactly<Fused>(leaf), u),
                           dot(exactly<Fused>(leaf), exactly<Fused>(leaf))};
    for (int k = 0; k < 4; ++k) {
      REQUIRE(fused[2 * k] == alone[k].hi);
      REQUIRE(fused[2 * k + 1] == alone[k].lo);
    }
    const auto rational = [](const Fused& t) -> Rational { return Rational(t.hi) + Rational(t.lo); };
    Rational nu = 0, nv = 0, size_u = 0, size_v = 0;
    for (int k = 0; k < 3; ++k) {
      nu += rational(n[k]) * rational(u[k]), size_u += abs(rational(n[k]) * rational(u[k]));
      nv += rational(n[k]) * rational(v[k]), size_v += abs(rational(n[k]) * rational(v[k]));
    }
    const Rational bound = 2 * 16 * Rational(0x1p-106);  // 2 k^2 u^2 of the size, for k = 4
    REQUIRE(abs(Rational(fused[0]) + Rational(fused[1]) - nu) <= bound * size_u);
    REQUIRE(abs(Rational(fused[2]) + Rational(fused[3]) - nv) <= bound * size_v);
  }
}

TEST_CASE("long sums stay within the bound", "[compensated]") {
  bench::Random random(bench::stream(tests::seed(), "long"));
  Bounded<double> quick(0.);
  Compensated fine(0.);
  Rational truth = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.magnitude(-3, 3), y = random.magnitude(-3, 3);
    quick = quick + Bounded<double>(x) * Bounded<double>(y), fine = fine + Compensated(x) * Compensated(y);
    truth += Rational(x) * Rational(y);
  }
  const Bounded<Compensated> all(fine, quick.size(), quick.roundings());
  CHECK(abs(Rational(fine.hi) + Rational(fine.lo) - truth) <= Rational(all.error()));
  CHECK(all.error() < quick.error());
}

}  // namespace compensated_test
