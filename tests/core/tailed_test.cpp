// The bounds that isect/numbers/tailed.h derives, against rationals, and values by it, the same on every machine.

#include <isect/numbers/tailed.h>

#include <cmath>
#include <tuple>

#include <isect/numbers/predicate.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace tailed_test {
using namespace isect;
using oracle::Rational;

namespace {

/// As values use it: by the sizes and the roundings that doubles found.
template <std::size_t N>
struct Tracked {
  std::array<Bounded<double>, N> quick;
  std::array<Tailed, N> fine;
  std::array<Rational, N> truth;
};

template <std::size_t N>
Tracked<N> vector(bench::Random& random, double lo, double hi) {
  const auto number = [&] { return random.one_in(6) ? random.integer(-2, 2) : random.magnitude(lo, hi); };
  Tracked<N> v;
  for (std::size_t i = 0; i < N; ++i) {
    const double x = number(), y = random.one_in(2) ? x * (1 + random.integer(-2, 2) * 0x1p-52) : number();
    if (random.one_in(3))
      v.quick[i] = x, v.fine[i] = x, v.truth[i] = x;
    else
      v.quick[i] = Bounded<double>::difference(x, y), v.fine[i] = Tailed::difference(x, y),
      v.truth[i] = Rational(x) - Rational(y);
  }
  return v;
}

/// The error over its bound, which must be at most 1.
double share(const Bounded<double>& quick, const Tailed& fine, const Rational& truth) {
  const double bound = Bounded<Tailed>(fine, quick.size(), quick.roundings()).error();
  if (!std::isfinite(bound) || !std::isfinite(fine.hi + fine.lo)) return 0;
  const Rational error = abs(Rational(fine.hi) + Rational(fine.lo) - truth);
  REQUIRE(error <= Rational(bound));
  return bound == 0 ? 0 : static_cast<double>(Rational(error / Rational(bound)));
}

template <std::size_t N>
double largest_share_of_dots(bench::Random& random, double lo, double hi) {
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", vectors " << i);
    const Tracked<N> a = vector<N>(random, lo, hi), b = vector<N>(random, lo, hi);
    Rational truth = 0;
    for (std::size_t k = 0; k < N; ++k) truth += a.truth[k] * b.truth[k];
    worst = std::max(worst, share(dot(a.quick, b.quick), dot(a.fine, b.fine), truth));
  }
  return worst;
}

}  // namespace

TEST_CASE("products of vectors with tails stay within their bound", "[tailed]") {
  bench::Random random(bench::stream(tests::seed(), "tailed"));
  const auto [lo, hi] = GENERATE(std::tuple{-1., 1.}, std::tuple{-8., 8.}, std::tuple{-308., -100.},
                                 std::tuple{-323., 100.}, std::tuple{100., 308.});
  const double dots = largest_share_of_dots<2>(random, lo, hi) + largest_share_of_dots<3>(random, lo, hi);
  if (lo == -1) CHECK(dots > 0x1p-12);  // the bound is no idle one
  for (int i = 0; i < 4000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", vectors " << i);
    const Tracked<3> a = vector<3>(random, lo, hi), b = vector<3>(random, lo, hi), c = vector<3>(random, lo, hi);
    const auto quick = cross(a.quick, b.quick);
    const auto fine = cross(a.fine, b.fine);
    const auto truth = oracle::cross(oracle::Coordinates<3>(a.truth), oracle::Coordinates<3>(b.truth));
    Rational volume = 0;
    for (int k = 0; k < 3; ++k) share(quick[k], fine[k], truth[k]), volume += truth[k] * c.truth[k];
    share(dot(quick, c.quick), dot(fine, c.fine), volume);
  }
}

TEST_CASE("quotients and square roots miss by less than an eighth of an ulp before they are rounded", "[tailed]") {
  bench::Random random(bench::stream(tests::seed(), "quotient"));
  for (int i = 0; i < 20000; ++i) {
    INFO("ISECT_SEED=" << tests::seed() << ", numbers " << i);
    const auto number = [&]() -> Tailed {
      const double x = random.magnitude(-20, 20);
      return {x, x * random.uniform(-1, 1) * 0x1p-7};
    };
    const Tailed x = number(), y = number();
    const auto rational = [](const Tailed& t) -> Rational { return Rational(t.hi) + Rational(t.lo); };
    const double q = quotient(x, y);
    const Rational true_q = rational(x) / rational(y);
    REQUIRE(abs(Rational(q) - true_q) <= abs(true_q) * Rational(0x1p-53 + 0x1p-56));
    const Tailed square = x.hi < 0 ? -x : x, root = sqrt(square);
    const Rational r = rational(root);  // |r^2 - x| is about twice the relative error
    REQUIRE(abs(r * r - rational(square)) <= rational(square) * Rational(0x1p-55));
  }
}

TEST_CASE("what overflows, or can't be divided, is no number", "[tailed]") {
  const Tailed large(1e300), x = large * large;
  CHECK_FALSE(std::isfinite(x.hi + x.lo));
  CHECK_FALSE(std::isfinite(quotient(Tailed(1.), Tailed(0.))));
  const std::array<Tailed, 3> far = {1e300, 1., 2.};
  const Tailed d = dot(far, far);
  CHECK_FALSE(std::isfinite(d.hi + d.lo));
}

}  // namespace tailed_test
