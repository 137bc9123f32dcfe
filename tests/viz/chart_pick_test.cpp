// What a pointer is told at the markers of charts.

#include "viz/chart/chart_pick.h"

#include "tests/catch.h"

namespace chart_pick_test {
using namespace isect::viz;
using isect::test::Contains;

namespace {

Plot two_methods() {
  Plot plot = {{Scale::Kind::linear, 0, 10, "time (ns). Marker: the median"},
               {Scale::Kind::linear, 0, 4, "wrong verdicts"},
               {{"*half*-B", Glyph::disc}, {"exact", Glyph::star}},
               {{"planet"}}};
  plot.panels[0].spots = {{0, 2, 3.5, 1.25}, {1, 8, 0, {}, true}};
  return plot;
}

std::vector<ChartMark> marks(const Chart& chart, const Vec2& corner = Vec2::Zero()) {
  return marks_of(chart, corner, 600, 400, window_theme(ThemeName::dark));
}

const ChartMark& told_with(const std::vector<ChartMark>& all, const std::string& words) {
  for (const ChartMark& mark : all)
    if (mark.words.find(words) != std::string::npos) return mark;
  throw std::runtime_error("nothing is told of " + words);
}

}  // namespace

TEST_CASE("a marker of a plot tells its method, its panel and both numbers", "[chart]") {
  const std::vector<ChartMark> all = marks({two_methods()});
  REQUIRE(all.size() == 2);
  const ChartMark &half = told_with(all, "half-B"), &exact = told_with(all, "exact");
  CHECK(half.words == "half-B, planet\ntime (ns): 2\nwrong verdicts: 3.5, down to 1.25");
  CHECK(exact.words == "exact, planet\ntime (ns): 8\nwrong verdicts: 0");
  CHECK(half.at.x() < exact.at.x());
  CHECK(half.at.y() < exact.at.y());
  const std::vector<ChartMark> moved = marks({two_methods()}, {30, 70});
  CHECK((told_with(moved, "exact").at - exact.at - Vec2(30, 70)).norm() < 1e-9);
}

TEST_CASE("the marker nearest to the pointer is told, with all that stand at its place", "[chart]") {
  Plot plot = two_methods();
  plot.series.push_back({"stable", Glyph::plus});
  plot.panels[0].spots.push_back({2, 8, 0, {}, true});
  const std::vector<ChartMark> all = marks({plot});
  const ChartMark &half = told_with(all, "half-B"), &exact = told_with(all, "exact");
  REQUIRE(mark_near(all, half.at + Vec2(5, -5)));
  CHECK(mark_near(all, half.at + Vec2(5, -5))->words == half.words);
  CHECK_FALSE(mark_near(all, half.at + Vec2(40, 0)));
  const std::optional<ChartMark> both = mark_near(all, exact.at);
  REQUIRE(both);
  CHECK_THAT(both->words, Contains("exact"));
  CHECK_THAT(both->words, Contains("stable"));
}

TEST_CASE("points of curves and rows of bars are told, too", "[chart]") {
  Plot plot = {{Scale::Kind::log, 1, 1000, "*n*"}, {Scale::Kind::log, 1, 1e6, "tests"}, {{"", Glyph::disc}}, {{""}}};
  plot.panels[0].curves = {{0, {{10, 100}, {100, 1e4}}, "all pairs"}};
  CHECK(told_with(marks({plot}), "n: 10\n").words == "all pairs\nn: 10\ntests: 100");

  Bars bars = {{Scale::Kind::linear, 0, 4, "measured, divided by the peer"}, {{"isect", Glyph::star, Role::hit}}, {}};
  bars.bars.push_back({"ray and ball", {{0, 1.5}}, 2.0});
  const std::vector<ChartMark> rows = marks({bars});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].words == "ray and ball, isect\nmeasured, divided by the peer: 1.5\ntarget: 2");
}

}  // namespace chart_pick_test
