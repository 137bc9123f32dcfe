// Two opposite faults back to back: panels on a common grid, in each a bar to either side of a zero line for every row.

#include <fmt/format.h>

#include <algorithm>

#include "viz/chart/chart_parts.h"

namespace isect::viz {
namespace {

struct MirroredLayout {
  int columns = 1, rows = 1;
  double names = 0, panel = 0, pitch = 0, apart = 0, head = 0, top = 0, gutter = 0;
  double unit = 0;  ///< how long one percent is: the longest bars end where their numbers just fit
  std::vector<LegendEntry> entries;
  std::vector<std::string> below;

  MirroredLayout(const ChartInk& ink, const Mirrored& chart, double width) {
    const Sizes& s = ink.sizes();
    for (const std::string& row : chart.rows) names = std::max(names, ink.width(row, s.axis));
    names += 0.9 * s.axis;
    gutter = 1.6 * s.gutter;
    const int count = std::max(1, static_cast<int>(chart.panels.size()));
    const int fit = std::max(1, static_cast<int>((width - names + gutter) / (8.5 * s.axis + gutter)));
    rows = (count + fit - 1) / fit;
    columns = (count + rows - 1) / rows;
    panel = (width - names - (columns - 1) * gutter) / columns;
    pitch = 1.4 * s.axis, apart = chart.apart > 0 ? 0.6 * s.axis : 0;
    head = 1.7 * s.title;
    top = chart.rows_title.empty() ? 0 : 1.5 * s.axis;

    unit = panel;
    for (const Mirrored::Panel& p : chart.panels)
      for (const Mirrored::Pair& pair : p.pairs)
        for (const double share : {pair.left, pair.right})
          if (share > 0)
            unit = std::min(unit, (panel / 2 - s.label_clear - ink.width(percent_text(share), s.axis)) / share);
    for (const auto& [name, tone] : chart.kinds) entries.push_back({name, {}, colour_of(tone, ink.theme())});
    below = ink.wrapped(chart.below, s.axis, false, width);
  }
  /// Returns the middle of a row, from the top of its panel.
  double middle(const Mirrored& chart, std::size_t row) const {
    return head + (static_cast<double>(row) + 0.5) * pitch + (static_cast<int>(row) < chart.apart ? 0 : apart);
  }
  double height(const ChartInk& ink, const Mirrored& chart) const {
    return head + pitch * static_cast<double>(chart.rows.size()) + apart + 0.8 * ink.sizes().axis;
  }
  double foot(const ChartInk& ink, double width) const {
    return 1.35 * ink.sizes().axis * static_cast<double>(below.size()) + 0.3 * ink.sizes().axis +
           legend_height(ink, entries, width);
  }
};

/// Draws a bar from the zero line to the left (-1) or right (1), and its number beyond its end.
void bar(ChartInk& ink, const Vec2& zero, int side, double length, double share, Tone tone) {
  const Sizes& s = ink.sizes();
  const double half = 0.46 * s.axis, end = zero.x() + side * length;
  const Bounds b = {std::min(zero.x(), end), zero.y() - half, std::max(zero.x(), end), zero.y() + half};
  if (share > 0) {
    ink.box(b, colour_of(tone, ink.theme()));
    ink.line({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}, {b.left, b.top}},
             ink.theme().ink(Role::construction), s.hairline);
  }
  ink.text(percent_text(share), {end + side * s.label_clear, zero.y() + 0.33 * s.axis},
           {s.axis, share > 0 ? Role::text : Role::muted, side < 0 ? 1.0 : 0.0});
}

}  // namespace

std::string percent_text(double percent) {
  if (!(percent > 0)) return "0";
  if (percent < 0.01) return "<0.01";
  return percent >= 9.95 ? fmt::format("{:.0f}", percent) : fmt::format("{:.{}f}", percent, percent < 0.995 ? 2 : 1);
}

double natural_height(const ChartInk& ink, const Mirrored& chart, double width) {
  const MirroredLayout layout(ink, chart, width);
  return layout.top + layout.rows * layout.height(ink, chart) + layout.foot(ink, width);
}

void draw(ChartInk& ink, const Mirrored& chart, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const double width = room.right - room.left;
  const MirroredLayout layout(ink, chart, width);
  ink.part("chart", "scales");
  if (!chart.rows_title.empty()) ink.text(chart.rows_title, {room.left, room.top + s.axis}, {s.axis, Role::muted});

  const double foot = layout.foot(ink, width);
  const double pitch = (room.bottom - room.top - layout.top - foot) / layout.rows;
  for (int i = 0; i < static_cast<int>(chart.panels.size()); ++i) {
    const Mirrored::Panel& panel = chart.panels[i];
    const int column = i % layout.columns;
    const double top = room.top + layout.top + pitch * (i / layout.columns);
    const double left = room.left + layout.names + column * (layout.panel + layout.gutter);
    const double zero = left + layout.panel / 2;
    ink.part("panel", panel.title);
    ink.text(panel.title, {zero, top + 1.1 * s.title}, {s.title, Role::text, 0.5, true});
    for (std::size_t row = 0; row < chart.rows.size(); ++row) {
      const double middle = top + layout.middle(chart, row);
      if (column == 0)
        ink.text(chart.rows[row], {left - 0.9 * s.axis, middle + 0.33 * s.axis}, {s.axis, Role::muted, 1});
      const auto [on_left, on_right] = panel.pairs.at(row);
      bar(ink, {zero, middle}, -1, layout.unit * on_left, on_left, chart.kinds[0].second);
      bar(ink, {zero, middle}, 1, layout.unit * on_right, on_right, chart.kinds[1].second);
    }
    const double last = top + layout.middle(chart, chart.rows.size() - 1) + layout.pitch / 2;
    ink.line({{zero, top + layout.head}, {zero, last}}, ink.theme().ink(Role::text), s.construction);
  }

  ink.part("chart", "scales");
  double y = room.bottom - foot + 1.1 * s.axis;
  for (const std::string& line : layout.below) {
    ink.text(line, {room.left + width / 2, y}, {s.axis, Role::muted, 0.5});
    y += 1.35 * s.axis;
  }
  legend(ink, layout.entries, {room.left, y - 0.8 * s.axis}, width);
}

}  // namespace isect::viz
