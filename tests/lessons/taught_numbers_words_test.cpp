// What readers could not answer in three exams from the lessons' texts, or found false: each sentence about numbers,
// rounding and costs is computed here.

#include <algorithm>
#include <cmath>

#include <isect/methods/aabb_aabb.h>
#include <isect/methods/interval_interval.h>
#include <isect/methods/orient.h>
#include <isect/orient.h>
#include "bench/orient2d/oracle.h"
#include "bench/random.h"
#include "lessons/speed_against_error/results.h"
#include "tests/lessons/words.h"

namespace taught_numbers_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

TEST_CASE("a NaN hides a gap from its own comparison alone", "[words]") {
  CHECK(solved_with("intervals", "unless its other comparison finds a gap: [NaN, 1] and [2, 3] are DISJOINT by both"));
  CHECK(solved_with("aabb-aabb", "That comparison finds no gap, but the axis' other one may."));
  const auto by_at_most = [](const Interval<double>& a, const Interval<double>& b) {
    return a.lo <= b.hi && b.lo <= a.hi;
  };
  const Interval<double> b = {2, 3};
  int disjoint_by_both = 0, apart = 0;
  for (const Interval<double>& a : {Interval<double>{NAN, 1}, {NAN, 2}, {NAN, 2.5}, {NAN, 4}, {4, NAN}, {1, NAN}}) {
    const bool gap = a.lo > b.hi || b.lo > a.hi;
    CHECK_FALSE(by_at_most(a, b));
    CHECK(interval_interval::ends(a, b) == !gap);
    CHECK(aabb_aabb::by_axis(Aabb<double, 2>{{a.lo, 0}, {a.hi, 1}}, Aabb<double, 2>{{b.lo, 0}, {b.hi, 1}}) == !gap);
    disjoint_by_both += gap, apart += !gap;
  }
  CHECK((disjoint_by_both == 2 && apart == 4));
  CHECK_FALSE(interval_interval::ends(Interval<double>{NAN, 1}, b));
}

TEST_CASE("no interval is empty where the larger lower end is said to be a common number", "[words]") {
  int said = 0;
  on_random_settings("intervals", 100, [&](const Parameters& p, const Walk& walk) {
    const auto number = [&](const char* name) { return std::get<double>(p.at(name)); };
    for (const Step& s : walk.steps) {
      if (!says(s.caption, "Neither interval is empty")) continue;
      ++said;
      CHECK((number("a_min") <= number("a_max") && number("b_min") <= number("b_max")));
      CHECK(std::max(number("a_min"), number("b_min")) <= std::min(number("a_max"), number("b_max")));
    }
  });
  CHECK(said > 0);
}

TEST_CASE("the expanded determinant loses an area far from the origin, and differences keep it", "[words]") {
  CHECK(solved_with("speed-against-error", "det is 1. Doubles near 10¹⁶ are 2 apart, so the sum comes out as 0."));
  CHECK(std::nextafter(1e16, INFINITY) - 1e16 == 2);
  using P = Point<double, 2>;
  const P a(1e8, 1e8), b(1e8 + 1, 1e8), c(1e8, 1e8 + 1);
  CHECK(orient::expanded(a, b, c) == 0);
  CHECK(orient::pivoted<orient::Corner::c>(a, b, c) == 1);
  CHECK(oracle::orientation(a, b, c) == 1);
  bool measured = false;
  for (const bench::Row& r : lessons::speed_against_error_lesson::results().rows)
    measured = measured || r.method == "expanded";
  CHECK(told("speed-against-error", "Expanded adds up six products of coordinates") == measured);
}

TEST_CASE("scaling by a power of two rounds nothing, and a translation does", "[words]") {
  CHECK(solved_with("speed-against-error", "Scale by a power of two: that rounds nothing"));
  CHECK(solved_with("speed-against-error", "A translation rounds anew, so near a touch it may change the answer."));
  bench::Random random = random_of("moved");
  int changed = 0;
  for (int k = 0; k < 500; ++k) {
    const Vec2 a = random.in_box<2>(1), b = random.in_box<2>(1), c = a + random.unit() * (b - a);
    const double area = orient::pivoted<orient::Corner::c, double>(a, b, c),
                 scale = std::ldexp(1.0, random.integer(-60, 60));
    CHECK(orient::pivoted<orient::Corner::c, double>(scale * a, scale * b, scale * c) == scale * scale * area);
    CHECK(orient2d(a, b, c) == -orient2d(b, a, c));
    const Vec2 by(3.7, 11.3);
    changed += orient2d(Vec2(a + by), Vec2(b + by), Vec2(c + by)) != orient2d(a, b, c);
  }
  CHECK(changed > 0);
}

TEST_CASE("a difference of two products errs as much as is told at most", "[words]") {
  CHECK(solved_with("rounding-bound", "It errs by (2 u + u²) (|a d| + |b c|) at most."));
  CHECK(solved_with("rounding-bound", "3 u makes up for that"));
  constexpr double u = 1.0 / (1 << 24);  // floats, whose products are doubles
  bench::Random random = random_of("products");
  for (int k = 0; k < 2000; ++k) {
    const auto number = [&] { return static_cast<float>(random.uniform(1, 2)); };
    const float a = number(), b = number(), c = number(), d = number(), l = a * d, r = b * c, rounded = l - r;
    const double left = double(a) * d, right = double(b) * c, error = std::abs(rounded - (left - right));
    CHECK(error <= (2 * u + u * u) * (left + right) * (1 + 1e-12));
    CHECK(error <= 3 * u * (double(l) + r));
  }
}

TEST_CASE("floats whose squares overflow or vanish mislead as is told", "[words]") {
  CHECK(solved_with("sphere-sphere", "∞ ≤ ∞ holds, and balls far apart seem to meet"));
  CHECK(solved_with("sphere-sphere", "Distances below 10⁻²³ have a square of 0"));
  const volatile float d = 1e20F, R = 2e19F, small = 0.99e-23F;
  const float d2 = d * d, R2 = R * R, small2 = small * small;
  CHECK((std::isinf(d2) && std::isinf(R2) && d2 <= R2 && !(d <= R)));
  CHECK((small2 == 0 && small > 0));
  CHECK_FALSE(double(d) * d <= double(R) * R);
  const float scaled = std::ldexp(d, -40), bound = std::ldexp(R, -40);
  CHECK_FALSE(scaled * scaled <= bound * bound);
}

TEST_CASE("a small denominator makes the errors of t that are told", "[words]") {
  CHECK(solved_with("rays", "in n · o + D moves it by 0.001, one of 10⁻⁸ in n · d by 1"));
  CHECK(solved_with("rays", "n · d = 3 > 0: the line crosses to the side to which n points."));
  const double t = 1 / 1e-4;
  CHECK(t == Approx(1e4));
  CHECK((1 + 1e-7) / 1e-4 - t == Approx(0.001).epsilon(0.01));
  CHECK(1 / (1e-4 - 1e-8) - t == Approx(1).epsilon(0.01));
  const Vec2 n(1, 0), o(1, 2), d(3, 4);
  const double at = -(n.dot(o) - 7) / n.dot(d);
  CHECK((at == 2 && at * d.norm() == 10 && n.dot(d) == 3));
  CHECK((n.dot(o) - 7 < 0 && n.dot(Vec2(o + 3 * d)) - 7 > 0));
}

TEST_CASE("a rounded crossing may lie beyond its side, and its coordinate set to the side does not", "[words]") {
  CHECK(solved_with("clipping", "A rounded crossing may lie a little beyond its side."));
  bench::Random random = random_of("crossings");
  int beyond = 0;
  for (int k = 0; k < 2000; ++k) {
    const double p = random.uniform(-8, 2), q = random.uniform(2, 20), t = (2 - p) / (q - p), x = p + t * (q - p);
    CHECK(std::abs(x - 2) < 1e-14);
    beyond += x > 2;
  }
  CHECK(beyond > 0);
}

TEST_CASE("a random shift is no half-open rule, as whole heights are often equal", "[words]") {
  CHECK(solved_with("crossings", "Far from the origin rounding may swallow it. With whole numbers vertices often lie"));
  CHECK(1e16 + 1e-3 == 1e16);
  bench::Random random = random_of("heights");
  int equal = 0, carried = 0;
  for (int k = 0; k < 1000; ++k) {
    equal += random.below(20) == random.below(20);
    const double x = random.uniform(-1e-3, 0);  // left of the edge x = 0
    carried += x + random.uniform(0, 1e-3) > 0;
  }
  CHECK((equal > 20 && carried > 0));
  CHECK(solved_with("picking", "Else take the least distance in pixels, then the least depth."));
}

TEST_CASE("relative to the numbers compared, no tolerance lets a small one be 0", "[words]") {
  CHECK(solved_with("points", "differs from 0 by all of its size"));
  for (const double x : {1e-17, -1e-17, 1e-300}) CHECK(std::abs(x - 0) == std::max(std::abs(x), 0.0));
  const double rounded = 0.1 + 0.2 - 0.3;  // should be 0
  CHECK((rounded != 0 && std::abs(rounded) < 1e-16));
}

TEST_CASE("a cheap test pays up to the share that is told, and a false negative is lost", "[words]") {
  CHECK(solved_with("rules-of-thumb", "It pays if that share is less than 1 − c₁ / c₂."));
  CHECK(solved_with("rules-of-thumb", "no later test sees that pair again"));
  for (const double cheap : {1.0, 11.0, 100.0})
    for (const double full : {110.0, 150.0})
      for (const double share : {0.0, 0.1, 0.3, 0.5, 0.8, 0.95, 1.0})
        CHECK((cheap + share * full < full) == (share < 1 - cheap / full));
}

TEST_CASE("bounds of few bits contain an interval if rounded outwards, and may not if rounded to the closest step",
          "[words]") {
  CHECK(solved_with("bounding-volumes", "Rounded to the closest step, a box may leave out a part of its object."));
  constexpr double step = 1000.0 / 1024;
  bench::Random random = random_of("few bits");
  int lost = 0;
  for (int k = 0; k < 200; ++k) {
    const double lo = random.uniform(0, 900), hi = lo + random.uniform(0, 90);
    CHECK((std::floor(lo / step) * step <= lo && hi <= std::ceil(hi / step) * step));
    lost += lo < std::round(lo / step) * step || std::round(hi / step) * step < hi;
  }
  CHECK(lost > 0);
}

}  // namespace taught_numbers_words_test
