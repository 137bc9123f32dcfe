// The bound of isect/numbers/bounded.h and the signs of isect/numbers/predicate.h against rational arithmetic.

#include <algorithm>
#include <limits>
#include <tuple>

#include <isect/numbers/quotient.h>
#include <isect/orient.h>
#include <isect/parts/three_quotients.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace bounded_test {
using namespace isect;
using oracle::Rational;

namespace {

/// A number computed three ways at once.
template <class T>
struct Tracked {
  Bounded<T> bounded;
  Exact exact;
  Rational truth;
};

Rational rational(double x) { return Rational(x); }
Rational rational(const DoubleDouble& x) { return Rational(x.hi) + Rational(x.lo); }

template <class T>
Tracked<T> leaf(bench::Random& random, double lo, double hi) {
  // halves of the numbers are short: sums of them cancel exactly
  const double x = random.one_in(2) ? random.integer(-4, 4) : random.magnitude(lo, hi);
  const double y = random.one_in(2) ? x * (1 + random.integer(-2, 2) * 0x1p-52) : random.magnitude(lo, hi);
  if (random.one_in(2)) return {Bounded<T>::difference(x, y), Exact(x) - Exact(y), Rational(x) - Rational(y)};
  return {Bounded<T>(x), Exact(x), Rational(x)};
}

template <class T>
Tracked<T> expression(bench::Random& random, int depth, double lo, double hi) {
  if (depth == 0) return leaf<T>(random, lo, hi);
  const Tracked<T> a = expression<T>(random, depth - 1, lo, hi);
  const Tracked<T> b = random.one_in(8) ? a : expression<T>(random, random.below(depth), lo, hi);
  switch (random.below(5)) {
    case 0:
      return {a.bounded + b.bounded, a.exact + b.exact, a.truth + b.truth};
    case 1:
      return {a.bounded - b.bounded, a.exact - b.exact, a.truth - b.truth};
    case 2:
      return {-a.bounded, -a.exact, -a.truth};
    case 3:
      return {abs(a.bounded), abs(a.exact), abs(a.truth)};
    default:
      return {a.bounded * b.bounded, a.exact * b.exact, a.truth * b.truth};
  }
}

}  // namespace

TEMPLATE_TEST_CASE("the error of a random expression stays within its bound", "[bounded]", double, DoubleDouble) {
  bench::Random random(tests::seed());
  const auto [lo, hi] = GENERATE(std::tuple{-2., 2.}, std::tuple{-300., 300.}, std::tuple{-308., -150.});
  int certain = 0, zero = 0;
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    const Tracked<TestType> x = expression<TestType>(random, 1 + random.below(4), lo, hi);
    INFO("seed " << tests::seed() << ", expression " << i);
    REQUIRE(x.exact.sign() == sign(x.truth));

    const auto s = x.bounded.sign();
    if (s) REQUIRE(*s == sign(x.truth));
    certain += s.has_value();
    zero += s == 0;
    const double error = x.bounded.error();
    if (std::isfinite(error) && std::isfinite(leading(x.bounded.value())))
      REQUIRE(abs(rational(x.bounded.value()) - x.truth) <= Rational(error) + Rational(5e-324));
  }
  CHECK(certain > count / 3);  // the test means something: most signs are certain, some are not
  CHECK(certain < count);
  CHECK(zero > 0);
}

namespace {

struct TrackedVector {
  std::array<Bounded<double>, 3> bounded;
  oracle::Coordinates<3> truth;
};
TrackedVector vector(bench::Random& random, double lo, double hi) {
  TrackedVector v;
  for (int i = 0; i < 3; ++i) {
    const Tracked<double> x = leaf<double>(random, lo, hi);
    v.bounded[i] = x.bounded, v.truth[i] = x.truth;
  }
  return v;
}

/// Checks the bound and the sign; returns whether the sign was certain.
bool stays_within_its_bound(const Bounded<double>& x, const Rational& truth) {
  if (std::isfinite(x.error()) && std::isfinite(x.value()))
    REQUIRE(abs(Rational(x.value()) - truth) <= Rational(x.error()) + Rational(5e-324));
  if (x.sign()) REQUIRE(*x.sign() == sign(truth));
  return x.sign().has_value();
}

}  // namespace

TEST_CASE("products of vectors stay within the bound of their largest sizes", "[bounded]") {
  bench::Random random(tests::seed());
  const auto [lo, hi] =
      GENERATE(std::tuple{-2., 2.}, std::tuple{-1., 1.}, std::tuple{-300., 300.}, std::tuple{-308., -100.});
  int certain = 0;
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    INFO("seed " << tests::seed() << ", vectors " << i);
    const TrackedVector a = vector(random, lo, hi), b = vector(random, lo, hi),
                        c = random.one_in(3) ? a : vector(random, lo, hi);
    certain += stays_within_its_bound(dot(a.bounded, b.bounded), oracle::dot(a.truth, b.truth));
    const auto n = cross(a.bounded, b.bounded);
    const auto truth = oracle::cross(a.truth, b.truth);
    for (int k = 0; k < 3; ++k) stays_within_its_bound(n[k], truth[k]);
    stays_within_its_bound(dot(n, c.bounded), oracle::dot(truth, c.truth));
  }
  CHECK(certain > count / 4);
  CHECK(certain < count);
}

TEST_CASE("sums of the least doubles are certain, where error bounds underflow", "[bounded]") {
  const Bounded<double> least(5e-324), two(1e-323);
  CHECK((least + least - two).sign() == 0);
  CHECK((least + two - least).sign() == 1);
  CHECK((least - two).sign() == -1);
}

TEST_CASE("an algorithm whose signs doubles leave open runs again, and only then", "[predicate]") {
  const double beyond = 1 + 0x1p-52, below = 1 - 0x1p-52;
  for (const double x : {beyond, 2.}) {
    int runs = 0;
    NoTrace silent;
    const auto algorithm = [&](auto& pass) {
      ++runs;
      return sign_of([&]<class W>() -> W { return W(x) * W(below) - W(1); }, pass);
    };
    CHECK(in_doubles_first(algorithm, silent) == (x == 2 ? 1 : -1));
    CHECK(runs == (small_code || x == 2 ? 1 : 2));
    Record<std::variant<Fallback>> record;
    runs = 0;
    CHECK(in_doubles_first(algorithm, record) == (x == 2 ? 1 : -1));
    CHECK(runs == 1);
    CHECK(record.events.size() == (x == 2 ? 0 : 1));
  }
}

TEST_CASE("a value that doubles can't tell is found all the same", "[predicate]") {
  const auto text = []<class W>() -> Ratio<W> { return {W(1 + 0x1p-52) * W(1 - 0x1p-52) - W(1), W(1)}; };
  NoTrace silent;
  const auto value = [&]<class S>(S) {
    return in_doubles_first([&](auto& pass) { return value_of<S>(text, pass); }, silent);
  };
  CHECK(value(0.) == -0x1p-104);
  CHECK(value(0.f) == -0x1p-104f);
}

TEST_CASE("nothing is certain of infinities and NaN", "[bounded]") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(Bounded<double>(nan).sign());
  CHECK_FALSE(Bounded<double>(inf).sign());
  CHECK_FALSE((Bounded<double>(1e200) * Bounded<double>(1e200)).sign());
  CHECK_FALSE((Bounded<double>(inf) * Bounded<double>(0)).sign());
  CHECK_FALSE(Bounded<double>::difference(inf, 1).sign());
  for (const double bad : {inf, -inf, nan})
    for (int i = 0; i < 3; ++i) {
      std::array<Bounded<double>, 3> x = {1., 2., 3.}, y = {3., 2., 1.};
      x[i] = bad;
      CHECK_FALSE(dot(x, y).sign());
      CHECK_FALSE(dot(y, x).sign());
      CHECK_FALSE(dot(cross(x, y), y).sign());
    }
}

TEST_CASE("a size that overflowed and was multiplied by 0 hides no error beside it", "[bounded]") {
  // (1 - 2^-60) - 1 + 2^-70 is less than 0, and 2^-70 in doubles; before it stands 0, of whose size nothing is known
  const auto text = []<class W>() -> W {
    const W overflown = (W(1e308) - W(1e308) + W(1)) * W(0);
    return overflown + W(1 + 0x1p-30) * W(1 - 0x1p-30) - W(1) + W(0x1p-70);
  };
  CHECK(sign_of(text) == -1);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vector = [&]<class W>() -> Components<W, 3> {
      Components<W, 3> x = {W(0), W(0), W(0)};
      x[i] = text.template operator()<W>();
      return x;
    };
    const auto ones = []<class W>() -> Components<W, 3> { return {W(1), W(1), W(1)}; };
    const auto in_dot = [&]<class W>() -> W {
      return dot(vector.template operator()<W>(), ones.template operator()<W>());
    };
    const auto in_cross = [&]<class W>() -> W {
      return cross(vector.template operator()<W>(), ones.template operator()<W>())[(i + 2) % 3];
    };
    INFO(i);
    CHECK(sign_of(in_dot) == -1);
    CHECK(sign_of<long_text>(in_dot) == -1);
    CHECK(sign_of(in_cross) == -1);
  }
}

TEST_CASE("differences of doubles have certain signs, equal ones too", "[bounded]") {
  CHECK(Bounded<double>::difference(.3, .1 + .2).sign() == -1);
  CHECK(Bounded<double>::difference(5e-324, 0).sign() == 1);
  CHECK(Bounded<double>::difference(.7, .7).sign() == 0);
}

TEST_CASE("a sign within its bound falls back, and says so", "[predicate]") {
  // the cross terms cancel to 2^-104, which no double product shows
  const auto text = []<class W>() -> W { return W(1 + 0x1p-52) * W(1 - 0x1p-52) - W(1); };
  Record<std::variant<Fallback>> record;
  CHECK(sign_of(text, record) == -1);
  CHECK(record.events.size() == 1);
  CHECK(sign_of([]<class W>() -> W { return W(2) * W(3) - W(5); }, record) == 1);
  CHECK(record.events.size() == 1);
}

TEMPLATE_TEST_CASE("a quotient lies within 2 ulp of the truth", "[predicate]", float, double) {
  bench::Random random(tests::seed());
  const double top = std::is_same_v<TestType, float> ? 18 : 150;
  int fallbacks = 0;
  for (int i = 0; i < 20000; ++i) {
    INFO("seed " << tests::seed() << ", quotient " << i);
    const auto number = [&] { return static_cast<double>(static_cast<TestType>(random.magnitude(-top, top))); };
    const double a = number(), b = number(), c = random.one_in(3) ? number() : 0;
    double d = random.one_in(2) ? number() : (a - c) / a * b;  // the numerator cancels
    d = static_cast<double>(static_cast<TestType>(d));
    if (!std::isfinite(d) || d == 0) continue;
    const auto text = [&]<class W>() -> Ratio<W> { return {difference<W>(a, c) * W(b) - W(a) * W(d), W(d)}; };
    Record<std::variant<Fallback>> record;
    const TestType t = value_of<TestType>(text, record);
    fallbacks += static_cast<int>(record.events.size());
    const Rational truth = ((Rational(a) - Rational(c)) * Rational(b) - Rational(a) * Rational(d)) / Rational(d);
    REQUIRE(oracle::ulps(t, truth) <= 2);
    REQUIRE(value_of<TestType>(text) == t);
  }
  CHECK(fallbacks > 0);
}

TEMPLATE_TEST_CASE("three quotients at once lie within 2 ulp of the truth, however many bits they need", "[predicate]",
                   float, double) {
  bench::Random random(tests::seed());
  const double top = std::is_same_v<TestType, float> ? 12 : 100;
  for (int i = 0; i < 5000; ++i) {
    INFO("seed " << tests::seed() << ", quotients " << i);
    const double power = random.one_in(3) ? top : random.one_in(2) ? 15 : 2;
    std::array<double, 3> x, y;
    for (double& c : x) c = random.magnitude(-power, power);
    y = x;
    y[random.below(3)] = bench::moved(y[0], random.integer(-2, 2));
    const double d = random.magnitude(-power, power);
    const auto minor = [&]<class W>(int j, int k) -> W { return W(x[j]) * W(y[k]) - W(x[k]) * W(y[j]); };  // cancels
    const auto all = [&]<class W>() -> ThreeRatios<W> {
      return {minor.template operator()<W>(0, 1), minor.template operator()<W>(1, 2) * W(x[0]),
              minor.template operator()<W>(2, 0), W(d) * W(d)};
    };
    const std::array<bool, 3> zero = {false, false, random.one_in(4)};
    const std::array<TestType, 3> found = values_of<TestType>(all, zero);
    REQUIRE(found[0] == value_of<TestType>([&]<class W>() -> Ratio<W> {  // the same bits as alone
              const ThreeRatios<W> r = all.template operator()<W>();
              return {r.x, r.den};
            }));
    const auto truth = [&](int j, int k) -> Rational {
      return Rational(Rational(x[j]) * Rational(y[k]) - Rational(x[k]) * Rational(y[j]));
    };
    const Rational den = Rational(d) * Rational(d);
    REQUIRE(oracle::ulps(found[0], Rational(truth(0, 1) / den)) <= 2);
    REQUIRE(oracle::ulps(found[1], Rational(truth(1, 2) * Rational(x[0]) / den)) <= 2);
    if (zero[2])
      REQUIRE(found[2] == 0);
    else
      REQUIRE(oracle::ulps(found[2], Rational(truth(2, 0) / den)) <= 2);
  }
}

TEST_CASE("a quotient of numbers beyond the doubles is right all the same", "[predicate]") {
  // both sizes are infinite, so that nothing is known: the numerator cancels, and the denominator might
  const auto text = []<class W>() -> Ratio<W> {
    const W x = W(1.1e200) * W(1.3e200);
    return {x * W(1 + 0x1p-52) - x * W(1), x};
  };
  CHECK(value_of<double>(text) == 0x1p-52);
  CHECK(value_of<float>(text) == 0x1p-52f);
}

TEST_CASE("a quotient near the largest double has the same bits with fused products and without", "[predicate]") {
  bench::Random random(tests::seed());
  int huge = 0;
  for (int i = 0; i < 4000; ++i) {
    const int exponent = random.integer(980, 1022), of_den = random.integer(-520, -480);
    const auto whole = [&](int e) { return std::ldexp(random.uniform(1, 2), e); };
    const double den = whole(of_den), num = whole(exponent + of_den), rest = whole(exponent + of_den - 54);
    const auto text = [&]<class W>() -> Ratio<W> { return {W(num) + W(rest), W(den)}; };
    const std::optional<double> with = detail::fine_quotient<CompensatedBy<true>>(text),
                                without = detail::fine_quotient<CompensatedBy<false>>(text);
    CAPTURE(exponent, num, rest, den);
    REQUIRE(with.has_value() == without.has_value());
    if (with) REQUIRE(*with == *without);
    const double t = value_of<double>(text);
    if (with) REQUIRE(*with == t);
    REQUIRE(std::abs(t - num / den) <= 0x1p-52 * t);
    huge += !with;
  }
  CHECK(huge > 1000);
}

TEST_CASE("orientations on Kettner's grids are those of rational arithmetic", "[orient]") {
  const auto truth = [](const auto& a, const auto& b, const auto& c) {
    const auto p = oracle::rational(a), q = oracle::rational(b), r = oracle::rational(c);
    return sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  };
  using Point2 = Point<double, 2>;
  const auto [corner, b, c] =
      GENERATE(table<Point2, Point2, Point2>({{{.5, .5}, {12, 12}, {24, 24}},
                                              {{.50000000000002531, .5000000000000171},
                                               {17.300000000000001, 17.300000000000001},
                                               {24.00000000000005, 24.0000000000000517765}},
                                              {{.5, .5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}}}));
  int signs[3] = {};
  for (int i = 0; i < 128; ++i)
    for (int j = 0; j < 128; ++j) {
      const Point2 a = {corner[0] + i * 0x1p-53, corner[1] + j * 0x1p-53};
      const int s = orient2d(a, b, c);
      REQUIRE(s == truth(a, b, c));
      ++signs[s + 1];
    }
  CHECK(std::min(signs[0], signs[2]) > 0);
}

TEST_CASE("orient3d is +1 below a counter-clockwise triangle", "[orient]") {
  const Point<double, 3> a = {0, 0, 0}, b = {1, 0, 0}, c = {0, 1, 0};
  CHECK(orient3d(a, b, c, {0.2, 0.2, -1e-300}) == 1);
  CHECK(orient3d(a, b, c, {0.2, 0.2, 5e-324}) == -1);
  CHECK(orient3d(a, b, c, {7, -3, 0}) == 0);
}

}  // namespace bounded_test
