// Point location by slabs by name, against crossings and rationals, and its costs.

#include <isect/many/slab_map.h>

#include <cmath>

#include "tests/catch.h"
#include "tests/core/point_location.h"
#include "tests/settings.h"

namespace slab_map_test {
using namespace isect;

namespace {

using R = Ring<double, 2>;
using P = Point<double, 2>;

}  // namespace

TEMPLATE_TEST_CASE("slabs locate points in, on and out of a polygon with a hole", "[slab_map]", float, double) {
  using S = TestType;
  const Ring<S, 2> outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  for (const bool turned : {false, true}) {
    const SlabMap map = make_slab_map(Polygon<S, 2>{{outer, turned ? Ring<S, 2>(hole.rbegin(), hole.rend()) : hole}});
    const auto both = [&](S x, S y) {
      return std::pair(locate(Point<S, 2>(x, y), map), locate(Point<S, 2>(x, y), map, FillRule::nonzero));
    };
    using enum Location;
    CHECK(both(1, 1) == std::pair(in, in));
    CHECK(both(4, 4) == std::pair(out, turned ? out : in));
    CHECK(both(1, 3) == std::pair(in, in));  // in line with an edge of the hole
    CHECK(both(7, 6) == std::pair(in, in));
    for (const auto& [x, y] : {std::pair<S, S>{0, 0}, {9, 9}, {3, 3}, {4, 3}, {6, 6}, {5, 6}, {9, 4}, {0, 3}, {3, 4}})
      CHECK(both(x, y) == std::pair(on, on));
    for (const auto& [x, y] : {std::pair<S, S>{-1, 0}, {10, 0}, {-1, 3}, {10, 6}, {4, -1}, {4, 10}, {10, 9}, {-1, 9}})
      CHECK(both(x, y) == std::pair(out, out));
    CHECK(both(std::nextafter(S(9), S(10)), 4) == std::pair(out, out));
    CHECK(both(std::nextafter(S(9), S(8)), 4) == std::pair(in, in));
  }
}

TEST_CASE("slabs take degenerate rings, and NaN and infinity meet nothing", "[slab_map]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = infinite<double>.hi;
  CHECK(locate(P(0, 0), make_slab_map(Polygon<double, 2>{})) == Location::out);
  CHECK(locate(P(0, 0), make_slab_map(R{})) == Location::out);
  CHECK(locate(P(1, 2), make_slab_map(R{{1, 2}})) == Location::on);
  CHECK(locate(P(1, 2), make_slab_map(R{{1, 2}, {1, 2}})) == Location::on);
  CHECK(locate(P(1, 1), make_slab_map(R{{0, 0}, {2, 2}})) == Location::on);
  CHECK(locate(P(1, 0), make_slab_map(R{{0, 0}, {2, 0}})) == Location::on);
  CHECK(locate(P(3, 0), make_slab_map(R{{0, 0}, {2, 0}})) == Location::out);
  CHECK(locate(P(-0.0, 0), make_slab_map(R{{0.0, -0.0}})) == Location::on);
  const R square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (const double bad : {nan, inf, -inf})
    for (int axis = 0; axis < 2; ++axis) {
      P p = {1, 1};
      p[axis] = bad;
      CHECK(locate(p, make_slab_map(square)) == Location::out);
      R broken = square;
      broken[2][axis] = bad;
      CHECK(locate(P(1, 1), make_slab_map(broken)) == Location::out);
      CHECK(locate(P(1, 0), make_slab_map(broken)) == Location::out);
    }
}

TEST_CASE("an edge one ulp beside another keeps its place", "[slab_map]") {
  // from (0, 0) up to points one ulp apart, and back: the middles of neighbours are the same number
  R fan = {{0, 0}};
  double x = 1;
  for (int i = 0; i < 12; ++i, x = std::nextafter(x, 2)) fan.insert(fan.end(), {{x, 1}, {x / 2, 0.5}, {0, 0}});
  const SlabMap map = make_slab_map(fan);
  x = 1;
  for (int i = 0; i < 12; ++i, x = std::nextafter(x, 2)) {
    CHECK(locate(P(x, 1), map) == Location::on);
    CHECK(locate(P(x / 2, 0.5), map) == Location::on);
    CHECK(locate(P(x / 4, 0.25), map) == Location::on);
  }
  CHECK(winding(P(0.5, std::nextafter(0.5, 0)), map) == 0);
}

TEMPLATE_TEST_CASE("slabs agree with crossings and rationals", "[slab_map]", float, double) {
  using S = TestType;
  INFO("seed " << tests::seed());
  const tests::Agreement tally = tests::agreement<S>(
      tests::seed(), tests::cases(100, 15000), [](const Polygon<S, 2>& polygon) { return make_slab_map(polygon); });
  CHECK(tally.wrong == 0);
  const int all = tally.in + tally.on + tally.out;
  for (const int count : {tally.in, tally.on, tally.out}) CHECK(count > all / 20);
  CHECK(tally.rules_differ > all / 1000);
  CHECK(tally.refused > 50);
}

TEST_CASE("a query takes three bisections at most, and slabs up to n^2/4 entries", "[slab_map]") {
  bench::Random random(tests::seed());
  for (const bool spiky : {false, true})
    for (const int n : {10, 100, 1000, tests::cases(2000, 10000)}) {
      INFO("seed " << tests::seed() << ", n " << n);
      const R ring = tests::around(random, n, spiky);
      const SlabMap map = make_slab_map(ring);
      for (int i = 0; i < 2000; ++i) {
        P p = random.in_box<2>(1);
        if (i % 4 == 0) p[1] = ring[random.below(n)][1];
        Record<slab_map::Event> record;
        const Location l = locate(p, map, FillRule::even_odd, record);
        if (l != locate(p, ring)) REQUIRE(l == locate(p, ring));
        double comparisons = 0;
        for (const auto& event : record.events) {
          if (const auto* slab = std::get_if<slab_map::SlabFound>(&event)) comparisons += slab->steps;
          if (const auto* line = std::get_if<slab_map::OnLine>(&event)) comparisons += line->steps;
          comparisons += std::holds_alternative<slab_map::Compared>(event);
        }
        if (!(comparisons <= 3 * (1 + std::log2(n + 1)))) REQUIRE(comparisons <= 3 * (1 + std::log2(n + 1)));
      }
      CHECK(map.order.size() <= static_cast<std::size_t>(n) * static_cast<std::size_t>(n) / 2);
      CHECK(map.order.capacity() == map.order.size());  // as foreseen
      if (spiky && n >= 1000) CHECK(static_cast<double>(map.order.size()) > 0.05 * n * n);
    }
}

TEST_CASE("more memory than allowed is refused before it is taken", "[slab_map]") {
  bench::Random random(tests::seed());
  const R ring = tests::around(random, 1000, true);
  const std::size_t bytes = make_slab_map(ring).bytes();
  CHECK(make_slab_map(ring, bytes).bytes() == bytes);
  CHECK_THROWS_AS(make_slab_map(ring, bytes - 1), std::length_error);
  CHECK_THROWS_WITH(make_slab_map(ring, 1000),
                    "the slabs would take " + std::to_string(bytes) + " bytes, the limit is 1000");
  CHECK_THROWS_AS(make_slab_map(R{{0, 0}, {2, 2}, {2, 0}, {0, 2}}), std::invalid_argument);
}

TEST_CASE("the events of slabs tell the slab and the edges", "[slab_map]") {
  const SlabMap map = make_slab_map(R{{0, 0}, {4, 0}, {4, 2}, {2, 1}, {0, 2}});
  Record<slab_map::Event> record;
  CHECK(winding(P(3, 1), map, record) == 1);
  REQUIRE(record.events.size() == 4);
  CHECK(std::get<slab_map::SlabFound>(record.events[0]).slab == 1);
  CHECK_FALSE(std::get<slab_map::OnLine>(record.events[1]).holds);
  CHECK(std::get<slab_map::Compared>(record.events[2]).turn == -1);
  CHECK(std::get<slab_map::Compared>(record.events[3]).turn == 1);
  CHECK(map.edges[1].source == PolygonEdge{0, 1});
}

}  // namespace slab_map_test
