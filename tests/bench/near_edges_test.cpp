#include "bench/near_edges.h"

#include <set>

#include <isect/methods/point_polygon.h>
#include "bench/maps.h"
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "bench/prose.h"
#include "tests/catch.h"
#include "tests/viz/drawn.h"

namespace near_edges_test {
using namespace isect;
using namespace isect::bench;
using isect::test::Contains;
using near_edges::Query;

namespace {

int places(const Query& q) { return near_edges::steps[static_cast<std::size_t>(q.row)]; }

/// The number of wrong answers of the method, over all rows from `from` on.
int wrong(const near_edges::Method& method, std::size_t from = 0) {
  int sum = 0;
  for (std::size_t i = from; i < method.rows.size(); ++i)
    sum += method.rows[i].outside.wrong + method.rows[i].inside.wrong;
  return sum;
}

}  // namespace

TEST_CASE("points near edges lie where they are said to, by the oracle", "[near_edges]") {
  int i = 0;
  std::set<std::pair<int, bool>> seen;
  near_edges::each_query([&](const Query& q) {
    if (++i % 16 != 0) return;
    INFO(i << ": " << q.point.transpose());
    seen.insert({q.row, q.inside});
    const Location where = oracle::location(q.point, q.ring);
    if (q.row > 0) {
      REQUIRE(where == (q.inside ? Location::in : Location::out));
      return;
    }
    REQUIRE(where == Location::on);
    const Point<double, 2> right = {q.point[0] + 0x1p-40, q.point[1]};  // beside a left edge that is inside
    REQUIRE(oracle::location(right, q.ring) == (q.inside ? Location::in : Location::out));
  });
  CHECK(seen.size() == 2 * near_edges::steps.size());
}

TEST_CASE("the rows are the first, second, ... double on either side of an edge", "[near_edges]") {
  std::vector<Query> beside;
  near_edges::each_query([&](const Query& q) {
    if (q.row > 0) beside.push_back(q);
  });
  const std::size_t rows = near_edges::steps.size() - 1;
  REQUIRE(beside.size() > 100000);
  for (std::size_t i = 0; i < beside.size(); i += 2 * rows) {
    const Query &left = beside[i], &right = beside[i + rows];
    REQUIRE(left.inside != right.inside);
    const double between = moved(left.point[0], 1);
    if (between != right.point[0]) {  // then it is on the edge
      REQUIRE(moved(between, 1) == right.point[0]);
      REQUIRE(oracle::location({between, left.point[1]}, left.ring) == Location::on);
    }
    for (std::size_t k = 0; k < rows; ++k) {
      REQUIRE(beside[i + k].point[0] == moved(left.point[0], 1 - places(beside[i + k])));
      REQUIRE(beside[i + rows + k].point[0] == moved(right.point[0], places(beside[i + k]) - 1));
    }
  }
}

TEST_CASE("near edges the exact call is never wrong, and every naive method is", "[near_edges]") {
  const std::vector<near_edges::Method>& methods = near_edges::methods();
  REQUIRE(methods.size() == 5);
  for (const near_edges::Method& method : methods) {
    INFO(method.name);
    CHECK((wrong(method) == 0) == (method.name == "exact"));
    CHECK((wrong(method, near_edges::steps.size() - 1) == 0) == (method.name == "exact"));
    for (const near_edges::Row& row : method.rows) {
      CHECK(row.outside.points + row.inside.points > 30000);
      CHECK(row.outside.points > 15000);
      CHECK(row.inside.points > 15000);
    }
  }
}

TEST_CASE("winding and multiplication say the same, for they compare the same two products", "[near_edges]") {
  int apart = 0;
  near_edges::each_query([&](const Query& q) {
    apart +=
        point_polygon::crossings_multiplied(q.point, q.ring) != (point_polygon::winding_naive(q.point, q.ring) != 0);
  });
  CHECK(apart == 0);
}

TEST_CASE("how often a method is wrong near edges is the same on every machine", "[near_edges]") {
  std::vector<int> all;
  for (const near_edges::Method& method : near_edges::methods()) {
    all.push_back(method.rows[1].outside.wrong);
    all.push_back(method.rows[1].inside.wrong);
    all.push_back(wrong(method));
  }
  CHECK(all == std::vector<int>{9155, 8954, 22909, 5630, 5499, 17568, 5674, 5528, 19195, 5630, 5499, 17568, 0, 0, 0});
}

TEST_CASE("chart, alt text and caption of the points near edges tell the counts", "[near_edges]") {
  const Plotted plotted = near_edges_chart();
  const auto& chart = std::get<viz::Mirrored>(plotted.chart.kind);
  const std::vector<near_edges::Method>& methods = near_edges::methods();
  REQUIRE(chart.panels.size() == methods.size());
  int points = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    CHECK(chart.panels[i].title == methods[i].name);
    REQUIRE(chart.panels[i].pairs.size() == chart.rows.size());
    std::string told = sentence(methods[i].name) + ": ";
    points = 0;
    for (std::size_t row = 0; row < chart.rows.size(); ++row) {
      const auto& [outside, inside] = methods[i].rows[row];
      CHECK(chart.panels[i].pairs[row].left == 100.0 * inside.wrong / inside.points);
      CHECK(chart.panels[i].pairs[row].right == 100.0 * outside.wrong / outside.points);
      told += (row > 0 ? ", " : "") + chart.rows[row] + ' ' +
              viz::percent_text(100.0 * outside.wrong / outside.points) + " and " +
              viz::percent_text(100.0 * inside.wrong / inside.points);
      points += outside.points + inside.points;
    }
    CHECK_THAT(plotted.alt, Contains(told + '.'));
  }
  CHECK_THAT(plotted.caption, Contains("wrong on none of " + count(points) + " points"));
  for (std::size_t row = 1; row < chart.rows.size(); ++row) CHECK(std::stoi(chart.rows[row]) == near_edges::steps[row]);
}

TEST_CASE("no label of the chart of points near edges meets another or is cut off", "[near_edges]") {
  using namespace isect::viz;
  for (const ThemeName name : {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark})
    for (const double width : {227.0, 340.0}) {
      const Figure figure = chart_figure(near_edges_chart().chart, name, width);
      REQUIRE(figure.labels.size() > 70);
      for (std::size_t i = 0; i < figure.labels.size(); ++i) {
        const TextBox& b = figure.labels[i].box;
        INFO(figure.labels[i].text);
        CHECK((b.left >= 0 && b.top >= 0 && b.right <= figure.drawing.width && b.bottom <= figure.drawing.height));
        for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(meet(b, figure.labels[j].box));
      }
    }
}

}  // namespace near_edges_test
