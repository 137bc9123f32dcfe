// Rows on one scale: markers, a target, and whether it was met.

#include <algorithm>
#include <cmath>

#include "viz/chart/chart_parts.h"
#include "viz/compose/marks.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

struct BarsLayout {
  double names = 0, texts = 0, pitch = 0, foot = 0;
  std::vector<LegendEntry> entries;
  std::vector<std::vector<std::string>> lines;  ///< of each name
  std::vector<double> tops;                     ///< of each row, and the end of the last
  std::vector<std::string> title;

  BarsLayout(const ChartInk& ink, const Bars& chart, double width) {
    const Sizes& s = ink.sizes();
    pitch = 1.3 * s.label;
    bool targets = false;
    tops = {0};
    for (const Bar& bar : chart.bars) {
      lines.push_back(ink.wrapped(bar.name, s.label, false, 0.42 * width));
      for (const std::string& line : lines.back()) names = std::max(names, ink.width(line, s.label));
      const double sign = bar.kind == Verdict::Kind::open ? 0 : 1.3 * s.label;
      if (!bar.text.empty()) texts = std::max(texts, sign + ink.width(bar.text, s.label));
      targets = targets || bar.target.has_value();
      tops.push_back(tops.back() + pitch * static_cast<double>(lines.back().size()) + 0.45 * s.label);
    }
    names += 0.8 * s.label;
    if (texts > 0) texts += 1.0 * s.label;
    for (const Series& series : chart.series)
      entries.push_back({series.name, series.glyph, ink.theme().ink(series.role), series.role == Role::construction});
    if (targets) entries.push_back({chart.target_name, {}, ink.theme().ink(Role::text), false, {}, true});
    title = ink.wrapped(chart.x.title, s.axis, false, width);
    foot = 1.75 * s.axis + 1.35 * s.axis * static_cast<double>(title.size()) + 0.3 * s.axis +
           legend_height(ink, entries, width);
  }
};

void sign(ChartInk& ink, Verdict::Kind kind, const Vec2& p, const Colour& colour) {
  const double a = 0.26 * ink.sizes().label, w = ink.sizes().marker_line;
  if (kind == Verdict::Kind::yes)
    ink.line({p + Vec2(-a, 0), p + Vec2(-0.25 * a, 0.8 * a), p + Vec2(1.1 * a, -0.9 * a)}, colour, w, {0, 0}, true);
  if (kind == Verdict::Kind::no) ink.ring(p, 0.9 * a, colour, w);
}

}  // namespace

double natural_height(const ChartInk& ink, const Bars& chart, double width) {
  const BarsLayout layout(ink, chart, width);
  return layout.tops.back() + layout.foot;
}

void draw(ChartInk& ink, const Bars& chart, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const Theme& t = ink.theme();
  const double width = room.right - room.left;
  const BarsLayout layout(ink, chart, width);
  const double left = room.left + layout.names, right = room.right - layout.texts;
  const ScaleLine x(chart.x, left, right, s.label);
  const double stretch = (room.bottom - room.top - layout.foot) / layout.tops.back();
  const double bottom = room.bottom - layout.foot;

  for (std::size_t i = 0; i < chart.bars.size(); ++i) {
    const Bar& bar = chart.bars[i];
    const double top = room.top + stretch * layout.tops[i], end = room.top + stretch * layout.tops[i + 1];
    const double middle = (top + end) / 2;
    ink.part("row", bar.name);
    double y = middle - 0.5 * layout.pitch * static_cast<double>(layout.lines[i].size() - 1) + 0.32 * s.label;
    for (const std::string& line : layout.lines[i]) {
      ink.text(line, {room.left, y}, {s.label});
      y += layout.pitch;
    }
    ink.line({{left, middle}, {right, middle}}, t.ink(Role::grid), s.hairline);
    if (bar.target) {
      const double p = x.at(*bar.target), h = 0.5 * s.label;
      ink.line({{p, middle - h}, {p, middle + h}}, t.ink(Role::text), s.shared);
    }
    if (bar.interval) {
      const double lo = x.at(bar.interval->first), hi = x.at(bar.interval->second), h = 0.3 * s.label;
      const Colour& ink_of_interval = t.ink(Role::text);
      ink.line({{lo, middle}, {hi, middle}}, ink_of_interval, s.outline);
      for (const double end_of : {lo, hi})
        ink.line({{end_of, middle - h}, {end_of, middle + h}}, ink_of_interval, s.construction);
    }
    for (std::size_t k = bar.dots.size(); k-- > 0;) {
      const Series& series = chart.series[bar.dots[k].first];
      const Vec2 at(x.at(bar.dots[k].second), middle);
      const std::string name = plain(series.name);
      ink.tell(at, plain(bar.name) + (name.empty() ? "" : ", " + name) + "\n" + told_of(chart.x, bar.dots[k].second) +
                       (bar.target ? "\n" + plain(chart.target_name) + ": " + shown(*bar.target) : ""));
      ink.glyph(series.glyph, at, ink.glyph_radius(), t.ink(series.role), series.role == Role::construction);
    }
    if (bar.text.empty()) continue;
    const Role role = bar.kind == Verdict::Kind::yes  ? Role::hit
                      : bar.kind == Verdict::Kind::no ? Role::miss
                                                      : Role::muted;
    const TextBox box = ink.text(bar.text, {room.right, middle + 0.32 * s.label}, {s.label, role, 1});
    sign(ink, bar.kind, {box.left - 0.65 * s.label, middle}, t.ink(role));
  }

  ink.part("chart", "scales");
  ink.line({{left, bottom}, {right, bottom}}, t.ink(Role::construction), s.construction);
  for (const auto& [value, text] : x.ticks(ink, true)) {
    const double p = x.at(value), half = ink.width(text, s.axis) / 2;
    ink.line({{p, bottom}, {p, bottom + 0.3 * s.axis}}, t.ink(Role::construction), s.construction);
    ink.text(text, {std::clamp(p, room.left + half, room.right - half), bottom + 1.3 * s.axis},
             {s.axis, Role::muted, 0.5});
  }
  double y = bottom + 1.75 * s.axis + 1.1 * s.axis;
  for (const std::string& line : layout.title) {
    ink.text(line, {room.left + width / 2, y}, {s.axis, Role::muted, 0.5});
    y += 1.35 * s.axis;
  }
  legend(ink, layout.entries, {room.left, y - 0.8 * s.axis}, width);
}

}  // namespace isect::viz
