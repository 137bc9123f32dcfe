// Point location by a grid by name, against crossings and rationals, and its costs.

#include <isect/many/polygon_grid.h>

#include <cmath>

#include "tests/catch.h"
#include "tests/core/point_location.h"
#include "tests/settings.h"

namespace polygon_grid_test {
using namespace isect;

namespace {

using R = Ring<double, 2>;
using P = Point<double, 2>;

/// The sum of many small rings, edges and bow-ties: enough of them for a grid of many cells.
template <class S>
tests::Rings<S> crowd(bench::Random& random, bench::Numbers numbers) {
  tests::Rings<S> rings;
  const int n = 1 + random.below(12);
  for (int i = 0; i < n; ++i)
    for (Ring<S, 2>& r : tests::random_rings<S>(random, numbers)) rings.push_back(std::move(r));
  return rings;
}

}  // namespace

TEMPLATE_TEST_CASE("a grid locates points in, on and out of polygons that cross themselves", "[polygon_grid]", float,
                   double) {
  using S = TestType;
  const Ring<S, 2> bow_tie = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const PolygonGrid grid = make_polygon_grid(bow_tie);
  CHECK(winding(Point<S, 2>(S(0.5), 1), grid) == 1);
  CHECK(winding(Point<S, 2>(S(1.5), 1), grid) == -1);
  CHECK(winding(Point<S, 2>(1, S(0.5)), grid) == 0);
  for (const auto& [x, y] : {std::pair<S, S>{1, 1}, {0, 0}, {2, 2}, {2, 1}, {0, 1}})
    CHECK(locate(Point<S, 2>(x, y), grid) == Location::on);

  const Ring<S, 2> outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  const PolygonGrid holed = make_polygon_grid(Polygon<S, 2>{{outer, hole}});
  CHECK(locate(Point<S, 2>(4, 4), holed) == Location::out);
  CHECK(locate(Point<S, 2>(4, 4), holed, FillRule::nonzero) == Location::in);
  CHECK(locate(Point<S, 2>(4, 3), holed) == Location::on);
  CHECK(locate(Point<S, 2>(4, std::nextafter(S(3), S(0))), holed) == Location::in);
  CHECK(locate(Point<S, 2>(std::nextafter(S(9), S(10)), 4), holed) == Location::out);
}

TEST_CASE("a grid takes degenerate rings, and NaN and infinity meet nothing", "[polygon_grid]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = infinite<double>.hi;
  CHECK(locate(P(0, 0), make_polygon_grid(Polygon<double, 2>{})) == Location::out);
  CHECK(locate(P(0, 0), make_polygon_grid(R{})) == Location::out);
  CHECK(locate(P(1, 2), make_polygon_grid(R{{1, 2}})) == Location::on);
  CHECK(locate(P(1, 2), make_polygon_grid(R{{1, 2}, {1, 2}})) == Location::on);
  CHECK(locate(P(1, 0), make_polygon_grid(R{{0, 0}, {2, 0}})) == Location::on);
  CHECK(locate(P(3, 0), make_polygon_grid(R{{0, 0}, {2, 0}})) == Location::out);
  CHECK(locate(P(-0.0, 0), make_polygon_grid(R{{0.0, -0.0}})) == Location::on);
  const R square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (const double bad : {nan, inf, -inf})
    for (int axis = 0; axis < 2; ++axis) {
      P p = {1, 1};
      p[axis] = bad;
      CHECK(locate(p, make_polygon_grid(square)) == Location::out);
      R broken = square;
      broken[2][axis] = bad;
      CHECK(locate(P(1, 1), make_polygon_grid(broken)) == Location::out);
      CHECK(locate(P(1, 0), make_polygon_grid(broken)) == Location::out);
    }
  const double most = std::numeric_limits<double>::max();
  const R largest = {{-most, -most}, {most, -most}, {most, most}, {-most, most}};
  CHECK(locate(P(0, 0), make_polygon_grid(largest)) == Location::in);
  CHECK(locate(P(-most, 0), make_polygon_grid(largest)) == Location::on);
}

TEMPLATE_TEST_CASE("a grid agrees with crossings and rationals, whatever crosses", "[polygon_grid]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[3] = {}, with_edges = 0, differ = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(60, 2500); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      const tests::Rings<S> rings = crowd<S>(random, numbers);
      const Polygon<S, 2> polygon{rings};
      const PolygonGrid grid = make_polygon_grid(polygon);
      for (int k = 0; k < 30; ++k) {
        Point<S, 2> p = tests::random_point(random, numbers, rings);
        if (random.one_in(8) && !grid.cells.empty())  // on a line of the grid
          p[0] = static_cast<S>(grid.axes[0].line(random.below(grid.axes[0].cells)));
        if (random.one_in(8) && !grid.cells.empty())
          p[1] = static_cast<S>(grid.axes[1].line(random.below(grid.axes[1].cells)));
        const Winding truth = winding(p, polygon);
        Record<polygon_grid::Event> record;
        const std::optional<int> w = winding(p, grid), traced = winding(p, grid, record);
        const bool on = truth.even_odd == Location::on;
        if (on ? w.has_value() : w != truth.winding) REQUIRE(w == truth.winding);
        if (k == 0 && w != tests::true_winding(random, p, rings)) REQUIRE(w == tests::true_winding(random, p, rings));
        REQUIRE(traced == w);
        if (locate(p, grid) != truth.even_odd || locate(p, grid, FillRule::nonzero) != truth.nonzero)
          REQUIRE(locate(p, grid) == truth.even_odd);
        ++counts[static_cast<int>(truth.even_odd)];
        differ += truth.even_odd != truth.nonzero;
        if (!record.events.empty()) {
          const auto& cell = std::get<polygon_grid::CellFound>(record.events[0]);
          with_edges += cell.column > 0 && cell.row > 0 && cell.edges > 0;
        }
      }
    }
  const int all = counts[0] + counts[1] + counts[2];
  for (const int count : counts) CHECK(count > all / 20);
  CHECK(with_edges > all / 20);
  CHECK(differ > all / 200);
}

TEST_CASE("a grid takes O(n) memory, and few edges stand in its cells", "[polygon_grid]") {
  bench::Random random(tests::seed());
  for (const bool spiky : {false, true})
    for (const int n : {10, 100, 1000, 10000, tests::cases(10000, 1000000)}) {
      INFO("seed " << tests::seed() << ", n " << n << ", spiky " << spiky);
      const R ring = tests::around(random, n, spiky);
      const PolygonGrid grid = make_polygon_grid(ring);
      // 16 for a vertex, 8 for each of 4 n cells, 4 for each of 12 n entries, and 64 more of each
      CHECK(grid.bytes() < 16u * (static_cast<std::size_t>(n) + 1) + 96u * (static_cast<std::size_t>(n) + 65));
      double edges = 0;
      for (int i = 0; i < 2000; ++i) {
        const P p = random.in_box<2>(1);
        Record<polygon_grid::Event> record;
        const Location l = locate(p, grid, FillRule::even_odd, record);
        if ((n < 100000 || i < 20) && l != locate(p, ring)) REQUIRE(l == locate(p, ring));
        if (!record.events.empty()) edges += std::get<polygon_grid::CellFound>(record.events[0]).edges;
      }
      CHECK(edges / 2000 < (spiky ? 10 + n / 100. : 4));
    }
}

TEST_CASE("the events of a grid tell the cell and the crossed edges", "[polygon_grid]") {
  const PolygonGrid grid = make_polygon_grid(R{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  Record<polygon_grid::Event> record;
  CHECK(winding(P(1e-9, 2), grid, record) == 1);
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<polygon_grid::CellFound>(record.events[0]).winding == 0);
  CHECK(std::get<polygon_grid::Crossed>(record.events[1]).vertex == 3);
  CHECK(std::get<polygon_grid::Crossed>(record.events[1]).change == 1);
}

}  // namespace polygon_grid_test
