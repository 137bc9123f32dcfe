// Point location by a trapezoidal map by name, against crossings and rationals, and its costs.

#include <isect/many/trapezoid_map.h>

#include <cmath>

#include "tests/catch.h"
#include "tests/core/point_location.h"
#include "tests/settings.h"

namespace trapezoid_map_test {
using namespace isect;

namespace {

using R = Ring<double, 2>;
using P = Point<double, 2>;

template <class Event>
int count(const Record<trapezoid_map::Event>& record) {
  int n = 0;
  for (const auto& event : record.events) n += std::holds_alternative<Event>(event);
  return n;
}

}  // namespace

TEMPLATE_TEST_CASE("trapezoids locate points in, on and out of a polygon with a hole", "[trapezoid_map]", float,
                   double) {
  using S = TestType;
  const Ring<S, 2> outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  for (const bool turned : {false, true}) {
    const TrapezoidMap map =
        make_trapezoid_map(Polygon<S, 2>{{outer, turned ? Ring<S, 2>(hole.rbegin(), hole.rend()) : hole}});
    const auto both = [&](S x, S y) {
      return std::pair(locate(Point<S, 2>(x, y), map), locate(Point<S, 2>(x, y), map, FillRule::nonzero));
    };
    using enum Location;
    CHECK(both(1, 1) == std::pair(in, in));
    CHECK(both(4, 4) == std::pair(out, turned ? out : in));
    CHECK(both(3, 1) == std::pair(in, in));  // in line with an edge of the hole
    CHECK(both(6, 7) == std::pair(in, in));
    for (const auto& [x, y] : {std::pair<S, S>{0, 0}, {9, 9}, {3, 3}, {4, 3}, {6, 6}, {5, 6}, {9, 4}, {0, 3}, {3, 4}})
      CHECK(both(x, y) == std::pair(on, on));
    for (const auto& [x, y] : {std::pair<S, S>{-1, 0}, {10, 0}, {-1, 3}, {0, 10}, {4, -1}, {4, 10}, {9, -1}, {3, 10}})
      CHECK(both(x, y) == std::pair(out, out));
    CHECK(both(std::nextafter(S(9), S(10)), 4) == std::pair(out, out));
    CHECK(both(std::nextafter(S(9), S(8)), 4) == std::pair(in, in));
  }
}

TEST_CASE("trapezoids take degenerate rings, and NaN and infinity meet nothing", "[trapezoid_map]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = infinite<double>.hi;
  CHECK(locate(P(0, 0), make_trapezoid_map(Polygon<double, 2>{})) == Location::out);
  CHECK(locate(P(0, 0), make_trapezoid_map(R{})) == Location::out);
  CHECK(locate(P(1, 2), make_trapezoid_map(R{{1, 2}})) == Location::on);
  CHECK(locate(P(1, 2), make_trapezoid_map(R{{1, 2}, {1, 2}})) == Location::on);
  CHECK(locate(P(1, 1), make_trapezoid_map(R{{0, 0}, {2, 2}})) == Location::on);
  CHECK(locate(P(0, 1), make_trapezoid_map(R{{0, 0}, {0, 2}})) == Location::on);
  CHECK(locate(P(0, 3), make_trapezoid_map(R{{0, 0}, {0, 2}})) == Location::out);
  CHECK(locate(P(-0.0, 0), make_trapezoid_map(R{{0.0, -0.0}})) == Location::on);
  const R square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (const double bad : {nan, inf, -inf})
    for (int axis = 0; axis < 2; ++axis) {
      P p = {1, 1};
      p[axis] = bad;
      CHECK(locate(p, make_trapezoid_map(square)) == Location::out);
      R broken = square;
      broken[2][axis] = bad;
      CHECK(locate(P(1, 1), make_trapezoid_map(broken)) == Location::out);
      CHECK(locate(P(1, 0), make_trapezoid_map(broken)) == Location::out);
    }
}

TEST_CASE("trapezoids refuse edges that cross without a vertex", "[trapezoid_map]") {
  CHECK_THROWS_WITH(make_trapezoid_map(R{{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                    "edge 0 of ring 0 and edge 2 of ring 0 cross where there is no vertex");
}

TEMPLATE_TEST_CASE("trapezoids agree with crossings and rationals", "[trapezoid_map]", float, double) {
  using S = TestType;
  INFO("seed " << tests::seed());
  std::uint64_t order = 0;
  const tests::Agreement tally =
      tests::agreement<S>(tests::seed(), tests::cases(100, 15000),
                          [&](const Polygon<S, 2>& polygon) { return make_trapezoid_map(polygon, ++order); });
  CHECK(tally.wrong == 0);
  const int all = tally.in + tally.on + tally.out;
  for (const int count : {tally.in, tally.on, tally.out}) CHECK(count > all / 20);
  CHECK(tally.rules_differ > all / 1000);
  CHECK(tally.refused > 50);
}

TEST_CASE("every order of the edges gives trapezoids that tile the plane", "[trapezoid_map]") {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(300, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const tests::Rings<double> rings = tests::cells<double>(random, 3, random.below(9));
    if (tests::cross_apart_from_vertices(rings)) continue;
    const TrapezoidMap map = make_trapezoid_map(Polygon<double, 2>{rings}, random.bits());
    const std::size_t n = map.boundary.pieces.size();
    REQUIRE(map.trapezoids.size() <= 3 * n + 1);
    std::vector<int> reached(map.trapezoids.size());
    for (const auto& node : map.nodes) reached[node.index] += node.ask == TrapezoidMap::Ask::nothing;
    for (std::size_t t = 0; t < map.trapezoids.size(); ++t) {
      const TrapezoidMap::Trapezoid& trapezoid = map.trapezoids[t];
      if (reached[t] != 1) continue;  // a place that is free again
      REQUIRE(trapezoid.left < trapezoid.right);
      const int top =
          trapezoid.top < 0 ? 0 : map.boundary.pieces[trapezoid.top].above - map.boundary.pieces[trapezoid.top].times;
      REQUIRE(map.winding(trapezoid) == top);  // the winding number below its top is that above its bottom
    }
  }
}

TEST_CASE("a query asks O(log n) questions, and the map takes O(n) space", "[trapezoid_map]") {
  bench::Random random(tests::seed());
  for (const bool spiky : {false, true})
    for (const int n : {10, 100, 1000, 10000, tests::cases(10000, 100000)}) {
      INFO("seed " << tests::seed() << ", n " << n << ", spiky " << spiky);
      const R ring = tests::around(random, n, spiky);
      Record<trapezoid_map::BuildEvent> built;
      const TrapezoidMap map = make_trapezoid_map(ring, tests::seed(), built);
      REQUIRE(built.events.size() == map.boundary.pieces.size());
      double cut = 0;
      for (const auto& event : built.events) cut += std::get<trapezoid_map::Inserted>(event).cut;

      double sum = 0, most = 0;
      const int queries = 4000;
      for (int i = 0; i < queries; ++i) {
        P p = random.in_box<2>(1);
        if (i % 4 == 0) p[0] = ring[random.below(n)][0];
        Record<trapezoid_map::Event> record;
        const Location l = locate(p, map, FillRule::even_odd, record);
        if (i < 1000 && l != locate(p, ring)) REQUIRE(l == locate(p, ring));
        const double asked = count<trapezoid_map::VertexAsked>(record) + count<trapezoid_map::PieceAsked>(record);
        sum += asked, most = std::max(most, asked);
      }
      // expected at most 5 ln(n + 1) each (de Berg et al., lemma 6.3): 3.47 lg n
      CHECK(sum / queries < 3.47 * std::log2(n + 1));
      CHECK(most < 8 * std::log2(n + 1));
      CHECK(cut < 6. * n);
      CHECK(static_cast<double>(map.trapezoids.size()) <= 3. * n + 1);
      CHECK(static_cast<double>(map.nodes.size()) < 12. * n);
      if (tests::long_run())
        WARN("n " << n << ": " << sum / queries / std::log2(n) << " lg n, most " << most / std::log2(n) << " lg n, cut "
                  << cut / n << " n, nodes " << double(map.nodes.size()) / n << " n, bytes " << double(map.bytes()) / n
                  << " n");
    }
}

TEST_CASE(
    "a map whose pieces are added in any order answers alike, and a path of one added from left to right may ask n "
    "questions",
    "[trapezoid_map]") {
  bench::Random random(tests::seed());
  const R ring = tests::around(random, 200, true);
  PolygonPieces pieces = make_polygon_pieces(std::span<const R>(&ring, 1));
  std::vector<int> order(pieces.pieces.size());
  std::iota(order.begin(), order.end(), 0);
  const TrapezoidMap sorted = make_trapezoid_map_in_order(pieces, order);
  std::reverse(order.begin(), order.end());
  const TrapezoidMap reversed = make_trapezoid_map_in_order(pieces, order), any = make_trapezoid_map(ring);
  for (int i = 0; i < 2000; ++i) {
    const P p = random.in_box<2>(1);
    const Location l = locate(p, ring);
    if (l != locate(p, sorted) || l != locate(p, reversed) || l != locate(p, any)) REQUIRE(l == locate(p, sorted));
  }
  CHECK(depth(sorted) > 2 * depth(any));
  CHECK(depth(any) < 8 * std::log2(order.size()));
  CHECK(depth(make_trapezoid_map(R{{0, 0}, {4, 1}, {0, 2}})) >= 3);
  CHECK(depth(TrapezoidMap{}) == 0);
}

TEST_CASE("the events of trapezoids tell the questions", "[trapezoid_map]") {
  const TrapezoidMap map = make_trapezoid_map(R{{0, 0}, {4, 1}, {0, 2}});
  Record<trapezoid_map::Event> record;
  CHECK(winding(P(1, 1), map, record) == 1);
  REQUIRE(record.events.size() >= 3);
  CHECK(count<trapezoid_map::Reached>(record) == 1);
  const auto& reached = std::get<trapezoid_map::Reached>(record.events.back());
  const TrapezoidMap::Trapezoid& t = map.trapezoids[reached.trapezoid];
  CHECK(map.boundary.pieces[t.bottom].edge == PolygonEdge{0, 0});
  CHECK(map.boundary.pieces[t.top].edge == PolygonEdge{0, 1});
  CHECK(winding(P(4, 1), map) == std::nullopt);
}

}  // namespace trapezoid_map_test
