#include <isect/line_line.h>

#include <random>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace line_line_test {
using namespace isect;
using line_line::Meeting;
using tests::inf, tests::not_a_number;

namespace {

using Vec = Vector<double, 3>;
using oracle::operator*, oracle::operator+, oracle::operator-;
using Straight = Ray<double, 3>;
using oracle::Rational;

/// Whether o + t d lies on b, by solving for one coordinate.
bool on(const oracle::Coordinates<3>& x, const Straight& b) {
  const auto o = oracle::rational(b.origin), d = oracle::rational(b.direction);
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0) continue;
    const Rational s = (x[i] - o[i]) / d[i];
    if (std::isfinite(b.range.lo) && s < Rational(b.range.lo)) return false;
    if (std::isfinite(b.range.hi) && s > Rational(b.range.hi)) return false;
    return o + s * d == x;
  }
  return o == x;
}

/// The t of a where the whole lines meet, from two of the three equations; nothing if they have no single solution.
std::optional<Rational> t_of(const Straight& a, const Straight& b) {
  const auto o = oracle::rational(a.origin), u = oracle::rational(a.direction), p = oracle::rational(b.origin),
             v = oracle::rational(b.direction);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Rational determinant = u[j] * v[i] - u[i] * v[j];
    if (determinant == 0) continue;
    return ((p[j] - o[j]) * v[i] - (p[i] - o[i]) * v[j]) / determinant;
  }
  return {};
}

}  // namespace

TEST_CASE("two lines in space have in common what solving their equations gives", "[line_line]") {
  std::mt19937_64 random(tests::seed());
  const auto whole = [&](int lo, int hi) -> double { return std::uniform_int_distribution<int>(lo, hi)(random); };
  const auto vector = [&](int k) -> Vec { return {whole(-k, k), whole(-k, k), whole(-k, k)}; };
  std::array<int, 5> seen = {};
  for (int round = 0; round < tests::cases(20000, 400000); ++round) {
    const auto any = [&] {
      Straight x = {vector(2), vector(2), {0, 1}};
      if (round % 3 == 1) x.range = semi_infinite<double>;
      if (round % 3 == 2) x.range = infinite<double>;
      return x;
    };
    Straight a = any(), b = any();
    if (round % 4 == 0) b.direction = whole(-2, 2) * a.direction;
    if (round % 8 == 0) b.origin = a.origin + whole(-2, 2) * a.direction;
    const line_line::Result found = intersect(a, b);
    CAPTURE(round);
    ++seen[static_cast<std::size_t>(found.meeting)];
    const auto at = [&](const Rational& t) { return oracle::rational(a.origin) + t * oracle::rational(a.direction); };
    const auto in_range = [&](const Rational& t) {
      return !(std::isfinite(a.range.lo) && t < Rational(a.range.lo)) &&
             !(std::isfinite(a.range.hi) && t > Rational(a.range.hi));
    };
    if (const auto t = t_of(a, b)) {
      const bool truth = in_range(*t) && on(at(*t), b);
      REQUIRE(found.meets() == truth);
      if (!truth) continue;
      REQUIRE(found.meeting == Meeting::point);
      REQUIRE(*found.t == t->convert_to<double>());
      continue;
    }
    // Parallel, or one is a point: they meet iff some end of one lies on the other, or both are whole lines
    bool truth = false;
    for (const double t : {a.range.lo, a.range.hi, 0.0})
      if (std::isfinite(t)) truth |= in_range(t) && on(at(Rational(t)), b);
    for (const double s : {b.range.lo, b.range.hi, 0.0})
      if (std::isfinite(s) && b.range.contains(s))
        truth |= on(oracle::rational(b.origin) + Rational(s) * oracle::rational(b.direction), a);
    REQUIRE(found.meets() == truth);
    if (found.t) REQUIRE(on(at(Rational(*found.t)), b));
  }
  for (const int count : seen) CHECK(count > 20);
}

TEST_CASE("an ulp makes lines skew, and a segment end too early", "[line_line]") {
  const Straight x = {{0, 0, 0}, {1, 0, 0}, infinite<double>};
  CHECK(intersect(x, Straight{{3, -1, 0}, {0, 1, 0}}).meeting == Meeting::point);
  CHECK(intersect(x, Straight{{3, -1, 1e-300}, {0, 1, 0}}).meeting == Meeting::skew);
  CHECK(intersect(x, Straight{{3, -1, 0}, {0, 1, 0}, {0, std::nextafter(1, 0)}}).meeting == Meeting::apart);
  CHECK(intersect(x, Straight{{3, 1, 0}, {2, 0, 0}}).meeting == Meeting::parallel);
  CHECK(*intersect(x, Straight{{3, -1, 0}, {0, 1, 0}}).t == 3);
}

TEST_CASE("segments keep both ends, and stretches begin where both do", "[line_line]") {
  const Segment<double, 3> a = {{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}};
  const auto touch = intersect(a, Segment<double, 3>{{0.7, 0.7, 0.7}, {5, 0, 0}});
  CHECK(touch.meeting == Meeting::point);
  CHECK(*touch.t == 1);
  CHECK(intersect(a, Segment<double, 3>{{0.7, 0.7, 0.7}, {0.9, 0.9, 0.9}}).meeting == Meeting::point);
  CHECK(intersect(a, Segment<double, 3>{{std::nextafter(0.7, 1), 0.7, 0.7}, {0.9, 0.9, 0.9}}).meeting !=
        Meeting::point);
  const auto shared = intersect(a, Segment<double, 3>{{9, 9, 9}, {0.5, 0.5, 0.5}});
  CHECK(shared.meeting == Meeting::stretch);
  CHECK(std::abs(*shared.t - 2.0 / 3) < 1e-15);
  const Straight line = {{0, 0, 0}, {1, 2, 3}, infinite<double>};
  CHECK(intersect(line, line).meeting == Meeting::stretch);
  CHECK_FALSE(intersect(line, line).t);
  CHECK(intersect(a, a).meeting == Meeting::stretch);
  CHECK(*intersect(a, a).t == 0);
}

TEST_CASE("what has no points meets no line", "[line_line]") {
  const Straight x = {{0, 0, 0}, {1, 0, 0}, infinite<double>};
  CHECK(intersect(x, Straight{{0, 0, 0}, {0, 1, 0}, {1, 0}}).meeting == Meeting::apart);
  for (const double bad : {not_a_number, inf})
    CHECK(intersect(x, Straight{{0, bad, 0}, {0, 1, 0}}).meeting == Meeting::apart);
  CHECK(intersect(x, Straight{{0, 0, 0}, {0, 1, 0}, {not_a_number, 1}}).meeting == Meeting::apart);
}

}  // namespace line_line_test
