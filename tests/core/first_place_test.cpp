#include <isect/first_place.h>

#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>

#include <cmath>
#include <limits>
#include <random>

#include "bench/line_triangle/oracle.h"
#include "bench/random_rays.h"
#include "bench/ray_capsule/oracle.h"
#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "bench/ray_outline/oracle.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/ray_capsule_pairs.h"
#include "tests/core/ray_outline_pairs.h"
#include "tests/settings.h"

namespace first_place_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational, oracle::operator-, oracle::operator*, oracle::operator+;
using tests::inf;

namespace {

/// Whether the place lies among doubles as the truth does.
bool is(const Place& place, const Rational& truth) {
  const double near = static_cast<double>(truth);
  if (!std::isfinite(near)) return compare(place, place_at(near > 0 ? 0x1p1023 : -0x1p1023)) == (near > 0 ? 1 : -1);
  for (int steps = -2; steps <= 2; ++steps) {
    const double t = bench::moved(near, steps);
    if (std::isfinite(t) && compare(place, place_at(t)) != oracle::sign(Rational(truth - Rational(t)))) return false;
  }
  return true;
}

/// Whether it lies among doubles as where a line enters the convex solid does.
bool enters(const Place& place, const oracle::LineInConvex& truth, double near) {
  for (int steps = -2; steps <= 2; ++steps) {
    const double t = bench::moved(near, steps);
    if (std::isfinite(t) && (compare(place, place_at(t)) <= 0) != truth.entered(Rational(t))) return false;
  }
  return true;
}

int order(const std::optional<Place>& x, const std::optional<Place>& y) { return compare(x.value(), y.value()); }

}  // namespace

TEST_CASE("places are put in order as the numbers they are made of", "[first_place]") {
  std::mt19937_64 random(7);
  const auto whole = [&](int lo, int hi) { return static_cast<double>(std::uniform_int_distribution(lo, hi)(random)); };
  int equal = 0, less = 0;
  for (int k = 0; k < 20000; ++k) {
    // (n + s sqrt(q)) / d, compared in long doubles where they differ: by more than 1e-9 for numbers so small
    const auto drawn = [&] {
      const int side = static_cast<int>(whole(-1, 1));
      return Place{whole(-6, 6), whole(1, 6), side, side == 0 ? Exact(0.0) : Exact(whole(0, 12))};
    };
    const auto value = [](const Place& p) {
      return (static_cast<long double>(p.num.rounded()) +
              static_cast<long double>(p.side) * std::sqrt(static_cast<long double>(p.square.rounded()))) /
             static_cast<long double>(p.den.rounded());
    };
    const Place x = drawn(), y = drawn();
    const long double apart = value(x) - value(y);
    const int expected = std::abs(apart) < 1e-12L ? 0 : apart < 0 ? -1 : 1;
    CAPTURE(x.num.rounded(), x.den.rounded(), x.side, x.square.rounded(), y.num.rounded(), y.den.rounded(), y.side,
            y.square.rounded());
    CHECK(compare(x, y) == expected);
    CHECK(compare(y, x) == -expected);
    equal += expected == 0, less += expected < 0;

    const Exact by = whole(1, 9);  // the same number, written otherwise
    CHECK(compare(x, {x.num * by, x.den * by, x.side, x.square * by * by}) == 0);
    const Exact more = 0x1p-200;
    CHECK(compare(x, {x.num * by + more, x.den * by, x.side, x.square * by * by}) == -1);
  }
  CHECK(equal > 100);
  CHECK(less > 5000);
}

TEST_CASE("shapes that are met in one point are met at one t, whatever they are", "[first_place]") {
  // From (-3, -2, 5) along (3, 1, -2): in (3, 0, 1) at t = 2
  const Ray<double, 3> ray = {{-3, -2, 5}, {3, 1, -2}};
  const Point<double, 3> at = {3, 0, 1};
  const Place two = place_at(2);
  const auto met = [&](const auto& shape) { return order(first_place(ray, shape), two); };
  CHECK(met(at) == 0);
  CHECK(met(Plane<double, 3>{{1, 0, 0}, -3}) == 0);
  CHECK(met(Plane<double, 3>{{1, 0, 0}, -std::nextafter(3., 4.)}) == 1);
  CHECK(met(half_spaces_of(Aabb<double, 3>{{3, -1, -1}, {5, 1, 1}})) == 0);
  CHECK(met(half_spaces_of(Aabb<double, 3>{{std::nextafter(3., 2.), -1, -1}, {5, 1, 2}})) == -1);
  CHECK(met(Sphere<double, 3>{{6, 4, 1}, 5}) == 0);  // by 3, 4, 5
  CHECK(met(Sphere<double, 3>{{6, 4, 1}, std::nextafter(5., 6.)}) == -1);
  CHECK(met(Capsule<double, 3>{{6, 4, 1}, {9, 9, 1}, 5}) == 0);
  CHECK(met(Capsule<double, 3>{{6, 4, -9}, {6, 4, 9}, 5}) == 0);  // by its side
  CHECK(met(Capsule<double, 3>{{6, 4, 1}, {6, 4, 1}, 5}) == 0);   // without an axis
  CHECK(met(Cylinder<double>{{6, 4, -9}, {6, 4, 9}, 5}) == 0);
  CHECK(met(Cylinder<double>{{6, 4, -9}, {6, 4, 9}, std::nextafter(5., 6.)}) == -1);
  CHECK(met(Cylinder<double>{{3, 0, 0}, {9, 0, 0}, 2}) == 0);  // by its end
  CHECK(met(Cone<double>{{6, 4, 3}, {6, 4, -1}, 10}) == 0);    // halfway down its side
  CHECK(met(Cone<double>{{6, 4, 3}, {6, 4, -1}, std::nextafter(10., 9.)}) == 1);
  CHECK(met(Cone<double>{{3, 0, 1}, {9, 0, 1}, 1}) == 0);  // in its apex
  CHECK_FALSE(first_place(ray, Cone<double>{{6, 4, 3}, {6, 4, 3}, 10}));
  CHECK_FALSE(first_place(ray, Cylinder<double>{{6, 4, -9}, {6, 4, 9}, -5}));
  CHECK(met(Triangle<double, 3>{{Point<double, 3>{3, -9, -9}, {3, 9, -9}, {3, 0, 9}}}) == 0);
  CHECK(met(Triangle<double, 3>{{Point<double, 3>{3, -1, 1}, {3, 1, 1}, {3, 0, 1}}}) == 0);  // without area
  CHECK(met(Segment<double, 3>{{3, 0, 1}, {9, 9, 9}}) == 0);
  CHECK(met(Ray<double, 3>{{9, 0, 1}, {-1, 0, 0}}) == 0);
  CHECK(met(Ray<double, 3>{{3, 0, 1}, {0, 0, 0}}) == 0);
  CHECK(met(Polygon<double, 3>{{{{3, -9, -9}, {3, 9, -9}, {3, 9, 9}, {3, -9, 9}}}}) == 0);
  CHECK(met(ray) == -1);  // along itself, where it begins
  CHECK_FALSE(first_place(ray, Polygon<double, 3>{{{{3, 1, -9}, {3, 9, -9}, {3, 9, 9}}}}));
  CHECK_FALSE(first_place(ray, Point<double, 3>(3, 0, std::nextafter(1., 2.))));
  CHECK_FALSE(first_place(ray, Ray<double, 3>{{9, 0, 1}, {1, 0, 0}}));
  CHECK_FALSE(first_place(ray, Sphere<double, 3>{{6, 4, 1}, -1}));
  CHECK_FALSE(first_place(ray, Sphere<double, 3>{{inf, 4, 1}, 5}));
  CHECK_FALSE(first_place(Ray<double, 3>{{inf, -2, 5}, {3, 1, -2}}, at));
  CHECK_FALSE(first_place(Ray<double, 3>{ray.origin, ray.direction, {0, std::nextafter(2., 0.)}}, at));
  CHECK_FALSE(first_place(Ray<double, 3>{ray.origin, ray.direction, {3, 2}}, at));
  const Ray<double, 3> line = {ray.origin, ray.direction, infinite<double>};
  CHECK_FALSE(first_place(line, line));  // it has no first point
  CHECK(order(first_place(line, Sphere<double, 3>{{6, 4, 1}, 5}), two) == 0);
}

TEST_CASE("roots of different shapes are told apart, or found equal", "[first_place]") {
  // The side of a capsule, the ball that it is around its middle, and a ball an ulp larger, at an irrational t
  const Ray<double, 3> ray = {{0, -9, 0.1}, {0, 1, 0.3}};
  const Capsule<double, 3> capsule = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto side = first_place(ray, capsule);
  CHECK(order(side, first_place(ray, Sphere<double, 3>{{0, 0, 0}, 5})) == 0);
  CHECK(order(side, first_place(ray, Sphere<double, 3>{{0, 0, 0}, std::nextafter(5., 6.)})) == 1);
  CHECK(order(side, first_place(ray, Sphere<double, 3>{{0, 0, 0}, std::nextafter(5., 4.)})) == -1);
  CHECK(order(side, first_place(ray, Capsule<double, 3>{{-7, 0, 0}, {0, 0, 0}, 5})) == 0);
  const Segment<double, 3> segment = {ray.origin, {0, 91, 30.1}};  // the same line, in hundredths up to rounding
  CHECK(first_place(segment, capsule).has_value());
}

TEST_CASE("where a line enters a ball or a capsule is among doubles where rational arithmetic has it",
          "[first_place]") {
  using namespace tests::ray_capsule_pairs;
  int checked = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(250, 20000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Case<double, 3> c = draw<double, 3>(random, numbers, i % 2 == 0);
      if (!finite(c.ray) || !finite(c.capsule) || c.ray.direction.isZero(0)) continue;
      if (i % 3 == 0) c.capsule.q = c.capsule.p;
      const oracle::LineInConvex truth = oracle::line_in_capsule(c.ray, c.capsule);
      const auto place = first_place(c.ray, c.capsule);
      const auto hit = first_hit(c.ray, c.capsule);
      const bool begins = hit && std::isfinite(c.ray.range.lo) && truth.holds(Rational(c.ray.range.lo));
      REQUIRE(place.has_value() == hit.has_value());
      if (i % 3 == 0)
        REQUIRE(first_place(c.ray, Sphere<double, 3>{c.capsule.p, c.capsule.radius}).has_value() == hit.has_value());
      if (!hit) continue;
      REQUIRE((begins ? compare(*place, place_at(c.ray.range.lo)) == 0 : enters(*place, truth, *hit)));
      ++checked;
    }
  }
  CHECK(checked > 300);
}

namespace {

/// Counts what was checked.
template <template <class> class Solid>
void check_round(const bench::RayAndSolid<double, Solid<double>>& c, int& checked) {
  const auto hit = first_hit(c.a, c.b);
  const auto place = first_place(c.a, c.b);
  REQUIRE(place.has_value() == hit.has_value());
  if (!hit || c.a.direction.isZero(0)) return;
  const oracle::LineInConvex truth = oracle::line_in(c.a, c.b);
  const bool begins = std::isfinite(c.a.range.lo) && truth.holds(Rational(c.a.range.lo));
  REQUIRE((begins ? compare(*place, place_at(c.a.range.lo)) == 0 : enters(*place, truth, *hit)));
  ++checked;
}

template <template <class> class Solid>
int check_round() {
  int checked = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + 60 + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(200, 20000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = bench::ray_and_solid::of_any_numbers<double, Solid>(random, numbers);
      // a line without direction may begin nowhere
      if (!c.a.direction.isZero(0)) check_round<Solid>(c, checked);
    }
  }
  for (const auto& drawn : bench::ray_and_solid_draws<double, Solid>) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(100, 10000); ++i) {
      INFO("seed " << tests::seed() << ", " << drawn.name << ", case " << i);
      check_round<Solid>(drawn.draw(random), checked);
    }
  }
  return checked;
}

}  // namespace

TEST_CASE("where a line enters a cylinder or a cone is among doubles where rational arithmetic has it",
          "[first_place]") {
  CHECK(check_round<Cylinder>() > 400);
  CHECK(check_round<Cone>() > 400);
}

TEST_CASE("where a line first meets a triangle, a segment or half-spaces is the rational number", "[first_place]") {
  int hits = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 20 + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(400, 40000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto point = [&]() -> Point<double, 3> { return bench::vector<double, 3>(random, numbers); };
      Triangle<double, 3> x = {{point(), point(), point()}};
      if (random.one_in(3)) x.vertices[2] = x.vertices[random.below(2)];
      if (random.one_in(3)) x.vertices[1][2] = x.vertices[2][2] = x.vertices[0][2];
      Segment<double, 3> s = {point(),
                              random.one_in(2) ? Point<double, 3>(x.vertices[1] / 2 + x.vertices[2] / 2) : point()};
      if (random.one_in(3)) s.p[2] = s.q[2] = x.vertices[0][2];
      if (!finite(s) || s.p == s.q) continue;
      const auto o = oracle::rational<double, 3>(s.p), d = oracle::rational<double, 3>(s.q) - o;
      const auto truth = oracle::first_hit(o, d, {0, 1}, oracle::corners(x));
      const auto place = first_place(s, x);
      REQUIRE(place.has_value() == truth.has_value());
      if (place) REQUIRE(is(*place, *truth));
      hits += place.has_value();
      const Polygon<double, 3> outline = {{{x.vertices[0], x.vertices[1], x.vertices[2]}}};
      if (!triangle_half_spaces::detail::degenerate(x, NoTrace())) {
        const auto of_outline = first_place(s, outline);
        REQUIRE(of_outline.has_value() == truth.has_value());
        if (truth) REQUIRE(is(*of_outline, *truth));
      }
    }
  }
  CHECK(hits > 300);
}

TEST_CASE("where a line first meets a polygon in the plane is the rational number", "[first_place]") {
  int hits = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 40 + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(400, 40000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = tests::ray_outline_pairs::draw<double>(random, numbers);
      if (c.ray.direction.isZero(0)) continue;
      const auto truth = oracle::first_hit(oracle::rational(c.ray.origin), oracle::rational(c.ray.direction),
                                           c.ray.range, oracle::rational(c.polygon));
      const auto place = first_place(c.ray, c.polygon);
      REQUIRE(place.has_value() == truth.has_value());
      if (place) REQUIRE(is(*place, *truth));
      hits += place.has_value();
    }
  }
  CHECK(hits > 300);
}

}  // namespace first_place_test
