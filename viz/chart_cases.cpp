// A map of cases: regions with their names inside, borders, the presets and the setting that is shown.

#include <algorithm>
#include <cmath>

#include "viz/chart_parts.h"
#include "viz/marks.h"
#include "viz/rich_text.h"

namespace isect::viz {
namespace {

/// The first branch keeps the background; the others take the objects' colours in turn.
Colour colour_of(int branch, const Theme& theme) {
  if (theme.name == ThemeName::grey) {
    constexpr double levels[] = {0, 0.2, 0.09, 0.27, 0.04, 0.15, 0.12, 0.3};
    return tinted(theme, hex(0), levels[static_cast<std::size_t>(branch) % std::size(levels)]);
  }
  constexpr std::pair<Role, double> inks[] = {{Role::grid, 0},        {Role::first, 0.22}, {Role::second, 0.22},
                                              {Role::hit, 0.26},      {Role::miss, 0.2},   {Role::construction, 0.25},
                                              {Role::highlight, 0.4}, {Role::text, 0.1}};
  const auto& [role, share] = inks[static_cast<std::size_t>(branch) % std::size(inks)];
  return tinted(theme, theme.ink(role), share);
}

/// A branch that is only a line or a point of the plane.
bool is_thin(const Cases& cases, int branch) {
  return std::ranges::none_of(cases.patches, [&](const Cases::Patch& patch) { return patch.branch == branch; });
}

/// Where in the plane a name has most room around it: the middle of the largest box of its shape that lies in its
/// region.
struct Room {
  Vec2 middle;       ///< in cells
  double scale = 0;  ///< of that box to the name's; below 1 it does not fit
};

class Cells {
 public:
  explicit Cells(const Cases& cases, int branch) : columns_(cases.columns), rows_(cases.rows) {
    sums_.assign(static_cast<std::size_t>(columns_ + 1) * (rows_ + 1), 0);
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x)
        at(x + 1, y + 1) = (cases.cells[static_cast<std::size_t>(y) * columns_ + x] == branch) + at(x, y + 1) +
                           at(x + 1, y) - at(x, y);
  }

  /// Keeps names off a marker, `half` its size in cells.
  void take(const Vec2& middle, const Vec2& half) { taken_.push_back({middle - half, middle + half}); }
  /// `name`: its width and height, in cells.
  Room largest(const Vec2& name) {
    Room best;
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        if (count(x, y, x + 1, y + 1) == 0) continue;
        const Vec2 middle(x + 0.5, y + 0.5);
        double lo = 0, hi = 8;
        for (int i = 0; i < 7; ++i) {
          const double scale = (lo + hi) / 2;
          (filled(middle, scale / 2 * name) ? lo : hi) = scale;
        }
        if (lo > best.scale || best.scale == 0) best = {middle, lo};
      }
    return best;
  }

 private:
  int& at(int x, int y) { return sums_[static_cast<std::size_t>(y) * (columns_ + 1) + x]; }
  int count(int x0, int y0, int x1, int y1) { return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0); }
  /// What only rounding could decide counts as filled: a name's place is the same however a machine rounds.
  bool filled(const Vec2& middle, const Vec2& half) {
    const Vec2 slack = Vec2::Constant(1e-6), lo = middle - half + slack, hi = middle + half - slack;
    for (const Box2& b : taken_)
      if ((lo.array() < b.hi.array()).all() && (b.lo.array() < hi.array()).all()) return false;
    const int x0 = static_cast<int>(std::floor(lo.x())), y0 = static_cast<int>(std::floor(lo.y())),
              x1 = static_cast<int>(std::ceil(hi.x())), y1 = static_cast<int>(std::ceil(hi.y()));
    if (x0 < 0 || y0 < 0 || x1 > columns_ || y1 > rows_) return false;
    return count(x0, y0, x1, y1) == (x1 - x0) * (y1 - y0);
  }

  int columns_, rows_;
  std::vector<int> sums_;
  std::vector<Box2> taken_;
};

class PlaneOfCases {
 public:
  PlaneOfCases(ChartInk& ink, const Cases& cases, const Bounds& b)
      : ink_(ink), cases_(cases), b_(b), x_(cases.x, b.left, b.right), y_(cases.y, b.bottom, b.top) {}

  void draw() {
    regions();
    ink_.part("chart", "borders");
    for (const std::vector<Vec2>& border : cases_.borders)
      ink_.line(placed(border), ink_.theme().ink(Role::text), 0.6 * ink_.sizes().outline);
    ink_.part("chart", "setting");
    here();
    ink_.part("chart", "names");
    names();
    ink_.part("chart", "presets");
    for (const Cases::Spot& preset : cases_.presets)
      if (!is_here(preset)) {
        const bool thin = is_thin(cases_, preset.branch);
        ink_.mark(thin ? Mark::diamond : Mark::uncounted, at(preset.at), thin ? Role::highlight : Role::muted);
      }
    ink_.part("chart", "setting");
    if (cases_.here) ink_.mark(Mark::double_disc, at(cases_.here->at), Role::text);
  }

 private:
  Vec2 at(const Vec2& p) const { return {x_.at(p.x()), y_.at(p.y())}; }
  std::vector<Vec2> placed(const std::vector<Vec2>& points) const {
    std::vector<Vec2> all;
    for (const Vec2& p : points) all.push_back(at(p));
    return all;
  }
  bool is_here(const Cases::Spot& preset) const { return cases_.here && cases_.here->at == preset.at; }

  /// Each patch reaches a little under the one above it and right of it, so that no seam shows.
  void regions() {
    const double over = 0.35 * ink_.sizes().hairline;
    for (const Cases::Patch& patch : cases_.patches) {
      if (patch.branch == 0) continue;
      const auto& [a, b, c, d] = patch.corners;
      ink_.part("region", cases_.branches[patch.branch]);
      ink_.fill(
          {at(a) + Vec2(-over, over), at(b) + Vec2(over, over), at(c) + Vec2(over, -over), at(d) + Vec2(-over, -over)},
          colour_of(patch.branch, ink_.theme()));
    }
  }

  /// Dashed lines from the axes to the setting.
  void here() {
    if (!cases_.here) return;
    const Sizes& s = ink_.sizes();
    const Vec2 p = at(cases_.here->at);
    const Colour& colour = ink_.theme().ink(Role::construction);
    ink_.line({{p.x(), b_.bottom}, p}, colour, s.construction, s.construction_dash);
    ink_.line({{b_.left, p.y()}, p}, colour, s.construction, s.construction_dash);
  }

  /// In the region where there is room; that of a line or a point beside a preset that lies there.
  void names() {
    const Sizes& s = ink_.sizes();
    std::vector<Wanted> wanted;
    for (int i = 0; i < static_cast<int>(cases_.branches.size()); ++i) {
      const std::string& name = cases_.branches[i];
      if (is_thin(cases_, i)) {
        const auto preset = std::ranges::find(cases_.presets, i, &Cases::Spot::branch);
        if (preset == cases_.presets.end()) continue;
        wanted.push_back({name, at(preset->at), at(preset->at), mark_radius(Mark::diamond, s),
                          ink_.theme().ink(ink_.theme().name == ThemeName::grey ? Role::text : Role::muted)});
        continue;
      }
      const Vec2 size(ink_.width(name, s.label) + 0.6 * s.label, 1.7 * s.label);
      const auto [middle, fits] = room_for(i, size);
      if (fits)
        ink_.text(name, middle + Vec2(0, 0.33 * s.label), {s.label, Role::text, 0.5});
      else
        wanted.push_back({name, middle, middle, 0, ink_.theme().ink(Role::text)});
    }
    ink_.place(wanted, obstacles(), b_);
  }

  std::pair<Vec2, bool> room_for(int branch, const Vec2& size) const {
    const Vec2 cell((b_.right - b_.left) / cases_.columns, (b_.bottom - b_.top) / cases_.rows);
    const double r = mark_radius(Mark::double_disc, ink_.sizes()) + ink_.sizes().label_clear;
    Cells cells(cases_, branch);
    const auto take = [&](const Cases::Spot& spot) {
      const Vec2 p = at(spot.at) - Vec2(b_.left, b_.bottom);
      cells.take(Vec2(p.x(), -p.y()).cwiseQuotient(cell), Vec2(r, r).cwiseQuotient(cell));
    };
    for (const Cases::Spot& preset : cases_.presets) take(preset);
    if (cases_.here) {
      take(*cases_.here);
      const Vec2 p = Vec2(at(cases_.here->at) - Vec2(b_.left, b_.top)).cwiseQuotient(cell);
      const double y = cases_.rows - p.y();
      cells.take(Vec2(p.x(), y / 2), Vec2(0.1, y / 2));  // the dashed lines
      cells.take(Vec2(p.x() / 2, y), Vec2(p.x() / 2, 0.1));
    }
    const Room room = cells.largest(size.cwiseQuotient(cell));
    return {{b_.left + room.middle.x() * cell.x(), b_.bottom - room.middle.y() * cell.y()}, room.scale >= 1};
  }

  std::vector<Obstacle> obstacles() const {
    const Sizes& s = ink_.sizes();
    std::vector<Obstacle> all;
    const auto marker = [&](const Cases::Spot& spot, Mark mark) {
      all.push_back({at(spot.at), at(spot.at), mark_radius(mark, s), true});
    };
    for (const Cases::Spot& preset : cases_.presets) marker(preset, Mark::uncounted);
    if (cases_.here) {
      const Vec2 p = at(cases_.here->at);
      marker(*cases_.here, Mark::double_disc);
      all.push_back({{p.x(), b_.bottom}, p, 0.5 * s.construction, true});
      all.push_back({{b_.left, p.y()}, p, 0.5 * s.construction, true});
    }
    for (const std::vector<Vec2>& border : cases_.borders)
      for (std::size_t i = 1; i < border.size(); ++i)
        all.push_back({at(border[i - 1]), at(border[i]), 0.3 * s.outline, false});
    return all;
  }

  ChartInk& ink_;
  const Cases& cases_;
  const Bounds b_;
  const ScaleLine x_, y_;
};

double left_of(const ChartInk& ink, const Cases& cases) {
  double widest = 0;
  for (const auto& [value, text] : ScaleLine(cases.y, 1e3, 0).ticks(ink, false))
    widest = std::max(widest, ink.width(text, ink.sizes().axis));
  return widest + ink.sizes().label_clear + 0.35 * ink.sizes().axis;
}

/// The titles of both scales, on as many lines as they need in a narrow chart.
struct Titles {
  std::vector<std::string> x, y;
  static constexpr double pitch = 1.25;

  Titles(const ChartInk& ink, const Cases& cases, double room)
      : x(ink.wrapped(cases.x.title, ink.sizes().axis, false, room)),
        y(ink.wrapped(cases.y.title, ink.sizes().axis, false, room)) {}
  /// What further lines add, in sizes of their text.
  double above() const { return pitch * (std::max<double>(static_cast<double>(y.size()), 1) - 1); }
  double below() const { return pitch * (std::max<double>(static_cast<double>(x.size()), 1) - 1); }
};

}  // namespace

Bounds plane_within(const ChartInk& ink, const Cases& cases, const Bounds& room) {
  const double axis = ink.sizes().axis;
  const Titles titles(ink, cases, room.right - room.left);
  return {room.left + left_of(ink, cases), room.top + (1.9 + titles.above()) * axis, room.right - axis,
          room.bottom - (3.4 + titles.below()) * axis};
}

double natural_height(const ChartInk& ink, const Cases& cases, double width) {
  const Titles titles(ink, cases, width - 2 * ink.sizes().margin);
  return 0.58 * width + (5.3 + titles.above() + titles.below()) * ink.sizes().axis;
}

void draw(ChartInk& ink, const Cases& cases, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const Theme& t = ink.theme();
  const Bounds b = plane_within(ink, cases, room);
  PlaneOfCases(ink, cases, b).draw();
  ink.part("chart", "scales");
  ink.line({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}, {b.left, b.top}},
           t.ink(Role::construction), s.hairline);

  const ScaleLine x(cases.x, b.left, b.right, s.axis), y(cases.y, b.bottom, b.top);
  for (const auto& [value, text] : y.ticks(ink, false))
    ink.text(text, {b.left - s.label_clear, y.at(value) + 0.33 * s.axis}, {s.axis, Role::muted, 1});
  for (const auto& [value, text] : x.ticks(ink, true))
    ink.text(text, {x.at(value), b.bottom + 1.3 * s.axis}, {s.axis, Role::muted, 0.5});
  const Titles titles(ink, cases, room.right - room.left);
  for (std::size_t i = 0; i < titles.y.size(); ++i)
    ink.text(titles.y[i], {room.left, room.top + (1 + Titles::pitch * static_cast<double>(i)) * s.axis},
             {s.axis, Role::muted});
  const double middle = titles.x.size() > 1 ? (room.left + room.right) / 2 : (b.left + b.right) / 2;
  for (std::size_t i = 0; i < titles.x.size(); ++i)
    ink.text(titles.x[i], {middle, b.bottom + (2.7 + Titles::pitch * static_cast<double>(i)) * s.axis},
             {s.axis, Role::muted, 0.5});
}

}  // namespace isect::viz
