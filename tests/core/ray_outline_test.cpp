#include <isect/ray_outline.h>

#include <isect/point_polygon.h>
#include <isect/segment_segment.h>

#include <cmath>
#include <limits>
#include <random>

#include "bench/ray_outline/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/poses.h"
#include "tests/core/ray_outline_pairs.h"
#include "tests/settings.h"

namespace ray_outline_test {
using namespace isect;
using oracle::Rational, oracle::operator-;
using tests::inf, tests::not_a_number;
using tests::ray_outline_pairs::Case, tests::ray_outline_pairs::draw;

namespace {

/// A square from (1, 1) to (5, 5), with a hole from (2, 2) to (4, 4).
template <class S>
Polygon<S, 2> frame() {
  const auto square = [](S lo, S hi) -> Ring<S, 2> { return {{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}}; };
  return {{square(1, 5), square(2, 4)}};
}
template <class S>
std::optional<S> first(S x, S y, S dx, S dy, double lo = 0, double hi = inf) {
  return first_hit(Ray<S, 2>{{x, y}, {dx, dy}, {static_cast<S>(lo), static_cast<S>(hi)}}, frame<S>());
}

}  // namespace

TEMPLATE_TEST_CASE("a ray first meets a polygon at an edge, at a corner, or where it starts", "[ray_outline]", float,
                   double) {
  using S = TestType;
  CHECK(first<S>(0, 3, 1, 0) == S(1));
  CHECK(first<S>(0, 3, 2, 0) == S(0.5));       // in units of the direction
  CHECK(first<S>(1.5, 3, 1, 0) == S(0));       // from inside
  CHECK(first<S>(3, 3, 1, 0) == S(1));         // from the hole
  CHECK(first<S>(2, 3, 1, 0) == S(0));         // from its boundary
  CHECK(first<S>(0, 3, 1, 0, -inf) == S(1));   // a line
  CHECK(first<S>(9, 3, 1, 0, -inf) == S(-8));  // behind the origin
  CHECK(first<S>(0, 3, 1, 0, 2.5) == S(4));    // the range starts in the hole
  CHECK(first<S>(0, 3, 1, 0, 1.5) == S(1.5));  // within
  CHECK(first<S>(0, 0, 1, 1) == S(1));         // at a corner
  CHECK(first<S>(0, 2, 1, -1) == S(1));        // that the line only touches
  CHECK(first<S>(0, 1, 1, 0) == S(1));         // along an edge
  CHECK(first<S>(0, 1, 1, 0, 3) == S(3));      // which the range starts on
  CHECK(first<S>(0, 2, 1, 0, 5.5) == std::nullopt);
  CHECK(first<S>(9, 3, 1, 0) == std::nullopt);
  CHECK(first<S>(0, 3, 1, 0, 0, 1) == S(1));
  CHECK(first<S>(0, 3, 1, 0, 0, std::nextafter(S(1), S(0))) == std::nullopt);
  CHECK(first<S>(0, 2 - std::numeric_limits<S>::epsilon(), 1, -1) == std::nullopt);
  CHECK(first<S>(0, 1, 3, 1) == S(1) / 3);  // the nearest number to a third
}

TEMPLATE_TEST_CASE("ray and polygon in the plane: points, thin rings, nothing finite", "[ray_outline]", float, double) {
  using S = TestType;
  CHECK(first<S>(1.5, 3, 0, 0, -2, 7) == S(-2));
  CHECK(first<S>(1, 3, 0, -0., -inf) == -std::numeric_limits<S>::infinity());
  CHECK(first<S>(3, 3, 0, 0) == std::nullopt);
  const Ray<S, 2> ray = {{0, 0}, {1, 1}};
  CHECK(first_hit(ray, Polygon<S, 2>{{{{4, 0}, {0, 4}}}}) == S(2));  // a segment
  CHECK(first_hit(ray, Polygon<S, 2>{{{{3, 3}, {8, 8}}}}) == S(3));
  CHECK(first_hit(ray, Polygon<S, 2>{{{{3, 3}}}}) == S(3));  // a point
  CHECK(first_hit(ray, Polygon<S, 2>{{{{3, 4}}, {}}}) == std::nullopt);
  CHECK(first_hit(ray, Polygon<S, 2>{}) == std::nullopt);
  CHECK(first<S>(0, 3, 1, 0, 2, 1) == std::nullopt);
  CHECK(first<S>(0, 3, 1, 0, inf, inf) == std::nullopt);
  for (const double bad : {not_a_number, inf, -inf}) {
    const S x = static_cast<S>(bad);
    CHECK(first<S>(x, 3, 1, 0) == std::nullopt);
    CHECK(first<S>(0, 3, x, 0) == std::nullopt);
    CHECK(first_hit(ray, Polygon<S, 2>{{{{4, 0}, {0, 4}, {x, 9}}}}) == std::nullopt);
  }
  CHECK(first<S>(0, 3, 1, 0, not_a_number) == std::nullopt);
  // A bow-tie wound twice around the point: outside by even-odd
  const Polygon<S, 2> twice = {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
  const Ray<S, 2> within = {{2, 2}, {1, 0}};
  CHECK(first_hit(within, twice) == S(2));
  CHECK(first_hit(within, twice, FillRule::nonzero) == S(0));
}

TEST_CASE("a segment in the plane keeps both its ends", "[ray_outline]") {
  const Polygon<double, 2> at_third = {{{{1 / 3., -1}, {1 / 3., 1}, {-1, 0}}}};
  CHECK(first_hit(Segment<double, 2>{{1e8, 0}, {1 / 3., 0}}, at_third) == 1.0);
  CHECK(first_hit(Segment<double, 2>{{1e8, 0}, {std::nextafter(1 / 3., 1), 0}}, at_third) == std::nullopt);
  CHECK(first_hit(Segment<double, 2>{{0, 0}, {0, 0}}, at_third) == 0.0);
  CHECK(first_hit(Segment<double, 2>{{1, 0}, {1, 0}}, at_third) == std::nullopt);
  CHECK(first_hit(Segment<double, 2>{{not_a_number, 0}, {1, 0}}, at_third) == std::nullopt);
}

TEST_CASE("ray and polygon in the plane: the events tell where it starts, and what comes nearer", "[ray_outline]") {
  Record<ray_outline::Event> record;
  CHECK(first_hit(Ray<double, 2>{{0, 3}, {1, 0}}, frame<double>(), FillRule::even_odd, record) == 1.0);
  int nearer = 0, starts = 0;
  for (const ray_outline::Event& event : record.events) {
    const auto* start = std::get_if<ray_outline::Start>(&event);
    const auto* met = std::get_if<ray_outline::Nearer>(&event);
    starts += start != nullptr, nearer += met != nullptr;
    CHECK_FALSE((start && start->location != Location::out));
    CHECK_FALSE((met && met->corner));
  }
  CHECK(starts == 1);
  CHECK(nearer == 2);  // the right side at 5, then the left one at 1
}

TEMPLATE_TEST_CASE("ray and polygon in the plane: the first t is that of rational arithmetic", "[ray_outline]", float,
                   double) {
  using S = TestType;
  int hits = 0, misses = 0, starts = 0, lines = 0;
  double worst = 0;
  for (const bench::Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(2000, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Case<S> c = draw<S>(random, numbers);
      const std::optional<S> t = first_hit(c.ray, c.polygon);
      Record<ray_outline::Event> record;
      REQUIRE(first_hit(c.ray, c.polygon, FillRule::even_odd, record) == t);
      const auto rings = oracle::rational(c.polygon);
      const auto o = oracle::rational(c.ray.origin), d = oracle::rational(c.ray.direction);
      if (c.ray.direction.isZero(0)) {
        REQUIRE(t.has_value() == (!empty(c.ray.range) && oracle::locate(o, rings) != Location::out));
        continue;
      }
      const auto truth = oracle::first_hit(o, d, cast<double>(c.ray.range), rings);
      REQUIRE(t.has_value() == truth.has_value());
      (t ? hits : misses) += 1;
      if (!t) continue;
      REQUIRE((c.ray.range.lo <= *t && *t <= c.ray.range.hi));
      const bool start = std::isfinite(c.ray.range.lo) && *truth == Rational(c.ray.range.lo);
      if (start) REQUIRE(*t == c.ray.range.lo);
      starts += start, lines += std::isinf(c.ray.range.lo);
      worst = std::max(worst, oracle::ulps(*t, *truth));
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses, starts, lines}) CHECK(often > 500);
}

TEMPLATE_TEST_CASE("segment and polygon in the plane: the first t is that of rational arithmetic", "[ray_outline]",
                   float, double) {
  using S = TestType;
  int hits = 0, misses = 0;
  for (const bench::Numbers numbers : bench::all_numbers_and_ends) {
    bench::Random random(tests::seed() + 50 + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(800, 80000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Case<S> c = draw<S>(random, numbers);
      const Ring<S, 2>& ring = c.polygon.rings[0];
      const Segment<S, 2> segment = {c.ray.origin,
                                     random.one_in(3) ? ring.back() : bench::vector<S, 2>(random, numbers)};
      if (segment.p == segment.q) continue;
      const std::optional<S> t = first_hit(segment, c.polygon);
      const auto o = oracle::rational(segment.p), q = oracle::rational(segment.q);
      const auto truth = oracle::first_hit(o, oracle::P2(q - o), {0, 1}, oracle::rational(c.polygon));
      REQUIRE(t.has_value() == truth.has_value());
      (t ? hits : misses) += 1;
      if (t) REQUIRE((0 <= *t && *t <= 1 && oracle::ulps(*t, *truth) <= 2));
    }
  }
  for (const int often : {hits, misses}) CHECK(often > 500);
}

TEMPLATE_TEST_CASE("ray and polygon in the plane: turning, moving and scaling the frame change no verdict",
                   "[ray_outline]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed() + 7);
  for (int i = 0; i < tests::cases(500, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case<S> c = draw<S>(random, bench::Numbers::grid);
    const std::optional<S> t = first_hit(c.ray, c.polygon);
    Case<S> other = c;
    const auto each = [&](const auto& change) {
      change(other.ray.origin);
      for (Ring<S, 2>& ring : other.polygon.rings) std::for_each(ring.begin(), ring.end(), change);
    };
    each([](Point<S, 2>& p) { p = Point<S, 2>(-p[1], p[0]) * S(4) + Point<S, 2>(100, -7); });
    other.ray.direction = Vector<S, 2>(-c.ray.direction[1], c.ray.direction[0]) * S(4);
    REQUIRE(first_hit(other.ray, other.polygon) == t);
    for (Ring<S, 2>& ring : other.polygon.rings) {
      std::reverse(ring.begin(), ring.end());
      std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
    }
    REQUIRE(first_hit(other.ray, other.polygon) == t);
  }
}

TEMPLATE_TEST_CASE("a ray or a segment in the plane of a polygon in space meets it as in the plane", "[ray_outline]",
                   float, double) {
  using S = TestType;
  bench::Random random(tests::seed() + 9);
  int coplanar = 0, across = 0, hits = 0;
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Case<S> c = draw<S>(random, bench::Numbers::grid);
    c.polygon.rings.resize(1);
    // A plane through whole points: x u + y v
    const auto whole = [&]() -> Vector<S, 3> {
      return {S(random.integer(-3, 3)), S(random.integer(-3, 3)), S(random.integer(-3, 3))};
    };
    const Vector<S, 3> u = whole(), v = whole(), shift = whole();
    const auto in_space = [&](const Vector<S, 2>& p) -> Vector<S, 3> { return p[0] * u + p[1] * v; };
    Polygon<S, 3> polygon = {{{}}};
    for (const Point<S, 2>& p : c.polygon.rings[0]) polygon.rings[0].push_back(in_space(p) + shift);
    const Ray<S, 3> ray = {in_space(c.ray.origin) + shift, in_space(c.ray.direction), c.ray.range};
    const RayPolygon<S> found = intersect(ray, polygon);
    if (found.flat) {
      REQUIRE_FALSE(first_hit(ray, polygon));
      continue;
    }
    REQUIRE(found.coplanar);
    ++coplanar;
    const std::optional<S> t = first_hit(c.ray, c.polygon);
    REQUIRE(first_hit(ray, polygon) == t);
    hits += t.has_value();
    const Point<S, 2> q = c.ray.origin + c.ray.direction;
    REQUIRE(first_hit(Segment<S, 3>{ray.origin, in_space(q) + shift}, polygon) ==
            first_hit(Segment<S, 2>{c.ray.origin, q}, c.polygon));

    const Ray<S, 3> other = {ray.origin, whole(), c.ray.range};
    if (intersect(other, polygon).coplanar) continue;
    REQUIRE(first_hit(other, polygon) == intersect(other, polygon).t);
    across += first_hit(other, polygon).has_value();
  }
  for (const int often : {coplanar, hits}) CHECK(often > 300);
  CHECK(across > 20);
}

namespace {

std::optional<double> first_in_plane(const Ray<double, 3>& ray, const Ring<double, 3>& outline) {
  return first_hit(ray, Polygon<double, 3>{{outline}});
}

}  // namespace

TEST_CASE("a ray in a polygon's plane meets it where the segment to its end does, for whole numbers", "[ray_outline]") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> whole(-4, 4), count(3, 7);
  int hits = 0, starts = 0;
  for (int i = 0; i < 4000; ++i) {
    Ring<double, 2> flat(static_cast<std::size_t>(count(random)));
    for (Point<double, 2>& v : flat) v = {whole(random), whole(random)};
    double area = 0;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      const auto &a = flat[k], &b = flat[(k + 1) % flat.size()];
      area += a.x() * b.y() - a.y() * b.x();
    }
    const Point<double, 2> o(whole(random), whole(random)), d(whole(random), whole(random));
    if (area == 0 || d.isZero(0)) continue;
    const int pose = i % 3;
    const double t_max = 1 + i % 4;
    Ring<double, 3> outline;
    for (const Point<double, 2>& v : flat) outline.push_back(test::in_space(v, pose));
    const Vector<double, 3> origin = test::in_space(o, pose),
                            direction = test::in_space(d, pose) - test::in_space({0, 0}, pose);
    const auto t = first_in_plane({origin, direction, {0, t_max}}, outline);

    const bool inside = locate(o, flat) != Location::out;
    bool meets = inside;
    double first = inside ? 0 : t_max;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      const auto shared =
          intersect(Segment<double, 2>{o, o + t_max * d}, Segment<double, 2>{flat[k], flat[(k + 1) % flat.size()]});
      if (shared.relation == segment_segment::Meeting::disjoint) continue;
      meets = true;
      const auto place = [&](const Point<double, 2>& p) { return (p - o).dot(d) / d.dot(d); };
      if (shared.point) first = std::min(first, place(*shared.point));
      if (shared.shared) first = std::min({first, place(shared.shared->p), place(shared.shared->q)});
    }
    INFO(i);
    REQUIRE(t.has_value() == meets);
    if (t) CHECK(*t == Approx(first).margin(1e-12));
    hits += meets, starts += inside;
    if (t) CHECK(first_in_plane({origin, direction, {-HUGE_VAL, HUGE_VAL}}, outline).value() <= *t);
    if (meets) CHECK(first_in_plane({origin, direction, {t_max, HUGE_VAL}}, outline).value_or(t_max) >= t_max);
  }
  CHECK((hits > 500 && starts > 200));
}

TEST_CASE("ends of a range count exactly, and a range without numbers is empty", "[ray_outline]") {
  const Ring<double, 3> square = {{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {1, 0, 2}};
  const Ray<double, 3> ray = {{0, 0, 1}, {1, 0, 0}, {0, 1}};
  CHECK(first_in_plane(ray, square) == 1.0);
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {0, std::nextafter(1.0, 0.0)}}, square));
  CHECK(first_in_plane({ray.origin, ray.direction, {2, 9}}, square) == 2.0);  // from inside
  CHECK(first_in_plane({ray.origin, ray.direction, {3, 9}}, square) == 3.0);  // leaving it
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {std::nextafter(3.0, 4.0), 9}}, square));
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {2, 1}}, square));
  CHECK(first_in_plane({{0, 0, 2}, {1, 0, 0}, {0, HUGE_VAL}}, square) == 1.0);  // along a side
  CHECK(first_in_plane({{0, 0, 2}, {1, 0, 0}, {2.5, HUGE_VAL}}, square) == 2.5);
  CHECK(first_in_plane({{0, 0, -1}, {1, 0, 1}, {0, HUGE_VAL}}, square) == 1.0);  // at a corner
  // A third is not a double: the hit is the one nearest to it.
  CHECK(first_in_plane({{0, 0, 1}, {3, 0, 0}, {0, HUGE_VAL}}, square) == 1.0 / 3);
}

}  // namespace ray_outline_test
