// Markers in the charts of all lessons: each stands at its data.

#include <algorithm>
#include <map>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/viz/drawn.h"
#include "viz/chart/chart.h"
#include "viz/chart/chart_parts.h"

namespace markers_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// The plot with discs for markers, and one more in two corners of each panel, which show where the panel lies.
Plot with_corners(Plot plot) {
  for (Series& series : plot.series) series.glyph = Glyph::disc;
  for (Panel& panel : plot.panels) {
    panel.spots.push_back({0, plot.x.lo, plot.y.kind == Scale::Kind::log_zero ? 0 : plot.y.lo});
    panel.spots.push_back({0, plot.x.hi, plot.y.hi});
  }
  return plot;
}

/// The middles of the markers of each panel, by the panel's object.
std::map<int, std::vector<Vec2>> middles(const Drawing& drawing) {
  std::map<int, std::vector<Vec2>> found;
  for (const Stroke& stroke : all<Stroke>(drawing.shapes)) {
    if (!stroke.path.closed || drawing.objects[stroke.object].kind != "panel") continue;
    const std::vector<Vec2> rim = flatten(stroke.path);
    Vec2 lo = rim.front(), hi = rim.front();
    for (const Vec2& p : rim) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
    found[stroke.object].emplace_back((lo + hi) / 2);
  }
  return found;
}

}  // namespace

TEST_CASE("each marker of a chart stands at its data", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets)
      for (const Step& step : lesson->walk(preset.parameters).steps) {
        const Plot* shown = step.scene.chart ? std::get_if<Plot>(&step.scene.chart->kind) : nullptr;
        if (!shown || std::ranges::all_of(shown->panels, [](const Panel& p) { return p.spots.empty(); })) continue;
        const Plot plot = with_corners(*shown);
        const std::map<int, std::vector<Vec2>> panels = middles(chart_figure({plot}, ThemeName::screen, 960).drawing);
        REQUIRE(panels.size() == plot.panels.size());
        auto panel = plot.panels.begin();
        for (const auto& [object, at] : panels) {
          INFO(lesson->id << ' ' << preset.id << ", " << step.slug << ": " << panel->title);
          Vec2 lo = at.front(), hi = at.front();
          for (const Vec2& p : at) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
          const ScaleLine x(plot.x, lo.x(), hi.x()), y(plot.y, hi.y(), lo.y());
          for (const Spot& spot : panel->spots) {
            const Vec2 wanted(x.at(spot.x), y.at(spot.y));
            CHECK(std::ranges::any_of(at, [&](const Vec2& p) { return (p - wanted).norm() < 0.05; }));
          }
          for (const Vec2& p : at)
            CHECK(std::ranges::any_of(
                panel->spots, [&](const Spot& spot) { return (p - Vec2(x.at(spot.x), y.at(spot.y))).norm() < 0.05; }));
          ++panel;
        }
      }
}

}  // namespace markers_test
