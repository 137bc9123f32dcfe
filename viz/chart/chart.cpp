#include "viz/chart/chart.h"

#include "viz/chart/chart_parts.h"

namespace isect::viz {
namespace {

/// Returns the theme whose sizes follow the width alone: a chart is as high as it must be.
Theme theme_for(ThemeName name, double width) { return theme(name, width, width); }

}  // namespace

Bounds room_of(Vec2 corner, double width, double height, const Theme& theme) {
  const double m = theme.sizes.margin;
  return {corner.x() + m, corner.y() + m, corner.x() + width - m, corner.y() + height - m};
}

bool is_card(const Scene& scene) { return scene.chart && std::holds_alternative<Card>(scene.chart->kind); }

Composed compose(const Chart& chart, Vec2 corner, double width, double height, const Theme& theme) {
  ChartInk ink(theme);
  const Bounds room = room_of(corner, width, height, theme);
  std::visit([&](const auto& kind) { draw(ink, kind, room); }, chart.kind);
  return ink.take();
}

double natural_height(const Chart& chart, double width, const Theme& theme) {
  const ChartInk ink(theme);
  const double inner = width - 2 * theme.sizes.margin;
  return std::visit([&](const auto& kind) { return natural_height(ink, kind, inner); }, chart.kind) +
         2 * theme.sizes.margin;
}

Box2 plane_of(const Cases& cases, Vec2 corner, double width, double height, const Theme& theme) {
  const ChartInk ink(theme);
  const Bounds b = plane_within(ink, cases, room_of(corner, width, height, theme));
  return {{b.left, b.top}, {b.right, b.bottom}};
}

Figure chart_figure(const Chart& chart, ThemeName name, double width) {
  const Theme styled = theme_for(name, width);
  const double height = natural_height(chart, width, styled);
  Composed composed = compose(chart, Vec2::Zero(), width, height, styled);
  return {{width, height, styled.background, std::move(composed.shapes), std::move(composed.objects)},
          std::move(composed.labels),
          View({}, width, height)};
}

std::vector<bool> pareto_front(const std::vector<Vec2>& points) {
  std::vector<bool> front;
  for (const Vec2& p : points) {
    bool beaten = !(p.x() <= p.x() && p.y() <= p.y());  // NaN is on no front
    for (const Vec2& q : points)
      beaten = beaten || (q.x() <= p.x() && q.y() <= p.y() && (q.x() < p.x() || q.y() < p.y()));
    front.push_back(!beaten);
  }
  return front;
}

}  // namespace isect::viz
