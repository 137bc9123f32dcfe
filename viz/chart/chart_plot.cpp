// Small multiples: titles, scales, legend, and panels on a common grid.

#include <algorithm>
#include <cmath>

#include "viz/chart/chart_parts.h"

namespace isect::viz {
namespace {

/// Where the panels stand, and what stands around them: decided once, for drawing and for measuring.
class PlotLayout {
 public:
  PlotLayout(const ChartInk& ink, const Plot& plot, double width) : ink_(ink), plot_(plot), width_(width) {
    const Sizes& s = ink.sizes();
    for (const auto& [value, text] : y_ticks(1e3)) left_ = std::max(left_, ink.width(text, s.axis));
    left_ += s.label_clear + 0.35 * s.axis;
    for (const Panel& panel : plot.panels)
      for (const Curve& curve : panel.curves) right_ = std::max(right_, ink.width(curve.label, s.label));
    if (right_ > 0) right_ += 1.2 * s.label;

    const int count = std::max(1, static_cast<int>(plot.panels.size()));  // without any, room for one
    const double least = 6.3 * s.title + right_;
    const int fit = std::max(1, static_cast<int>((width - left_ + s.gutter) / (least + s.gutter)));
    rows_ = (count + fit - 1) / fit;
    columns_ = (count + rows_ - 1) / rows_;
    panel_width_ = (width - left_ - (columns_ - 1) * gutter()) / columns_ - right_;
    for (const Panel& panel : plot.panels) {
      const auto lines = title_of(panel);
      title_lines_ = std::max(title_lines_, lines.size());
      has_notes_ = has_notes_ || !panel.note.empty();
    }
    for (const Series& series : plot.series)
      if (!series.name.empty()) entries_.push_back(entry(series));
  }

  double gutter() const { return 1.6 * ink_.sizes().gutter; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double panel_width() const { return panel_width_; }
  double left(int column) const { return left_ + column * (panel_width_ + right_ + gutter()); }

  std::vector<std::string> title_of(const Panel& panel) const {
    return ink_.wrapped(panel.title, ink_.sizes().title, true, panel_width_ + right_ + 0.6 * gutter());
  }
  std::size_t title_lines() const { return title_lines_; }
  double head() const {  // of a row of panels
    return (static_cast<double>(title_lines_) * 1.25 + 0.45) * ink_.sizes().title +
           (has_notes_ ? 1.25 * ink_.sizes().axis : 0);
  }
  double foot() const { return 1.75 * ink_.sizes().axis; }
  double top() const { return plot_.y.title.empty() ? 0 : 1.5 * ink_.sizes().axis; }
  std::vector<std::string> x_title() const { return ink_.wrapped(plot_.x.title, ink_.sizes().axis, false, width_); }
  double bottom() const {
    return 1.35 * ink_.sizes().axis * static_cast<double>(x_title().size()) + 0.3 * ink_.sizes().axis +
           legend_height(ink_, entries_, width_);
  }
  const std::vector<LegendEntry>& entries() const { return entries_; }
  std::vector<std::pair<double, std::string>> y_ticks(double height) const {
    return ScaleLine(plot_.y, height, 0).ticks(ink_, false);
  }

 private:
  LegendEntry entry(const Series& series) const {
    bool curves = false;
    for (const Panel& panel : plot_.panels)
      for (const Curve& curve : panel.curves) curves = curves || &plot_.series[curve.series] == &series;
    LegendEntry e = {series.name, series.glyph, ink_.theme().ink(curves ? series.role : Role::text)};
    if (curves) e.dash = dash_of(series.dash, ink_.sizes());
    return e;
  }

  const ChartInk& ink_;
  const Plot& plot_;
  double width_, left_ = 0, right_ = 0, panel_width_ = 0;
  int columns_ = 1, rows_ = 1;
  std::size_t title_lines_ = 0;
  bool has_notes_ = false;
  std::vector<LegendEntry> entries_;
};

void heading(ChartInk& ink, const PlotLayout& layout, const Panel& panel, const Bounds& b, double top) {
  const Sizes& s = ink.sizes();
  const auto lines = layout.title_of(panel);
  const double middle = (b.left + b.right) / 2;
  double y = top + (1.25 * static_cast<double>(layout.title_lines() - lines.size()) + 1) * s.title;
  for (const std::string& line : lines) {
    ink.text(line, {middle, y}, {s.title, panel.muted ? Role::construction : Role::text, 0.5, true});
    y += 1.25 * s.title;
  }
  if (!panel.note.empty()) ink.text(panel.note, {middle, y - 0.1 * s.title}, {s.axis, Role::muted, 0.5});
}

void scales(ChartInk& ink, const Plot& plot, const PlotLayout& layout, const Bounds& b, bool numbers) {
  const Sizes& s = ink.sizes();
  const Theme& t = ink.theme();
  const double reach = layout.gutter() / 4;  // numbers stay under their own panel
  const ScaleLine x(plot.x, b.left, b.right, reach), y(plot.y, b.bottom, b.top);
  for (const auto& [value, text] : layout.y_ticks(b.bottom - b.top)) {
    const double level = y.at(value);
    ink.line({{b.left, level}, {b.right, level}}, t.ink(Role::grid), s.hairline);
    if (numbers) ink.text(text, {b.left - s.label_clear, level + 0.33 * s.axis}, {s.axis, Role::muted, 1});
  }
  ink.line({{b.left, b.bottom}, {b.right, b.bottom}}, t.ink(Role::construction), s.construction);
  for (const auto& [value, text] : x.ticks(ink, true)) {
    const double p = x.at(value);
    ink.line({{p, b.bottom}, {p, b.bottom + 0.3 * s.axis}}, t.ink(Role::construction), s.construction);
    const double half = ink.width(text, s.axis) / 2;
    ink.text(text, {std::clamp(p, b.left - reach + half, b.right + reach - half), b.bottom + 1.3 * s.axis},
             {s.axis, Role::muted, 0.5});
  }
}

}  // namespace

double natural_height(const ChartInk& ink, const Plot& plot, double width) {
  const PlotLayout layout(ink, plot, width);
  const bool one = plot.panels.size() == 1;  // in one row panels may be higher than wide
  const double panel =
      one ? 0.52 * width
          : std::clamp((layout.rows() == 1 ? 1.5 : 1.05) * layout.panel_width(), 0.2 * width, 0.45 * width);
  return layout.top() + layout.rows() * (layout.head() + panel + layout.foot()) + layout.bottom();
}

void draw(ChartInk& ink, const Plot& plot, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const double width = room.right - room.left;
  const PlotLayout layout(ink, plot, width);
  ink.part("chart", "scales");
  if (!plot.y.title.empty()) ink.text(plot.y.title, {room.left, room.top + s.axis}, {s.axis, Role::muted});

  const double row = (room.bottom - room.top - layout.top() - layout.bottom()) / layout.rows();
  for (int i = 0; i < static_cast<int>(plot.panels.size()); ++i) {
    const Panel& panel = plot.panels[i];
    const int column = i % layout.columns();
    const double top = room.top + layout.top() + row * (i / layout.columns());
    const double left = room.left + layout.left(column);
    const Bounds b = {left, top + layout.head(), left + layout.panel_width(), top + row - layout.foot()};
    ink.part("panel", panel.title + (panel.note.empty() ? "" : ", " + panel.note));
    heading(ink, layout, panel, b, top);
    scales(ink, plot, layout, b, column == 0);
    draw_data(ink, plot, panel, b);
  }

  ink.part("chart", "scales");
  double y = room.bottom - layout.bottom() + 1.1 * s.axis;
  for (const std::string& line : layout.x_title()) {
    ink.text(line, {room.left + width / 2, y}, {s.axis, Role::muted, 0.5});
    y += 1.35 * s.axis;
  }
  legend(ink, layout.entries(), {room.left, y - 0.8 * s.axis}, width);
}

}  // namespace isect::viz
