#include "viz/chart/chart_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/compose/halos.h"
#include "viz/compose/marks.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

/// Returns corners on circles of the given radii, in turn, starting at `start` (a quarter turn is up).
std::vector<Vec2> star(const Vec2& at, std::vector<double> radii, int corners, double start = 0.25) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (start + static_cast<double>(i) / corners);
    points.push_back(at + radii[static_cast<std::size_t>(i) % radii.size()] * Vec2(std::cos(angle), -std::sin(angle)));
  }
  return points;
}

/// Returns a plus with arms of half-width `half`, turned by `turn`.
std::vector<Vec2> cross_shape(const Vec2& at, double r, double turn) {
  const double h = 0.36 * r, c = std::cos(turn), s = std::sin(turn);
  const Vec2 corners[] = {{h, h},   {h, r},   {-h, r}, {-h, h}, {-r, h}, {-r, -h},
                          {-h, -h}, {-h, -r}, {h, -r}, {h, -h}, {r, -h}, {r, h}};
  std::vector<Vec2> points;
  for (const Vec2& p : corners) points.emplace_back(at + Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
  return points;
}

/// Returns the outline of a glyph; all have about the same area.
Path outline_of(Glyph glyph, const Vec2& at, double r) {
  const auto closed = [](const std::vector<Vec2>& points) { return polyline(points, true); };
  switch (glyph) {
    case Glyph::triangle:
      return closed(star(at + Vec2(0, 0.18 * r), {1.22 * r}, 3));
    case Glyph::down:
      return closed(star(at - Vec2(0, 0.18 * r), {1.22 * r}, 3, 0.75));
    case Glyph::right:
      return closed(star(at - Vec2(0.18 * r, 0), {1.22 * r}, 3, 0));
    case Glyph::left:
      return closed(star(at + Vec2(0.18 * r, 0), {1.22 * r}, 3, 0.5));
    case Glyph::diamond:
      return closed(star(at, {1.18 * r}, 4));
    case Glyph::square:
      return closed(star(at, {1.2 * r}, 4, 0.125));
    case Glyph::pentagon:
      return closed(star(at, {1.08 * r}, 5));
    case Glyph::hexagon:
      return closed(star(at, {1.04 * r}, 6, 0));
    case Glyph::plus:
      return closed(cross_shape(at, 1.15 * r, 0));
    case Glyph::saltire:
      return closed(cross_shape(at, 1.2 * r, std::numbers::pi / 4));
    case Glyph::star:
      return closed(star(at, {1.42 * r, 0.6 * r}, 10));
    case Glyph::star4:
      return closed(star(at, {1.5 * r, 0.55 * r}, 8));
    case Glyph::star6:
      return closed(star(at, {1.38 * r, 0.74 * r}, 12));
    case Glyph::disc:
      break;
  }
  return circle(at, 0.98 * r);
}

/// Returns the values at which a tick may stand: `of_decade` of each decade, every `every`-th decade.
std::vector<double> log_ticks(double lo, double hi, const std::vector<double>& of_decade, int every) {
  std::vector<double> values;
  const int first = static_cast<int>(std::floor(std::log10(lo))), last = static_cast<int>(std::ceil(std::log10(hi)));
  for (int k = first; k <= last; ++k)
    for (const double m : of_decade) {
      const double v = m * std::pow(10.0, k);
      if (k % every == 0 && v >= lo * (1 - 1e-9) && v <= hi * (1 + 1e-9) && (m == 1 || (v < 1e4 && v > 1e-3)))
        values.push_back(v);
    }
  return values;
}

/// Returns multiples of `step`; none if there are far too many to draw.
std::vector<double> linear_ticks(double lo, double hi, double step) {
  std::vector<double> values;
  if ((hi - lo) / step > 64) return values;
  for (double k = std::ceil(lo / step - 1e-9); k * step <= hi + 1e-9 * (hi - lo); ++k)
    values.push_back(k * step + 0.0);  // no -0
  return values;
}

}  // namespace

void ChartInk::part(const std::string& kind, const std::string& markup, Role role) {
  assign(out_.shapes, assigned_, part_);
  assigned_ = out_.shapes.size();
  const Object wanted = {kind, plain(markup), role};
  const auto known = std::ranges::find_if(
      out_.objects, [&](const Object& o) { return o.kind == wanted.kind && o.name == wanted.name; });
  part_ =
      known == out_.objects.end() ? add_object(out_.objects, wanted) : static_cast<int>(known - out_.objects.begin());
}

Composed ChartInk::take() {
  assign(out_.shapes, assigned_, part_);
  add_halos(out_.shapes, theme_);
  return std::move(out_);
}

double ChartInk::width(const std::string& markup, double size, bool bold) const {
  const TextBox b = measure(Text{markup, {0, 0}, size, {}, 0, bold, 0, {}});
  return b.right - b.left;
}

TextBox ChartInk::text(const std::string& markup, const Vec2& at, const Style& style,
                       const std::optional<Vec2>& leads_to) {
  const Text t = {markup,      at,         style.size, theme_.ink(style.role),
                  style.align, style.bold, style.halo, theme_.background};
  const TextBox b = measure(t);
  out_.shapes.emplace_back(t);
  out_.labels.push_back({plain(markup), b, leads_to});
  return b;
}

std::vector<std::string> ChartInk::wrapped(const std::string& markup, double size, bool bold, double room) const {
  return viz::wrapped(markup, size, bold, room);
}

void ChartInk::line(const std::vector<Vec2>& points, const Colour& colour, double width, std::array<double, 2> dash,
                    bool round_cap) {
  out_.shapes.emplace_back(Stroke{polyline(points), colour, width, dash, round_cap});
}

void ChartInk::ring(const Vec2& middle, double radius, const Colour& colour, double width) {
  out_.shapes.emplace_back(Stroke{circle(middle, radius), colour, width, {0, 0}, false});
}

void ChartInk::fill(const std::vector<Vec2>& points, const Colour& colour) {
  out_.shapes.emplace_back(Fill{polyline(points, true), colour, 0, 0, {}});
}

void ChartInk::box(const Bounds& b, const Colour& colour) {
  fill({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}}, colour);
}

void ChartInk::place(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles, const Bounds& room) {
  out_.labels = place_labels(wanted, obstacles, room, theme_, out_.shapes, std::move(out_.labels));
}

void ChartInk::mark(Mark mark, const Vec2& at, Role role) { viz::mark(out_.shapes, mark, at, role, theme_); }

void ChartInk::glyph(Glyph glyph, const Vec2& at, double radius, const Colour& colour, bool hollow, bool open) {
  const Path path = outline_of(glyph, at, radius);
  const double pen = 0.75 * sizes().outline;
  out_.shapes.emplace_back(Stroke{path, theme_.background, pen + (open ? 1 : 2) * sizes().halo, {0, 0}, true});
  if (!(hollow && open)) out_.shapes.emplace_back(Fill{path, hollow ? theme_.background : colour, 0, 0, {}});
  out_.shapes.emplace_back(Stroke{path, colour, pen, {0, 0}, true});
}

double ScaleLine::at(double value) const {
  constexpr double zero_gap = 0.13;  // between zero's own line and the least value above it
  double share = 0;
  switch (scale_.kind) {
    case Scale::Kind::linear:
      share = (value - scale_.lo) / (scale_.hi - scale_.lo);
      break;
    case Scale::Kind::log:
      share = std::log(value / scale_.lo) / std::log(scale_.hi / scale_.lo);
      break;
    case Scale::Kind::log_zero:
      if (value > 0)
        share =
            zero_gap + (1 - zero_gap) * std::max(0.0, std::log(value / scale_.lo) / std::log(scale_.hi / scale_.lo));
      break;
  }
  return from_ + std::clamp(share, 0.0, 1.0) * (to_ - from_);
}

std::vector<std::pair<double, std::string>> ScaleLine::ticks(const ChartInk& ink, bool across) const {
  if (!scale_.ticks.empty()) return scale_.ticks;
  std::vector<std::vector<double>> choices;  // from dense to sparse
  if (scale_.kind == Scale::Kind::linear) {
    for (int k = -6; k <= 6; ++k)
      for (const double m : {1, 2, 5}) choices.push_back(linear_ticks(scale_.lo, scale_.hi, m * std::pow(10.0, k)));
  } else {
    for (const auto& of_decade : {std::vector<double>{1, 2, 3, 5}, {1, 2, 5}, {1, 3}, {1}})
      choices.push_back(log_ticks(scale_.lo, scale_.hi, of_decade, 1));
    const bool long_scale = scale_.hi > 200 * scale_.lo;  // whole decades alone
    if (long_scale || scale_.kind == Scale::Kind::log_zero) choices.erase(choices.begin(), choices.begin() + 3);
    for (int every = 2; every < 20; ++every) choices.push_back(log_ticks(scale_.lo, scale_.hi, {1}, every));
    if (scale_.kind == Scale::Kind::log_zero) {  // the lowest decade may stand too near to zero for a label
      std::vector<std::vector<double>> with_zero;
      for (std::vector<double>& values : choices) {
        values.insert(values.begin(), 0);
        with_zero.push_back(values);
        if (values.size() > 2) values.erase(values.begin() + 1), with_zero.push_back(values);
      }
      choices = with_zero;
    }
  }

  const double size = ink.sizes().axis, gap = across ? 0.55 * size : 1.1 * size;
  constexpr std::size_t most = 11;  // more are a ruler, however large the picture
  for (const std::vector<double>& values : choices) {
    bool fits = values.size() <= most;
    double end = -INFINITY;
    std::vector<std::pair<double, std::string>> ticks;
    const bool powers =
        std::ranges::any_of(values, [](double v) { return tick_text(v).find('^') != std::string::npos; });
    for (const double v : values) {
      const std::string text = powers && v == 1000 ? "10^{3}" : tick_text(v);
      fits = fits && !(powers && v > 1000 && text.find('^') == std::string::npos);  // no 2000 beside 10^4
      const double half = (across ? ink.width(text, size) : 0.7 * size) / 2;
      const double p = std::min(std::abs(at(v) - from_), std::abs(to_ - from_) + (across ? reach_ : INFINITY) - half);
      fits = fits && p - half >= end + gap;
      end = p + half;
      ticks.emplace_back(v, text);
    }
    if (fits && !ticks.empty()) return ticks;
  }
  return {};
}

Colour tinted(const Theme& theme, const Colour& ink, double share) {
  const Colour& b = theme.background;
  return {b.r + share * (ink.r - b.r), b.g + share * (ink.g - b.g), b.b + share * (ink.b - b.b), 1};
}

Colour colour_of(Tone tone, const Theme& theme) {
  if (theme.name == ThemeName::grey) {  // five greys, darkest where a verdict is wrong
    constexpr double levels[] = {0.03, 0.17, 1, 0.42, 0.85};
    return tinted(theme, hex(0), levels[static_cast<int>(tone)]);
  }
  switch (tone) {
    case Tone::first:
      return tinted(theme, theme.ink(Role::first), 0.26);
    case Tone::second:
      return tinted(theme, theme.ink(Role::second), 0.22);
    case Tone::on:
      return theme.ink(Role::text);
    case Tone::mild:
      return theme.ink(Role::highlight);
    case Tone::wrong:
      break;
  }
  return theme.ink(Role::miss);
}

std::array<double, 2> dash_of(int index, const Sizes& s) {
  constexpr std::array<double, 2> dashes[] = {{0, 0}, {6, 2.2}, {3.2, 1.8}, {1.6, 1.6}, {8, 1.4}, {2.2, 3.2}};
  const std::array<double, 2>& d = dashes[static_cast<std::size_t>(index) % std::size(dashes)];
  return {d[0] * s.outline, d[1] * s.outline};
}

std::string tick_text(double value) {
  const double exponent = value > 0 ? std::round(std::log10(value)) : 0;
  if (value > 0 && std::abs(value / std::pow(10.0, exponent) - 1) < 1e-9 && (exponent > 3 || exponent < -2))
    return fmt::format("10^{{{}{:.0f}}}", exponent < 0 ? "−" : "", std::abs(exponent));
  return fmt::format("{}{:g}", value < 0 ? "−" : "", std::abs(value));
}

namespace {

struct LegendRow {
  std::vector<std::size_t> entries;
  double width = 0;
};

double sample_width(const ChartInk& ink, const LegendEntry& e) {
  return e.dash ? 8 * ink.glyph_radius() : 2.6 * ink.glyph_radius();
}

std::vector<LegendRow> legend_rows(const ChartInk& ink, const std::vector<LegendEntry>& entries, double width) {
  const double between = 1.6 * ink.sizes().label;
  std::vector<LegendRow> rows(entries.empty() ? 0 : 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double own =
        sample_width(ink, entries[i]) + 0.45 * ink.sizes().label + ink.width(entries[i].name, ink.sizes().label);
    if (!rows.back().entries.empty() && rows.back().width + between + own > width) rows.emplace_back();
    rows.back().width += own + (rows.back().entries.empty() ? 0 : between);
    rows.back().entries.push_back(i);
  }
  return rows;
}

}  // namespace

double legend_height(const ChartInk& ink, const std::vector<LegendEntry>& entries, double width) {
  return 1.55 * ink.sizes().label * static_cast<double>(legend_rows(ink, entries, width).size());
}

void legend(ChartInk& ink, const std::vector<LegendEntry>& entries, const Vec2& corner, double width) {
  const double size = ink.sizes().label, r = ink.glyph_radius();
  ink.part("chart", "legend");
  double y = corner.y() + 1.1 * size;
  for (const LegendRow& row : legend_rows(ink, entries, width)) {
    double x = corner.x() + (width - row.width) / 2;
    for (const std::size_t i : row.entries) {
      const LegendEntry& e = entries[i];
      const double room = sample_width(ink, e), middle = y - 0.3 * size;
      if (e.dash) ink.line({{x, middle}, {x + room, middle}}, e.colour, ink.sizes().outline, *e.dash);
      if (e.tick)
        ink.line({{x + room / 2, middle - 1.3 * r}, {x + room / 2, middle + 1.3 * r}}, e.colour, ink.sizes().shared);
      else if (e.glyph)
        ink.glyph(*e.glyph, {x + room / 2, middle}, r, e.colour, e.hollow);
      else if (!e.dash) {
        const double h = 1.25 * r;
        const Bounds b = {x + room / 2 - h, middle - h, x + room / 2 + h, middle + h};
        ink.box(b, e.colour);
        ink.line({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}, {b.left, b.top}},
                 ink.theme().ink(Role::construction), ink.sizes().hairline);
      }
      const TextBox box = ink.text(e.name, {x + room + 0.45 * size, y}, {size});
      x += room + 0.45 * size + (box.right - box.left) + 1.6 * size;
    }
    y += 1.55 * size;
  }
}

}  // namespace isect::viz
