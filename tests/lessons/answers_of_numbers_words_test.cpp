// What readers could not answer from the lessons' texts alone, and now can: each sentence about numbers, rays and rules
// is computed here.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include <isect/orient.h>
#include <Eigen/Geometry>
#include "bench/random.h"
#include "bench/rational.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace answers_of_numbers_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using oracle::Rational;

TEST_CASE("a quotient by a product that only rounding keeps from 0 is large and of either sign", "[words]") {
  CHECK(solved_with("ray-polygon", "may have any size and either sign, though the line is parallel to the plane"));
  bench::Random random = random_of("parallel");
  int plus = 0, minus = 0;
  for (int k = 0; k < 500; ++k) {
    const double a = 1 + std::ldexp(random.integer(1, 1 << 28), -30), e = std::ldexp(random.integer(1, 1 << 28), -30);
    const Vec3 n(a, a - e, e), d(a, -(a + e), -e);  // a² − (a² − e²) − e²
    REQUIRE(oracle::dot(oracle::rational<double, 3>(n), oracle::rational<double, 3>(d)) == 0);
    const double rounded = n.dot(d);
    if (rounded == 0) continue;
    const double t = n.dot(n) / rounded;
    CHECK(std::abs(t) > 1e10);
    plus += t > 0, minus += t < 0;
  }
  CHECK((plus > 0 && minus > 0));
}

TEST_CASE("planes found from a matrix have normals of other lengths, which a radius must not meet", "[words]") {
  CHECK(solved_with("culling", "divide a plane by that length before a radius is compared"));
  const double focus = 1 / std::tan(std::numbers::pi / 6);
  const Vec3 left(focus, 0, -1);  // row 4 + row 1 of a square view of 60°
  CHECK(left.norm() == Approx(2));
  const Vec3 n(0, 3, 4), c(0, 0, 1);
  const double height = n.dot(c) - 10, radius = 2;
  CHECK((height < -radius && height / n.norm() > -radius));
}

TEST_CASE("rays that branch are counted from depth 0, or by levels", "[words]") {
  CHECK(solved_with("ray-tracing", "1 + 2 + 4 + 8 = 15 if all hit, as the primary ray has depth 0."));
  CHECK(solved_with("ray-tracing", "Of three levels, the primary ray being the first, there are 1 + 2 + 4 = 7."));
  const auto rays = [](const auto& self, int deeper) -> int {
    return 1 + (deeper > 0 ? 2 * self(self, deeper - 1) : 0);
  };
  CHECK(rays(rays, 3) == 15);
  CHECK(rays(rays, 2) == 7);
}

TEST_CASE("five pixels at a depth of 50 are as long as is told, and rows counted from the top are mirrored",
          "[words]") {
  CHECK(solved_with("picking", "50 · tan 30° = 28.87, and 540 pixels. So a pixel is 0.0535, and five are 0.267."));
  const double half = 50 * std::tan(std::numbers::pi / 6);
  CHECK(half == Approx(28.87).margin(0.005));
  CHECK(half / 540 == Approx(0.0535).margin(0.00005));
  CHECK(5 * half / 540 == Approx(0.267).margin(0.0005));

  CHECK(solved_with("picking", "as far on the other side of the middle row"));
  for (int row = 0; row < 1080; ++row) {
    const double up = 540 - (row + 0.5), unchanged = row + 0.5 - 540;
    CHECK(unchanged == -up);
    CHECK(up == 1079 - row + 0.5 - 540);
  }
}

TEST_CASE("the eight rules stand in one place, in order, by the names of their presets' methods", "[words]") {
  const std::vector<Preset>& all = lesson("rules-of-thumb").presets;
  CHECK(all.size() == 8);
  std::string list;
  for (const Exercise& e : lesson("rules-of-thumb").closing->exercises)
    if (says(e.solution, "The rules: 1 ")) list = plain(e.solution);
  std::size_t at = 0;
  for (const Preset& p : all) {
    std::string rule = walk_of("rules-of-thumb", p.id).method;  // "2: reuse results"
    REQUIRE(rule.find(':') == 1);
    rule.erase(1, 1);
    INFO(rule);
    CHECK(list.find(rule) != std::string::npos);
    CHECK(list.find(rule) > at);
    at = list.find(rule);
  }
}

TEST_CASE("the numbers of two tests in either order, and of a test that just pays, are as told", "[words]") {
  CHECK(solved_with("rules-of-thumb", "B goes first: 5 + 0.2 · 2 = 5.4, not 2 + 0.8 · 5 = 6"));
  CHECK(5 + (1 - 0.8) * 2 == Approx(5.4));
  CHECK(2 + (1 - 0.2) * 5 == Approx(6));
  CHECK(solved_with("rules-of-thumb", "It pays if more than 11/150, about 7 %, are rejected."));
  for (const double rejected : {0.07, 0.0733, 0.0734, 0.08, 0.9})
    CHECK((11 + (1 - rejected) * 150 < 150) == (rejected > 11.0 / 150));
  CHECK(told("rules-of-thumb", "A square root or a division takes as long as several products."));
}

TEST_CASE("with two tolerances a contact that moves less than their difference changes once at most", "[words]") {
  CHECK(solved_with("robustness", "a contact begins within the smaller one, and ends beyond the larger"));
  bench::Random random = random_of("hysteresis");
  const double smaller = 1, larger = 2;
  int single_most = 0;
  for (int k = 0; k < 200; ++k) {
    const double from = random.uniform(0, 3);
    bool contact = random.one_in(2), near = contact;
    int changes = 0, single = 0;
    for (int frame = 0; frame < 100; ++frame) {
      const double distance = from + random.uniform(0, 0.9 * (larger - smaller));
      const bool now = contact ? distance <= larger : distance <= smaller;
      changes += now != contact, contact = now;
      single += (distance <= smaller) != near, near = distance <= smaller;
    }
    CHECK(changes <= 1);
    single_most = std::max(single_most, single);
  }
  CHECK(single_most > 30);
  CHECK(told("robustness", "One tolerance only moves the band, or widens it."));
}

TEST_CASE("what floats have lost stays lost in doubles", "[words]") {
  CHECK(solved_with("robustness", "what floats have lost stays lost"));
  const double position = 1e6 + 0.01;
  const auto kept = static_cast<double>(static_cast<float>(position));
  CHECK(std::abs(kept - 1e6 - 0.01) > 0.005);
}

TEST_CASE("a difference of two products of doubles errs by 3 u of their size at most", "[words]") {
  CHECK(solved_with("rounding-bound", "its entries taken as exact, each product has 2: 3 u"));
  bench::Random random = random_of("two products");
  int rounded = 0;
  for (int k = 0; k < 2000; ++k) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), c = random.uniform(-1, 1),
                 d = k % 2 == 0 ? random.uniform(-1, 1) : b * c / a;  // nearly 0
    const double left = a * d, right = b * c, det = left - right;
    Rational error = Rational(det) - (Rational(a) * Rational(d) - Rational(b) * Rational(c));
    if (error < 0) error = -error;
    CHECK(error <= Rational(3 * 0x1p-53) * (Rational(std::abs(left)) + Rational(std::abs(right))));
    rounded += error > 0;
  }
  CHECK(rounded > 0);
}

TEST_CASE("an exchange of two points and a y downward turn an orientation, a cyclic exchange does not", "[words]") {
  CHECK(solved_with("rounding-bound", "Exchanging two of three points turns the sign; a cyclic exchange of all three"));
  CHECK(solved_with("rounding-bound", "left and right are exchanged"));
  bench::Random random = random_of("exchanges");
  const auto down = [](const Vec2& p) { return Vec2(p.x(), -p.y()); };
  for (int k = 0; k < 200; ++k) {
    const Vec2 a = random.in_box<2>(1), b = random.in_box<2>(1), c = random.in_box<2>(1);
    const int sign = orient2d(a, b, c);
    for (const int other : {orient2d(b, a, c), orient2d(a, c, b), orient2d(c, b, a)}) CHECK(other == -sign);
    for (const int other : {orient2d(b, c, a), orient2d(c, a, b)}) CHECK(other == sign);
    CHECK(orient2d(down(a), down(b), down(c)) == -sign);
  }
}

TEST_CASE("integers of 64 bits hold what is told, and no more", "[words]") {
  CHECK(solved_with("rounding-bound", "From 0 to 2²⁶ − 1, without a sign, differences are less than 2²⁶, too."));
  CHECK(solved_with("rounding-bound", "for coordinates from 0 to 2³¹ − 1. With 32 bits a product may pass 2⁶³."));
  const auto most = [](int bits) { return (std::uint64_t{1} << bits) - 1; };
  CHECK(2 * most(26) * most(26) <= std::uint64_t{1} << 53);
  CHECK(2 * most(27) * most(27) > std::uint64_t{1} << 53);
  const auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  CHECK(2 * most(31) * most(31) <= largest);
  CHECK(most(32) * most(32) > largest);
  CHECK(static_cast<std::int64_t>(most(32) * most(32)) < 0);  // a positive product
  CHECK(static_cast<double>(most(32)) * static_cast<double>(most(32)) > 0);
}

TEST_CASE("errors of two numbers grow in their difference as told, though the subtraction is exact", "[words]") {
  CHECK(solved_with("rounding-bound", "For 1 and 0.999 that is 1999 ε"));
  const Rational x = 1, y = Rational(999) / 1000, error = Rational(1) / 1000000;
  const Rational grown = (x * (1 + error) - y * (1 - error) - (x - y)) / (x - y);
  CHECK(grown == 1999 * error);
  CHECK(grown == error * (x + y) / (x - y));
  const double below = 0.999;
  CHECK(Rational(1 - below) == 1 - Rational(below));
}

}  // namespace answers_of_numbers_words_test
