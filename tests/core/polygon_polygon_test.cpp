// Two polygons, and what runs along a line against a polygon: by name, by property, and against areas and places in
// rationals.

#include <isect/polygon_polygon.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "bench/polygon_polygon/families.h"
#include "bench/polygon_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace polygon_polygon_test {
using namespace isect;
using bench::PolygonPair;
using bench::Random;
using oracle::Rational;
using Polygon2 = Polygon<double, 2>;
using Ring2 = Ring<double, 2>;

namespace {

Ring2 box(double x0, double y0, double x1, double y1) { return bench::polygon_pairs::box(x0, y0, x1, y1); }

/// The relation, checked in both orders and against intersects().
Relation both_ways(const Polygon2& a, const Polygon2& b) {
  const Relation r = relate(a, b);
  CHECK(relate(b, a) == reversed(r));
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(intersects(b, a) == (r != Relation::disjoint));
  return r;
}

std::string text(const Polygon2& p) {
  std::string all;
  for (const Ring2& ring : p.rings) {
    all += " [";
    for (const Point<double, 2>& v : ring) {
      char corner[80];
      std::snprintf(corner, sizeof corner, "{%a,%a},", v[0], v[1]);
      all += corner;
    }
    all += "]";
  }
  return all;
}

template <class Change>
Polygon2 changed(Polygon2 p, const Change& change) {
  for (Ring2& ring : p.rings)
    for (Point<double, 2>& v : ring) v = change(v);
  return p;
}

/// The same set with other rings: another start, repeated vertices, another order.
Polygon2 retold(Random& random, Polygon2 p) {
  for (Ring2& ring : p.rings) {
    if (ring.empty()) continue;
    ring = bench::polygon_pairs::turned(random, ring);
    const std::size_t i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
    if (random.one_in(2)) ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i), 2, Point<double, 2>(ring[i]));
    if (random.one_in(2)) ring.push_back(ring.front());
  }
  std::reverse(p.rings.begin(), p.rings.end());
  return p;
}

}  // namespace

TEST_CASE("squares lie in all six ways", "[polygon_polygon]") {
  const Polygon2 square = {{box(0, 0, 4, 4)}};
  CHECK(both_ways(square, {{box(5, 0, 8, 4)}}) == Relation::disjoint);
  CHECK(both_ways(square, square) == Relation::equal);
  CHECK(both_ways(square, {{box(-1, -1, 5, 5)}}) == Relation::a_inside_b);
  CHECK(both_ways(square, {{box(1, 1, 3, 3)}}) == Relation::b_inside_a);
  CHECK(both_ways(square, {{box(0, 0, 3, 4)}}) == Relation::b_inside_a);
  CHECK(both_ways(square, {{box(4, 0, 8, 4)}}) == Relation::touching);
  CHECK(both_ways(square, {{box(4, 4, 8, 8)}}) == Relation::touching);
  CHECK(both_ways(square, {{box(3, 3, 8, 8)}}) == Relation::overlapping);
  CHECK(both_ways(square, {{box(-1, 1, 5, 3)}}) == Relation::overlapping);  // no corner of one lies in the other
}

TEST_CASE("a hole holds nothing, and what fills it touches", "[polygon_polygon]") {
  const Polygon2 frame = {{box(0, 0, 9, 9), box(3, 3, 6, 6)}};
  CHECK(both_ways(frame, {{box(4, 4, 5, 5)}}) == Relation::disjoint);
  CHECK(both_ways(frame, {{box(3, 3, 6, 6)}}) == Relation::touching);
  CHECK(both_ways(frame, {{box(3, 3, 5, 5)}}) == Relation::touching);
  CHECK(both_ways(frame, {{box(3, 3, 7, 6)}}) == Relation::overlapping);
  CHECK(both_ways(frame, {{box(0, 0, 9, 9)}}) == Relation::a_inside_b);
  CHECK(both_ways(frame, {{box(2, 2, 7, 7)}}) == Relation::overlapping);
  CHECK(both_ways(frame, {{box(1, 1, 2, 8)}}) == Relation::b_inside_a);
  CHECK(both_ways(frame, {{box(0, 0, 9, 9), box(2, 2, 7, 7)}}) == Relation::b_inside_a);
  CHECK(both_ways(frame, {{{{6, 3}, {6, 6}, {3, 6}, {3, 3}}, box(0, 0, 9, 9)}}) == Relation::equal);
  CHECK(both_ways(frame, {{box(0, 0, 9, 9), box(3, 3, 6, 6), box(4, 4, 5, 5)}}) == Relation::a_inside_b);
  CHECK(both_ways(frame, {{box(3, 3, 6, 6), box(-5, 0, -1, 1)}}) == Relation::touching);
  CHECK(both_ways({{box(0, 0, 9, 9), box(1, 1, 8, 8)}}, {{box(2, 2, 7, 7), box(3, 3, 6, 6)}}) == Relation::disjoint);
}

TEST_CASE("concave outlines touch, interlock and enclose", "[polygon_polygon]") {
  const Ring2 u = {{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}};
  CHECK(both_ways({{u}}, {{box(2, 2, 3, 9)}}) == Relation::disjoint);
  CHECK(both_ways({{u}}, {{box(1, 1, 4, 9)}}) == Relation::touching);
  CHECK(both_ways({{u}}, {{box(2, 1, 3, 9)}}) == Relation::touching);
  CHECK(both_ways({{u}}, {{box(2, 0, 3, 1)}}) == Relation::b_inside_a);
  CHECK(both_ways({{u}}, {{box(0, 0, 5, 5)}}) == Relation::a_inside_b);
  CHECK(both_ways({{u}}, {{box(-1, 2, 6, 3)}}) == Relation::overlapping);
  // corners on the boundary alone, and one diagonal within, the other outside
  CHECK(both_ways({{u}}, {{{{0, 5}, {1, 4}, {0, 4}}}}) == Relation::b_inside_a);
  CHECK(both_ways({{u}}, {{{{1, 5}, {4, 5}, {2, 2}}}}) == Relation::touching);
}

TEST_CASE("rings may cross themselves, part nothing and have no area", "[polygon_polygon]") {
  const Ring2 tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  CHECK(both_ways({{tie}}, {{{{0, 0}, {2, 2}, {0, 4}}, {{4, 0}, {2, 2}, {4, 4}}}}) == Relation::equal);
  CHECK(both_ways({{tie}}, {{{{1, 0}, {3, 0}, {2, 2}}}}) == Relation::touching);
  const Ring2 antenna = {{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(both_ways({{antenna}}, {{box(0, 0, 4, 4)}}) == Relation::b_inside_a);
  CHECK(both_ways({{antenna}}, {{box(6, -1, 7, 1)}}) == Relation::touching);
  CHECK(both_ways({{{{0, 0}, {4, 0}}}}, {{box(0, 0, 4, 4)}}) == Relation::a_inside_b);
  CHECK(both_ways({{{{0, 0}, {4, 0}}}}, {{{{4, 0}, {2, 0}, {0, 0}}}}) == Relation::equal);
  CHECK(both_ways({{{{1, 1}}}}, {{box(0, 0, 4, 4)}}) == Relation::a_inside_b);
  CHECK(both_ways({{{{1, 1}, {1, 1}}}}, {{{{1, 1}}}}) == Relation::equal);
  CHECK(both_ways({{{{1, 1}}}}, {{{{2, 1}}}}) == Relation::disjoint);
  CHECK(both_ways({{box(0, 0, 4, 4), {{9, 9}}}}, {{box(0, 0, 4, 4)}}) == Relation::b_inside_a);
  CHECK(both_ways({{box(0, 0, 4, 4), box(4, 0, 8, 4)}}, {{box(0, 0, 8, 4)}}) == Relation::equal);
}

TEST_CASE("polygons without a point, with NaN or infinities are disjoint", "[polygon_polygon]") {
  const Polygon2 square = {{box(0, 0, 4, 4)}};
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const Polygon2& none : {Polygon2{}, Polygon2{{{}}}, Polygon2{{box(0, 0, nan, 1)}}, Polygon2{{box(0, 0, inf, 1)}},
                               Polygon2{{box(0, 0, 1, 1), {{nan, 0}}}}}) {
    CHECK(both_ways(square, none) == Relation::disjoint);
    CHECK(relate(none, none) == Relation::disjoint);
    CHECK(relate(Segment<double, 2>{{1, 1}, {2, 2}}, none) == Relation::disjoint);
    CHECK(relate(Ray<double, 2>{{1, 1}, {2, 2}}, none) == Relation::disjoint);
    CHECK_FALSE(intersects(Segment<double, 2>{{1, 1}, {2, 2}}, none));
  }
  CHECK(relate(Segment<double, 2>{{1, nan}, {2, 2}}, square) == Relation::disjoint);
  CHECK(relate(Ray<double, 2>{{1, 1}, {inf, 2}}, square) == Relation::disjoint);
  CHECK(relate(Ray<double, 2>{{1, 1}, {1, 2}, {2, 1}}, square) == Relation::disjoint);
  CHECK(relate(Ray<double, 2>{{1, 1}, {1, 2}, {inf, inf}}, square) == Relation::disjoint);
}

TEMPLATE_TEST_CASE("a segment pierces, touches, runs along and lies within", "[polygon_polygon]", float, double) {
  using S = TestType;
  const Polygon<S, 2> frame = {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  const auto lies = [&](S px, S py, S qx, S qy) {
    const Segment<S, 2> s = {{px, py}, {qx, qy}}, back = {s.q, s.p};
    const Relation r = relate(s, frame);
    CHECK(relate(back, frame) == r);
    CHECK(intersects(s, frame) == (r != Relation::disjoint));
    return r;
  };
  CHECK(lies(-1, 1, 1, 1) == Relation::overlapping);
  CHECK(lies(-1, 5, 20, 5) == Relation::overlapping);
  CHECK(lies(1, 1, 2, 8) == Relation::a_inside_b);
  CHECK(lies(0, 0, 9, 0) == Relation::a_inside_b);
  CHECK(lies(0, 0, 3, 3) == Relation::a_inside_b);
  CHECK(lies(-1, 0, 9, 0) == Relation::touching);
  CHECK(lies(-1, 1, 1, -1) == Relation::touching);
  CHECK(lies(3, 3, 6, 6) == Relation::touching);
  CHECK(lies(3, 3, 3, 6) == Relation::a_inside_b);
  CHECK(lies(4, 4, 5, 5) == Relation::disjoint);
  CHECK(lies(4, 4, 6, 5) == Relation::touching);
  CHECK(lies(4, 4, 7, 4) == Relation::overlapping);
  CHECK(lies(10, 10, 11, 11) == Relation::disjoint);
  CHECK(lies(9, 9, 9, 9) == Relation::a_inside_b);
  CHECK(lies(4, 4, 4, 4) == Relation::disjoint);
  CHECK(relate(Segment<S, 2>{{0, 0}, {4, 4}}, Polygon<S, 2>{{{{1, 1}, {3, 3}}}}) == Relation::b_inside_a);
  CHECK(relate(Segment<S, 2>{{0, 0}, {4, 4}}, Polygon<S, 2>{{{{0, 0}, {3, 3}, {4, 4}}}}) == Relation::equal);
  CHECK(relate(Segment<S, 2>{{1, 1}, {1, 1}}, Polygon<S, 2>{{{{1, 1}}}}) == Relation::equal);

  CHECK(relate(Ray<S, 2>{{5, 5}, {1, 0}}, frame) == Relation::overlapping);
  CHECK(relate(Ray<S, 2>{{0, 0}, {0, 1}}, frame) == Relation::touching);
  CHECK(relate(Ray<S, 2>{{0, 0}, {-1, 1}, infinite<S>}, frame) == Relation::touching);
  CHECK(relate(Ray<S, 2>{{0, 1}, {-1, 1}, infinite<S>}, frame) == Relation::overlapping);
  CHECK(relate(Ray<S, 2>{{0, 0}, {1, 0}, {0, 9}}, frame) == Relation::a_inside_b);
  CHECK(relate(Ray<S, 2>{{0, 0}, {1, 0}, {9, 9}}, frame) == Relation::a_inside_b);
  CHECK(relate(Ray<S, 2>{{0, 0}, {1, 0}, {10, 12}}, frame) == Relation::disjoint);
  CHECK(relate(Ray<S, 2>{{1, 1}, {0, 0}}, frame) == Relation::a_inside_b);
  CHECK(intersects(Ray<S, 2>{{-1, 1}, {1, 0}}, frame));
  CHECK_FALSE(intersects(Ray<S, 2>{{-1, 1}, {-1, 0}}, frame));
}

TEST_CASE("two polygons: every relation is that of areas and places in rationals", "[polygon_polygon][random]") {
  std::map<Relation, int> seen;
  for (const auto& family : bench::polygon_pair_families) {
    Random random(bench::stream(tests::seed(), family.name));
    for (int i = 0; i < tests::cases(120, 8000); ++i) {
      const PolygonPair<double> c = family.draw(random);
      INFO(family.name << " " << i << text(c.a) << " and" << text(c.b));
      const Relation truth = oracle::polygon_polygon_truth(c.a, c.b).relation();
      CHECK(relate(c.a, c.b) == truth);
      CHECK(relate(c.b, c.a) == reversed(truth));
      CHECK(intersects(c.a, c.b) == (truth != Relation::disjoint));
      ++seen[truth];
    }
  }
  for (const auto& [relation, count] : seen) CHECK(count > 50);
  CHECK(seen.size() == 6);
}

TEST_CASE("what runs along a line: every relation is that of rationals", "[polygon_polygon][random]") {
  std::map<Relation, int> seen;
  for (const auto& family : bench::polygon_pair_families) {
    Random random(bench::stream(tests::seed() + 1, family.name));
    for (int i = 0; i < tests::cases(250, 8000); ++i) {
      const PolygonPair<double> c = family.draw(random);
      const auto corner = [&](const Polygon2& p) {
        const Ring2& ring = p.rings[static_cast<std::size_t>(random.below(static_cast<int>(p.rings.size())))];
        return ring[static_cast<std::size_t>(random.below(static_cast<int>(ring.size())))];
      };
      if (c.a.rings.empty() || c.b.rings.empty()) continue;
      if (c.a.rings[0].empty() || c.b.rings[0].empty()) continue;
      const Segment<double, 2> s = {corner(random.one_in(2) ? c.a : c.b), corner(random.one_in(3) ? c.a : c.b)};
      INFO(family.name << " " << i << text({{{s.p, s.q}}}) << " and" << text(c.a));
      const auto p = oracle::rational<double, 2>(s.p), q = oracle::rational<double, 2>(s.q);
      using oracle::operator-;
      if (p != q) {
        const Relation truth = oracle::line_polygon_truth(p, q - p, Rational(0), Rational(1), c.a);
        CHECK(relate(s, c.a) == truth);
        CHECK(relate(Segment<double, 2>{s.q, s.p}, c.a) == truth);
        CHECK(intersects(s, c.a) == (truth != Relation::disjoint));
        ++seen[truth];
      } else {
        CHECK((relate(s, c.a) == Relation::disjoint) == (locate(s.p, c.a) == Location::out));
      }

      Ray<double, 2> ray = {s.p, s.q};  // the other end as a direction, whatever it is
      if (random.one_in(2)) ray.direction = {double(random.integer(-2, 2)), double(random.integer(-2, 2))};
      const double ends[] = {-std::numeric_limits<double>::infinity(), -1, 0, 0.5, 1, 2,
                             std::numeric_limits<double>::infinity()};
      const int lo = random.below(6);
      ray.range = {ends[lo], ends[random.integer(std::max(lo, 1), 6)]};
      if (ray.direction == Vector<double, 2>(0, 0)) continue;
      std::optional<Rational> from, to;
      if (std::isfinite(ray.range.lo)) from = Rational(ray.range.lo);
      if (std::isfinite(ray.range.hi)) to = Rational(ray.range.hi);
      INFO("ray " << text({{{ray.origin, ray.direction}}}) << ray.range.lo << " to " << ray.range.hi);
      const Relation truth = oracle::line_polygon_truth(p, oracle::rational<double, 2>(ray.direction), from, to, c.a);
      CHECK(relate(ray, c.a) == truth);
      CHECK(intersects(ray, c.a) == (truth != Relation::disjoint));
      ++seen[truth];
    }
  }
  for (const auto& [relation, count] : seen) CHECK(count > 5);
}

TEST_CASE("how a polygon is told, axes and scale change no relation", "[polygon_polygon][property]") {
  for (const auto& family : bench::polygon_pair_families) {
    Random random(bench::stream(tests::seed() + 2, family.name));
    for (int i = 0; i < tests::cases(120, 5000); ++i) {
      const PolygonPair<double> c = family.draw(random);
      INFO(family.name << " " << i << text(c.a) << " and" << text(c.b));
      const Relation r = both_ways(c.a, c.b);
      const bool has_points =
          std::any_of(c.a.rings.begin(), c.a.rings.end(), [](const Ring2& x) { return !x.empty(); });
      CHECK(relate(c.a, c.a) == (has_points ? Relation::equal : Relation::disjoint));
      CHECK(relate(retold(random, c.a), retold(random, c.b)) == r);
      const auto swapped = [](const Point<double, 2>& v) { return Point<double, 2>(v[1], v[0]); };
      CHECK(relate(changed(c.a, swapped), changed(c.b, swapped)) == r);
      const auto mirrored = [](const Point<double, 2>& v) { return Point<double, 2>(-v[0], v[1]); };
      CHECK(relate(changed(c.a, mirrored), changed(c.b, mirrored)) == r);
      const bool exact = std::string_view("any stars boxes nested plugs shared combs spirals").find(family.name) !=
                         std::string_view::npos;
      if (!exact) continue;
      const int power = random.integer(-1000, 1000), x = random.integer(-1000, 1000), y = random.integer(-1000, 1000);
      const auto scaled = [&](const Point<double, 2>& v) {
        return Point<double, 2>(std::ldexp(v[0], power), std::ldexp(v[1], power));
      };
      const auto moved = [&](const Point<double, 2>& v) { return Point<double, 2>(v[0] + x, v[1] + y); };
      CHECK(relate(changed(c.a, scaled), changed(c.b, scaled)) == r);
      CHECK(relate(changed(c.a, moved), changed(c.b, moved)) == r);
      const auto floats = [](const Polygon2& p) {
        Polygon<float, 2> narrow;
        for (const Ring2& ring : p.rings) {
          narrow.rings.emplace_back();
          for (const Point<double, 2>& v : ring) narrow.rings.back().push_back(v.cast<float>());
        }
        return narrow;
      };
      CHECK(relate(floats(c.a), floats(c.b)) == r);
      CHECK(intersects(floats(c.a), floats(c.b)) == (r != Relation::disjoint));
    }
  }
}

TEST_CASE("a polygon of many corners is told from itself less a corner", "[polygon_polygon]") {
  Ring2 ring;
  const int n = tests::cases(2000, 200000);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = i % 2 == 0 ? 1 : 1 - 1. / n;
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const Polygon2 whole = {{ring}};
  CHECK(both_ways(whole, whole) == Relation::equal);
  Polygon2 less = whole;
  less.rings[0].erase(less.rings[0].begin());  // a tip
  CHECK(both_ways(whole, less) == Relation::b_inside_a);
  Polygon2 more = whole;
  more.rings[0].erase(more.rings[0].begin() + 1);  // a notch
  CHECK(both_ways(whole, more) == Relation::a_inside_b);
  CHECK(both_ways(less, more) == Relation::a_inside_b);
  Polygon2 hole = {{box(-2, -2, 2, 2), ring}};
  CHECK(both_ways(whole, hole) == Relation::touching);
  CHECK(both_ways(less, hole) == Relation::touching);
  CHECK(both_ways(more, hole) == Relation::overlapping);
}

}  // namespace polygon_polygon_test
