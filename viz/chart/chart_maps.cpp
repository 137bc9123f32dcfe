// Maps of verdicts: one cell for each neighbour of a point.

#include <algorithm>
#include <cmath>

#include "viz/chart/chart_parts.h"

namespace isect::viz {
namespace {

struct MapsLayout {
  int columns = 1, rows = 1;
  double side = 0, head = 0, below = 0;
  std::vector<LegendEntry> entries;

  MapsLayout(const ChartInk& ink, const Maps& chart, double width) {
    const Sizes& s = ink.sizes();
    const int count = static_cast<int>(chart.maps.size());
    columns = std::min(count, 3);
    rows = (count + columns - 1) / columns;
    columns = (count + rows - 1) / rows;
    side = (width - (columns - 1) * 2 * s.gutter) / columns;
    side = std::min(side, 0.6 * width);
    std::size_t lines = 0, notes = 0;
    for (const Map& map : chart.maps) {
      lines = std::max(lines, ink.wrapped(map.title, s.title, true, side).size());
      if (!map.note.empty()) notes = std::max(notes, ink.wrapped(map.note, s.axis, false, side + s.gutter).size());
    }
    head = (1.25 * static_cast<double>(lines) + 0.3) * s.title;
    below = (1.25 * static_cast<double>(notes) + 0.6) * s.axis;
    for (const auto& [name, tone] : chart.kinds) entries.push_back({name, {}, colour_of(tone, ink.theme())});
  }
  double foot(const ChartInk& ink, const Maps& chart, double width) const {
    const double text =
        chart.below.empty() ? 0 : 1.35 * ink.sizes().axis * static_cast<double>(lines(ink, chart, width).size());
    return text + 0.3 * ink.sizes().axis + legend_height(ink, entries, width);
  }
  static std::vector<std::string> lines(const ChartInk& ink, const Maps& chart, double width) {
    return ink.wrapped(chart.below, ink.sizes().axis, false, width);
  }
};

/// Draws the cells as few rectangles: equal runs of a row, joined with equal runs below. Later kinds reach a little
/// over their neighbours, so that no seam shows between touching cells.
void cells(ChartInk& ink, const Maps& chart, const Map& map, const Bounds& b) {
  const double w = (b.right - b.left) / map.columns, h = (b.bottom - b.top) / map.rows;
  const auto kind = [&](int x, int y) { return map.cells[static_cast<std::size_t>(y) * map.columns + x]; };
  std::vector<long> counts(chart.kinds.size(), 0);
  for (const unsigned char c : map.cells) ++counts[c];
  const auto most = static_cast<unsigned char>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  ink.box(b, colour_of(chart.kinds[most].second, ink.theme()));

  std::vector<bool> done(map.cells.size(), false);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.columns; ++x) {
      const unsigned char k = kind(x, y);
      if (k == most || done[static_cast<std::size_t>(y) * map.columns + x]) continue;
      int right = x, top = y;
      const auto open = [&](int at, int row) {
        return kind(at, row) == k && !done[static_cast<std::size_t>(row) * map.columns + at];
      };
      while (right + 1 < map.columns && open(right + 1, y)) ++right;
      const auto whole = [&](int row) {
        for (int at = x; at <= right; ++at)
          if (!open(at, row)) return false;
        return true;
      };
      while (top + 1 < map.rows && whole(top + 1)) ++top;
      for (int row = y; row <= top; ++row)
        for (int at = x; at <= right; ++at) done[static_cast<std::size_t>(row) * map.columns + at] = true;
      const double over = 0.04;
      ink.box({b.left + (x - over) * w, b.bottom - (top + 1 + over) * h, b.left + (right + 1 + over) * w,
               b.bottom - (y - over) * h},
              colour_of(chart.kinds[k].second, ink.theme()));
    }
}

}  // namespace

double natural_height(const ChartInk& ink, const Maps& chart, double width) {
  const MapsLayout layout(ink, chart, width);
  return layout.rows * (layout.head + layout.side + layout.below) + layout.foot(ink, chart, width);
}

void draw(ChartInk& ink, const Maps& chart, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const Theme& t = ink.theme();
  const double width = room.right - room.left;
  const MapsLayout layout(ink, chart, width);
  const double foot = layout.foot(ink, chart, width);
  const double row = (room.bottom - room.top - foot) / layout.rows;
  const double side = std::min(layout.side, row - layout.head - layout.below);
  const double pitch = side + 2 * s.gutter, indent = (width - layout.columns * pitch + 2 * s.gutter) / 2;
  for (int i = 0; i < static_cast<int>(chart.maps.size()); ++i) {
    const Map& map = chart.maps[i];
    const double left = room.left + indent + pitch * (i % layout.columns), top = room.top + row * (i / layout.columns);
    ink.part("map", map.title);
    const auto title = ink.wrapped(map.title, s.title, true, side);
    double y = top + layout.head - 0.45 * s.title - 1.25 * s.title * static_cast<double>(title.size() - 1);
    for (const std::string& line : title) {
      ink.text(line, {left + side / 2, y}, {s.title, Role::text, 0.5, true});
      y += 1.25 * s.title;
    }

    const Bounds b = {left, top + layout.head, left + side, top + layout.head + side};
    cells(ink, chart, map, b);
    std::vector<Vec2> line;
    for (const Vec2& p : map.line)
      line.emplace_back(b.left + p.x() / map.columns * side, b.bottom - p.y() / map.rows * side);
    if (!line.empty()) ink.line(line, t.ink(Role::text), 0.7 * s.outline);
    ink.line({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}, {b.left, b.top}},
             t.ink(Role::construction), s.hairline);

    y = b.bottom + 1.25 * s.axis;
    if (!map.note.empty())
      for (const std::string& note : ink.wrapped(map.note, s.axis, false, side + s.gutter)) {
        ink.text(note, {left + side / 2, y}, {s.axis, Role::muted, 0.5});
        y += 1.25 * s.axis;
      }
  }

  ink.part("chart", "legend");
  double y = room.bottom - foot + 1.1 * s.axis;
  if (!chart.below.empty())
    for (const std::string& text : MapsLayout::lines(ink, chart, width)) {
      ink.text(text, {room.left + width / 2, y}, {s.axis, Role::muted, 0.5});
      y += 1.35 * s.axis;
    }
  legend(ink, layout.entries, {room.left, y - 0.8 * s.axis}, width);
}

}  // namespace isect::viz
