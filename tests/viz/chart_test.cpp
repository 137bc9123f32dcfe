#include "viz/chart/chart.h"
#include "viz/chart/chart_parts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/catch.h"
#include "tests/viz/drawn.h"
#include "viz/formats/files.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace chart_test {
using namespace isect::viz;

namespace {

const ThemeName all_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark};

/// Methods that tie, differ by little and by much, over `count` families.
Chart race(int count) {
  const char* families[] = {"ordinary",         "near tangent", "far small", "exact tangent",
                            "direction length", "on surface",   "planet",    "zero radius"};
  Plot plot = {{Scale::Kind::log, 2, 9000, "time per call (ns). Marker: 99th percentile; bar: down to the median"},
               {Scale::Kind::linear, 0, 28, "log_2(1 + error in ulp)"},
               {{"textbook quadratic", Glyph::square},
                {"half-B", Glyph::diamond},
                {"Haines", Glyph::triangle},
                {"stable roots", Glyph::disc},
                {"CGAL: do_intersect", Glyph::saltire},
                {"exact", Glyph::star}},
               {}};
  for (int i = 0; i < count; ++i) {
    Panel panel = {families[i], i > 0 ? "hard" : ""};
    panel.spots = {{0, 3, 12.0 + i, 4}, {1, 3, 12.0 + i, 4}, {2, 2.9, 11, 3, true},
                   {3, 4, 5, 2, true},  {4, 60, 0, 0},       {5, 5.0 + 900 * i, 0, 0, true}};
    plot.panels.push_back(panel);
  }
  return {plot};
}

Chart growth() {
  Plot plot = {{Scale::Kind::log, 90, 1.1e6, "number of elements *n*"},
               {Scale::Kind::log, 5, 1e9, "time (ns)"},
               {},
               {{"all pairs"}}};
  for (int k = 0; k < 5; ++k) {
    plot.series.push_back({"", Glyph::disc, Role::first, k});
    Curve curve = {k, {}, "method " + std::to_string(k) + ", *n*^{1.0}"};
    for (const double n : {1e2, 1e3, 1e4, 1e5, 1e6}) curve.points.emplace_back(n, 10 * n * (1 + 0.02 * k));
    plot.panels[0].curves.push_back(curve);
  }
  return {plot};
}

Chart rows() {
  Bars bars = {{Scale::Kind::log, 0.05, 20, "measured, divided by the peer"}, {{"isect", Glyph::star, Role::hit}}, {}};
  for (int i = 0; i < 9; ++i)
    bars.bars.push_back({"a piece of work with a long name, number " + std::to_string(i),
                         {{0, 0.1 * (i + 1)}},
                         0.4,
                         "0.4 of it",
                         i < 4 ? Verdict::Kind::yes : Verdict::Kind::no});
  return {bars};
}

Map stripes(int columns, int rows) {
  Map map = {"stripes and dots", "12.5 % wrong", columns, rows, {}};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) map.cells.push_back(static_cast<unsigned char>((x * x + 3 * y + x * y / 3) % 5));
  return map;
}
Chart maps(int count) {
  Maps chart = {{{"left", Tone::first},
                 {"right", Tone::second},
                 {"on", Tone::on},
                 {"called on, is not", Tone::mild},
                 {"called a wrong side", Tone::wrong}},
                {},
                "cell: **p** moved by *i u* and *j u*, *u* = 2^{−53}"};
  for (int i = 0; i < count; ++i) chart.maps.push_back(stripes(16, 16));
  return {chart};
}

Chart mirrored(int count) {
  Mirrored chart;
  chart.rows = {"on it", "1st", "16th"};
  chart.apart = 1;
  chart.rows_title = "which double";
  chart.kinds = {std::pair("called outside, is in", Tone::wrong), std::pair("called inside, is out", Tone::mild)};
  for (int i = 0; i < count; ++i)
    chart.panels.push_back({"multiplication", {{100, 0.004}, {20, 10}, {0, 99.0 / (i + 1)}}});
  chart.below = "in % of the points";
  return {chart};
}

/// One panel with these spots, drawn as on paper.
std::vector<Shape> drawn(const std::vector<Spot>& spots, int series) {
  Plot plot = {{Scale::Kind::log, 1, 100, ""}, {Scale::Kind::linear, 0, 10, ""}, {}, {{"panel", "", spots}}};
  plot.series.assign(static_cast<std::size_t>(series), {"", Glyph::disc});
  return chart_figure({plot}, ThemeName::print, 227).drawing.shapes;
}

/// The middles of the discs in the order drawn.
std::vector<Vec2> discs(const std::vector<Shape>& shapes) {
  std::vector<Vec2> middles;
  for (const Fill& fill : all<Fill>(shapes))
    if (fill.path.segments.size() == 4 && std::holds_alternative<Path::Cubic>(fill.path.segments[0])) {
      const std::vector<Vec2> rim = flatten(fill.path);
      Vec2 sum = Vec2::Zero();
      for (const Vec2& p : rim) sum += p;
      middles.emplace_back(sum / static_cast<double>(rim.size()));
    }
  return middles;
}

}  // namespace

TEST_CASE("no label of a chart meets another or leaves the picture, on any theme at any width", "[chart]") {
  const Chart charts[] = {race(1), race(4), race(8), growth(),    rows(),
                          maps(1), maps(2), maps(9), mirrored(1), mirrored(5)};
  for (const Chart& chart : charts)
    for (const ThemeName name : all_themes)
      for (const double width : {227.0, 340.0, 960.0}) {
        const Figure figure = chart_figure(chart, name, width);
        REQUIRE(figure.labels.size() > 3);
        for (std::size_t i = 0; i < figure.labels.size(); ++i) {
          const TextBox& b = figure.labels[i].box;
          INFO(figure.labels[i].text << " at " << b.left << ' ' << b.top << " of " << figure.drawing.width << " x "
                                     << figure.drawing.height);
          CHECK((b.left >= 0 && b.top >= 0 && b.right <= figure.drawing.width && b.bottom <= figure.drawing.height));
          for (std::size_t j = 0; j < i; ++j) {
            INFO(figure.labels[j].text);
            CHECK_FALSE(meet(b, figure.labels[j].box));
          }
        }
      }
}

TEST_CASE("the interval of a row ends at its two values", "[chart]") {
  Bars bars = {{Scale::Kind::log, 0.1, 10, ""}, {{"", Glyph::disc, Role::hit}}, {{"row", {{0, 1.0}}}}};
  const auto strokes = [&] { return all<Stroke>(chart_figure({bars}, ThemeName::print, 340).drawing.shapes); };
  const std::size_t without = strokes().size();
  bars.bars[0].interval = {0.1, 10};
  const std::vector<Stroke> with = strokes();
  REQUIRE(with.size() >= without + 3);
  const auto points = [](const Stroke& s) { return flatten(s.path); };
  // the row's own line reaches from end to end, and so does an interval over the whole scale
  const auto as_long = [&](const Stroke& s) {
    return points(s).front().x() == points(with[0]).front().x() && points(s).back().x() == points(with[0]).back().x();
  };
  CHECK(std::ranges::count_if(with, as_long) >= 2);
}

TEST_CASE("the text of a chart at 8 cm is never smaller than 6 pt", "[chart]") {
  for (const Chart& chart : {race(8), growth(), rows(), maps(9), mirrored(5)})
    for (const Text& text : all<Text>(chart_figure(chart, ThemeName::print, 227).drawing.shapes)) CHECK(text.size >= 6);
}

TEST_CASE("the same chart gives the same bytes", "[chart]") {
  for (const Chart& chart : {race(4), rows(), maps(2), mirrored(2)})
    CHECK(svg(chart_figure(chart, ThemeName::grey, 227).drawing) ==
          svg(chart_figure(chart, ThemeName::grey, 227).drawing));
}

TEST_CASE("numbers at an axis go by 1, 2 or 5, and are eleven at most", "[chart]") {
  const ChartInk ink(window_theme(ThemeName::screen));
  for (const double top : {0.7, 1.0, 5.1, 9.0, 26.0, 130.0})
    for (double height = 120; height < 2000; height *= 1.3) {
      const Scale scale{Scale::Kind::linear, 0, top, "", {}};
      const auto ticks = ScaleLine(scale, height, 0).ticks(ink, false);
      INFO(top << " over " << height << " px: " << ticks.size());
      REQUIRE(ticks.size() >= 2);
      CHECK(ticks.size() <= 11);
      const double step = ticks[1].first - ticks[0].first;
      const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
      CHECK((std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6));
    }
}

TEST_CASE("a plot without a panel is drawn, if with nothing in it", "[chart]") {
  const Chart empty = race(0);
  CHECK_FALSE(svg(chart_figure(empty, ThemeName::print, 340).drawing).empty());
}

TEST_CASE("the front holds what nothing beats, ties included", "[chart]") {
  const std::vector<bool> front = pareto_front({{1, 5}, {2, 5}, {3, 1}, {3, 1}, {4, 2}, {NAN, 0}, {9, 0.5}});
  CHECK(front == std::vector<bool>{true, false, true, true, false, false, true});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("markers that tie stand at their data, each smaller than the one before, and their whiskers stay true",
          "[chart]") {
  const std::vector<Spot> spots = {{0, 10, 5, 2}, {1, 10, 5, 1}, {2, 10, 5, 3}, {3, 50, 5}};
  const std::vector<Shape> shapes = drawn(spots, 4);
  std::vector<Vec2> at;
  std::vector<double> radii;
  for (const Stroke& stroke : all<Stroke>(shapes))
    if (stroke.path.closed) {  // a rim, and the halo below it
      const std::vector<Vec2> rim = flatten(stroke.path);
      Vec2 sum = Vec2::Zero();
      for (const Vec2& p : rim) sum += p;
      at.emplace_back(sum / static_cast<double>(rim.size()));
      radii.push_back((rim.front() - at.back()).norm());
    }
  REQUIRE(at.size() == 8);
  const auto same = [](const Vec2& p, const Vec2& q) { return (p - q).norm() < 0.01; };
  const Vec2 alone = *std::ranges::max_element(at, {}, [](const Vec2& p) { return p.x(); });
  const Vec2 tied = *std::ranges::min_element(at, {}, [](const Vec2& p) { return p.x(); });
  std::set<double> sizes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    CHECK((same(at[i], alone) || same(at[i], tied)));
    if (same(at[i], tied)) sizes.insert(std::round(1e3 * radii[i]));
  }
  CHECK(sizes.size() == 3);

  std::set<double> whiskers;  // upright strokes below
  for (const Stroke& stroke : all<Stroke>(shapes)) {
    const std::vector<Vec2> p = flatten(stroke.path);
    if (p.size() == 2 && p[0].x() == p[1].x() && std::abs(p[0].x() - tied.x()) < 0.01 && p[0].y() - tied.y() < 3 &&
        p[1].y() > p[0].y() + 1)
      whiskers.insert(p[1].y());
  }
  CHECK(whiskers.size() == 3);
}

TEST_CASE("markers that meet are named beside, each with a leader", "[chart]") {
  const Plot plot = {{Scale::Kind::log, 1, 100, ""},
                     {Scale::Kind::linear, 0, 10, ""},
                     {{"one", Glyph::disc}, {"two", Glyph::square}, {"three", Glyph::star}},
                     {{"panel", "", {{0, 10, 5}, {1, 10.2, 5}, {2, 60, 5}}}}};
  const Figure figure = chart_figure({plot}, ThemeName::print, 227);
  std::set<std::string> led;
  for (const PlacedLabel& label : figure.labels)
    if (label.leads_to) led.insert(label.text);
  CHECK(led == std::set<std::string>{"one", "two"});
}

TEST_CASE("the steps of the front go through its markers", "[chart]") {
  const std::vector<Shape> shapes = drawn({{0, 2, 8, {}, true}, {1, 20, 3, {}, true}, {2, 50, 9}}, 3);
  std::vector<Vec2> steps;
  for (const Stroke& stroke : all<Stroke>(shapes))
    if (flatten(stroke.path).size() > steps.size() && stroke.path.segments.size() >= 5 && !stroke.path.closed)
      steps = flatten(stroke.path);
  const std::vector<Vec2> at = discs(shapes);
  REQUIRE(at.size() == 3);
  int through = 0;
  for (const Vec2& corner : steps)
    for (const Vec2& p : at) through += (corner - p).norm() < 0.05;
  CHECK(through == 2);
  for (std::size_t i = 1; i < steps.size(); ++i)
    CHECK((steps[i].x() == steps[i - 1].x() || steps[i].y() == steps[i - 1].y()));
}

TEST_CASE("zero stands on a line of its own below the logarithmic ones", "[chart]") {
  Plot plot = {{Scale::Kind::log, 1, 100, ""},
               {Scale::Kind::log_zero, 10, 1e6, "wrong"},
               {{"a", Glyph::disc}},
               {{"p", "", {{0, 10, 0}, {0, 30, 10}, {0, 90, 1e6}}}}};
  const Figure figure = chart_figure({plot}, ThemeName::print, 227);
  std::vector<Vec2> at = discs(figure.drawing.shapes);
  at.erase(std::remove_if(at.begin(), at.end(), [&](const Vec2& p) { return p.y() > 0.9 * figure.drawing.height; }),
           at.end());
  REQUIRE(at.size() == 3);
  std::sort(at.begin(), at.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  CHECK(at[0].y() > at[1].y() + 3);
  CHECK(at[1].y() > at[2].y() + 10);
  const auto has = [&](const std::string& text) {
    return std::ranges::any_of(figure.labels, [&](const PlacedLabel& l) { return l.text == text; });
  };
  CHECK(has("0"));
  CHECK(has(plain("10^{6}")));
}

TEST_CASE("every cell of a map shows its own kind", "[chart]") {
  const Map map = stripes(13, 7);
  Maps chart = {
      {{"a", Tone::first}, {"b", Tone::second}, {"c", Tone::on}, {"d", Tone::mild}, {"e", Tone::wrong}}, {map}, ""};
  for (const ThemeName name : all_themes) {
    const Figure figure = chart_figure({chart}, name, 227);
    const std::vector<Fill> fills = all<Fill>(figure.drawing.shapes);
    const std::vector<Vec2> frame = flatten(fills.front().path);
    const auto colour_at = [&](double x, double y) {
      Colour colour;
      for (const Fill& fill : fills) {
        const std::vector<Vec2> c = flatten(fill.path);
        if (c.size() == 4 && c[0].x() < x && x < c[2].x() && c[0].y() < y && y < c[2].y()) colour = fill.colour;
      }
      return colour;
    };
    std::vector<std::set<std::tuple<double, double, double>>> seen(5);
    for (int y = 0; y < map.rows; ++y)
      for (int x = 0; x < map.columns; ++x) {
        const Colour c = colour_at(frame[0].x() + (x + 0.5) / map.columns * (frame[2].x() - frame[0].x()),
                                   frame[2].y() - (y + 0.5) / map.rows * (frame[2].y() - frame[0].y()));
        seen[map.cells[static_cast<std::size_t>(y) * map.columns + x]].insert({c.r, c.g, c.b});
      }
    std::set<std::tuple<double, double, double>> different;
    for (const auto& colours : seen) {
      CHECK(colours.size() == 1);
      different.insert(colours.begin(), colours.end());
    }
    CHECK(different.size() == 5);
  }
}

TEST_CASE("bars back to back are as long as their shares, each on its own side", "[chart]") {
  for (const ThemeName name : all_themes) {
    const Figure figure = chart_figure(mirrored(1), name, 340);
    std::vector<Bounds> bars;
    for (const Fill& fill : all<Fill>(figure.drawing.shapes)) {
      const std::vector<Vec2> c = flatten(fill.path);
      if (c.size() == 4) bars.push_back({c[0].x(), c[0].y(), c[2].x(), c[2].y()});
    }
    REQUIRE(bars.size() == 7);  // two of the legend
    const double zero = bars[0].right, unit = (bars[0].right - bars[0].left) / 100;
    CHECK(bars[2].right == Approx(zero));
    CHECK(zero - bars[2].left == Approx(20 * unit));
    CHECK(bars[3].left == Approx(zero));
    CHECK(bars[3].right - zero == Approx(10 * unit));
    CHECK(bars[4].right - zero == Approx(99 * unit));
    CHECK(bars[2].top - bars[0].bottom > 1.5 * (bars[4].top - bars[2].bottom));  // the first row stands apart
  }
  CHECK(percent_text(0) == "0");
  CHECK(percent_text(0.004) == "<0.01");
  CHECK(percent_text(0.061) == "0.06");
  CHECK(percent_text(0.996) == "1.0");
  CHECK(percent_text(5.44) == "5.4");
  CHECK(percent_text(9.96) == "10");
  CHECK(percent_text(27.6) == "28");
}

TEST_CASE("a small map on paper has numbers, and a key that names them, and a large one its names", "[chart]") {
  Cases cases;
  cases.x = {Scale::Kind::linear, 0, 4, "start of the ray", {}};
  cases.y = {Scale::Kind::linear, 0, 2, "distance", {}};
  cases.branches = {"no real root", "two hits, both of them", "from inside", "tangent", "nowhere here"};
  const auto patch = [](double x0, double y0, double x1, double y1, int branch) {
    return Cases::Patch{{Vec2(x0, y0), Vec2(x1, y0), Vec2(x1, y1), Vec2(x0, y1)}, branch};
  };
  cases.patches = {patch(0, 1, 4, 2, 0), patch(0, 0, 3.4, 1, 1), patch(3.4, 0, 4, 1, 2)};
  cases.presets = {{{1, 1}, 3}};  // a line
  const auto texts = [&](double width) {
    const Theme theme = paper_theme(ThemeName::print);
    const double height = natural_height(Chart{cases}, width, theme);
    const Composed map = compose(Chart{cases}, Vec2::Zero(), width, height, theme);
    const Drawing drawing = {width, height, theme.background, map.shapes, map.objects};
    CHECK(label_faults(drawing, map.labels).empty());
    std::multiset<std::string> all;
    for (const PlacedLabel& label : map.labels) all.insert(label.text);
    return all;
  };
  const auto small = texts(160), large = texts(500);
  for (const char* number : {"1", "2", "3", "4"}) CHECK(small.contains(number));
  for (const char* entry : {"1 no real root", "2 two hits, both of them", "3 from inside", "4 tangent"})
    CHECK(small.count(entry) == 1);
  for (int i = 0; i < 4; ++i) {
    CHECK_FALSE(small.contains(cases.branches[i]));
    CHECK(large.count(cases.branches[i]) == 1);
  }
  CHECK_FALSE(small.contains("5 nowhere here"));
  CHECK_FALSE(large.contains("1 no real root"));
  // Where the names have room, a small map keeps them.
  cases.branches = {"no", "two", "in", "on", ""};
  CHECK(texts(160).contains("two"));
}

}  // namespace chart_test
