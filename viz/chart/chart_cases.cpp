// A map of cases: regions with their names inside, borders, the presets and the setting that is shown.

#include <algorithm>
#include <cmath>
#include <span>

#include "viz/chart/case_key.h"
#include "viz/chart/case_names.h"
#include "viz/chart/chart_parts.h"
#include "viz/compose/marks.h"
#include "viz/compose/paper.h"

namespace isect::viz {
namespace {

/// Returns a branch's colour: the background's for the first one, the objects' colours in turn for the others.
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

class PlaneOfCases {
 public:
  /// `names`: the text for each branch, one each.
  PlaneOfCases(ChartInk& ink, const Cases& cases, const Bounds& b, double room_for_numbers,
               std::vector<std::string> names)
      : ink_(ink),
        cases_(cases),
        names_(std::move(names)),
        b_(b),
        room_for_numbers_(room_for_numbers),
        x_(cases.x, b.left, b.right),
        y_(cases.y, b.bottom, b.top) {}

  /// Whether each name stands in its region, or right beside its setting.
  bool has_room_for_names() const {
    CaseNames room(cases_, b_);
    keep_off_marks(room);
    std::vector<int> order;
    for (int i = 0; i < branches(); ++i)
      if (!is_thin(cases_, i)) order.push_back(i);
    return arranged(order, true, room).in_place || arranged(order, false, room).in_place;
  }

  void draw() {
    regions();
    ink_.part("chart", "borders");
    for (const std::vector<Vec2>& border : cases_.borders)
      ink_.line(placed(border), ink_.theme().ink(Role::text), 0.6 * ink_.sizes().outline);
    ink_.part("chart", "setting");
    here();
    ink_.part("chart", "names");
    if (cases_.named == Cases::Named::all) names();
    if (cases_.named == Cases::Named::within) names_within();
    ink_.part("chart", "presets");
    for (const bool thin : {false, true})  // those of lines and points above the others
      for (const Cases::Spot& preset : cases_.presets)
        if (!is_here(preset) && is_thin(cases_, preset.branch) == thin)
          ink_.mark(thin ? Mark::diamond : Mark::uncounted, at(preset.at), thin ? Role::highlight : Role::muted);
    ink_.part("chart", "setting");
    if (cases_.here) ink_.mark(Mark::double_disc, at(cases_.here->at), Role::text);
  }

  /// Writes a number of an axis: beside a marker that would cover it, or not at all.
  void number(const std::string& text, const Vec2& place, double align) {
    const double size = ink_.sizes().axis, width = ink_.width(text, size);
    Vec2 to = place;
    for (const auto& [p, radius] : markers()) {
      const double left = to.x() - align * width;
      const Vec2 nearest = p.cwiseMax(Vec2(left, to.y() - 0.75 * size)).cwiseMin(Vec2(left + width, to.y()));
      if ((nearest - p).norm() >= radius + 0.5 * ink_.sizes().label_clear) continue;
      if (align < 1 || p.x() - radius - width < b_.left - room_for_numbers_) return;
      to.x() = p.x() - radius - 0.5 * ink_.sizes().label_clear;
    }
    ink_.text(text, to, {size, Role::muted, align});
  }

 private:
  Vec2 at(const Vec2& p) const { return {x_.at(p.x()), y_.at(p.y())}; }
  std::vector<Vec2> placed(const std::vector<Vec2>& points) const {
    std::vector<Vec2> all;
    for (const Vec2& p : points) all.push_back(at(p));
    return all;
  }
  bool is_here(const Cases::Spot& preset) const { return cases_.here && cases_.here->at == preset.at; }

  /// Fills the regions. Each patch reaches a little under the one above it and right of it, so that no seam shows.
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

  /// Draws dashed lines from the axes to the setting.
  void here() {
    if (!cases_.here) return;
    const Sizes& s = ink_.sizes();
    const Vec2 p = at(cases_.here->at);
    const Colour& colour = ink_.theme().ink(Role::construction);
    ink_.line({{p.x(), b_.bottom}, p}, colour, s.construction, s.construction_dash);
    ink_.line({{b_.left, p.y()}, p}, colour, s.construction, s.construction_dash);
  }

  /// Writes names of lines, then of regions; in another order if a leader would cross another leader or a name.
  void names() {
    CaseNames room(cases_, b_);
    keep_off_marks(room);
    std::vector<int> within, beside;
    for (int i = 0; i < branches(); ++i)
      if (!is_thin(cases_, i)) (room.place(i, size_of_name(i)).leads_to ? beside : within).push_back(i);
    std::vector<int> order(within.size() + beside.size());
    std::ranges::merge(within, beside, order.begin());

    Names best = arranged(order, true, room);
    for (int tried = 0; tried < 4 && best.cost >= CaseNames::crossed; ++tried) {
      if (tried == 2) std::ranges::reverse(beside);
      std::ranges::copy(beside, std::ranges::copy(within, order.begin()).out);
      constexpr double tie = 1e-3;  // what only rounding could decide
      if (Names other = arranged(order, tried % 2 == 0, room); other.cost < best.cost - tie) best = std::move(other);
    }
    if (best.lines_first) ink_.place(names_of_lines(), obstacles(ink_.labels()), b_);
    for (const auto& [branch, place] : best.places) write(branch, place);
    if (!best.lines_first) ink_.place(names_of_lines(), obstacles(ink_.labels()), b_);
  }

  void names_within() {
    CaseNames room(cases_, b_);
    keep_off_marks(room);
    for (int i = 0; i < branches(); ++i) {
      if (is_thin(cases_, i)) continue;
      const NamePlace place = room.place(i, size_of_name(i));
      if (!place.leads_to) room.take(grown(write(i, place), ink_.sizes().label_clear));
    }
  }

  /// Where the names of regions go, and whether before or after those of lines.
  struct Names {
    std::vector<std::pair<int, NamePlace>> places = {};
    bool lines_first = true;
    double cost = 0;
    bool in_place = true;  ///< without a leader, and on no border
  };

  Names arranged(const std::vector<int>& order, bool lines_first, CaseNames room) const {
    Names all = {{}, lines_first, 0, true};
    std::vector<PlacedLabel> there = ink_.labels();
    const auto lines = [&] {
      std::vector<Shape> unseen;
      const std::size_t before = there.size();
      there = place_labels(names_of_lines(), obstacles(there), b_, ink_.theme(), unseen, std::move(there));
      for (const PlacedLabel& label : std::span(there).subspan(before)) {
        all.in_place = all.in_place && !label.leads_to;
        if (label.leads_to) all.cost += room.in_the_way(nearest_in(label.box, *label.leads_to), *label.leads_to);
        take(room, label);
      }
    };
    if (lines_first) lines();
    for (const int branch : order) {
      const NamePlace place = room.place(branch, size_of_name(branch));
      there.push_back({{}, box_around(place.middle, size_of_name(branch) / 2), place.leads_to});
      take(room, there.back());
      all.places.emplace_back(branch, place);
      all.cost += place.cost;
      all.in_place = all.in_place && !place.leads_to && !place.on_border;
    }
    if (!lines_first) lines();
    return all;
  }

  void take(CaseNames& room, const PlacedLabel& label) const {
    room.take(grown(label.box, ink_.sizes().label_clear));
    if (label.leads_to) room.take_leader(nearest_in(label.box, *label.leads_to), *label.leads_to);
  }

  /// Returns the names of branches that are only a line or a point, each beside a setting that lies there.
  std::vector<Wanted> names_of_lines() const {
    std::vector<Wanted> all;
    for (int i = 0; i < branches(); ++i)
      if (const Cases::Spot* spot = is_thin(cases_, i) ? first_on(i) : nullptr)
        all.push_back({names_[i], at(spot->at), at(spot->at), mark_radius(Mark::diamond, ink_.sizes()),
                       ink_.theme().ink(ink_.theme().name == ThemeName::grey ? Role::text : Role::muted), no_object,
                       others(*spot)});
    return all;
  }

  /// Returns where settings other than this one are marked.
  std::vector<Vec2> others(const Cases::Spot& spot) const {
    std::vector<Vec2> all;
    for (const auto& [p, radius] : markers())
      if ((p - at(spot.at)).norm() > radius) all.push_back(p);
    return all;
  }

  Vec2 size_of_name(int branch) const {
    const Sizes& s = ink_.sizes();
    return {ink_.width(names_[branch], s.label) + 0.5 * s.label, 1.4 * s.label};
  }

  /// Writes a region's name, with its leader if it has one.
  TextBox write(int branch, const NamePlace& place) {
    const Sizes& s = ink_.sizes();
    if (place.leads_to) {
      const Vec2& to = *place.leads_to;
      ink_.line({nearest_in(box_around(place.middle, size_of_name(branch) / 2), to), to}, ink_.theme().ink(Role::text),
                s.leader);
      ink_.glyph(Glyph::disc, to, 0.4 * s.disc, ink_.theme().ink(Role::text), false);
    }
    const double halo = place.on_border ? s.label_halo : 0;
    const Vec2 baseline = place.middle + Vec2(0, 0.33 * s.label);
    return ink_.text(names_[branch], baseline, {s.label, Role::text, 0.5, false, halo}, place.leads_to);
  }

  int branches() const { return static_cast<int>(cases_.branches.size()); }
  /// Returns a marked setting on this branch.
  const Cases::Spot* first_on(int branch) const {
    const auto preset = std::ranges::find(cases_.presets, branch, &Cases::Spot::branch);
    if (preset != cases_.presets.end()) return &*preset;
    return cases_.here && cases_.here->branch == branch ? &*cases_.here : nullptr;
  }

  /// Keeps names off the markers, and off the dashed lines to the setting.
  void keep_off_marks(CaseNames& places) const {
    const double clear = ink_.sizes().label_clear, r = mark_radius(Mark::double_disc, ink_.sizes()) + clear;
    for (const Cases::Spot& preset : cases_.presets) places.take(box_around(at(preset.at), {r, r}));
    if (!cases_.here) return;
    const Vec2 p = at(cases_.here->at);
    places.take(box_around(p, {r, r}));
    places.take({p.x() - clear, p.y(), p.x() + clear, b_.bottom}, true);
    places.take({b_.left, p.y() - clear, p.x(), p.y() + clear}, true);
  }

  /// Returns all markers, with their radii.
  std::vector<std::pair<Vec2, double>> markers() const {
    std::vector<std::pair<Vec2, double>> all;
    for (const Cases::Spot& preset : cases_.presets)
      if (!is_here(preset))
        all.emplace_back(at(preset.at),
                         mark_radius(is_thin(cases_, preset.branch) ? Mark::diamond : Mark::uncounted, ink_.sizes()));
    if (cases_.here) all.emplace_back(at(cases_.here->at), mark_radius(Mark::double_disc, ink_.sizes()));
    return all;
  }

  std::vector<Obstacle> obstacles(const std::vector<PlacedLabel>& there) const {
    const Sizes& s = ink_.sizes();
    std::vector<Obstacle> all;
    for (const PlacedLabel& label : there)
      if (label.leads_to) all.push_back({nearest_in(label.box, *label.leads_to), *label.leads_to, s.leader, true});
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
  const std::vector<std::string> names_;
  const Bounds b_;
  const double room_for_numbers_;  ///< left of the plane
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
  /// The height that further lines add, in sizes of their text.
  double above() const { return pitch * (std::max<double>(static_cast<double>(y.size()), 1) - 1); }
  double below() const { return pitch * (std::max<double>(static_cast<double>(x.size()), 1) - 1); }
};

Bounds plane_above(const ChartInk& ink, const Cases& cases, const Bounds& room, double key) {
  const double axis = ink.sizes().axis;
  const Titles titles(ink, cases, room.right - room.left);
  const Bounds b = {room.left + left_of(ink, cases), room.top + (1.9 + titles.above()) * axis, room.right - axis,
                    room.bottom - (3.4 + titles.below()) * axis - key};
  if (!cases.one_scale) return b;
  const Vec2 size(cases.x.hi - cases.x.lo, cases.y.hi - cases.y.lo), place(b.right - b.left, b.bottom - b.top);
  const Vec2 spare = (place - place.cwiseQuotient(size).minCoeff() * size) / 2;
  return {b.left + spare.x(), b.top + spare.y(), b.right - spare.x(), b.bottom - spare.y()};
}

/// Returns a key on paper if some name has no place; not on a map as wide as a page, which has room for leaders.
std::optional<CaseKey> key_for(const ChartInk& ink, const Cases& cases, const Bounds& room) {
  constexpr double roomy = 40;  // in sizes of the names
  if (!has_one_size(ink.theme()) || cases.named != Cases::Named::all) return {};
  if (room.right - room.left >= roomy * ink.sizes().label) return {};
  ChartInk unseen(ink.theme());
  const Bounds b = plane_above(ink, cases, room, 0);
  if (!(b.right > b.left && b.bottom > b.top)) return {};
  if (PlaneOfCases(unseen, cases, b, left_of(ink, cases), cases.branches).has_room_for_names()) return {};
  return CaseKey(ink, cases, room.right - room.left);
}

double height_without_key(const ChartInk& ink, const Cases& cases, double width) {
  const Titles titles(ink, cases, width - 2 * ink.sizes().margin);
  const double axis = ink.sizes().axis, across = width - left_of(ink, cases) - axis;
  const double plane = cases.one_scale ? across * (cases.y.hi - cases.y.lo) / (cases.x.hi - cases.x.lo) : 0.58 * width;
  return std::min(plane, 0.8 * width) + (5.3 + titles.above() + titles.below()) * axis;
}

}  // namespace

Bounds plane_within(const ChartInk& ink, const Cases& cases, const Bounds& room) {
  const std::optional<CaseKey> key = key_for(ink, cases, room);
  return plane_above(ink, cases, room, key ? key->height(ink) : 0);
}

double natural_height(const ChartInk& ink, const Cases& cases, double width) {
  const double height = height_without_key(ink, cases, width);
  const std::optional<CaseKey> key = key_for(ink, cases, {0, 0, width, height});
  return height + (key ? key->height(ink) : 0);
}

void draw(ChartInk& ink, const Cases& cases, const Bounds& room) {
  const Sizes& s = ink.sizes();
  const Theme& t = ink.theme();
  const std::optional<CaseKey> key = key_for(ink, cases, room);
  const Bounds b = plane_above(ink, cases, room, key ? key->height(ink) : 0);
  PlaneOfCases plane(ink, cases, b, left_of(ink, cases), key ? key->numbers() : cases.branches);
  plane.draw();
  ink.part("chart", "scales");
  ink.line({{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}, {b.left, b.top}},
           t.ink(Role::construction), s.hairline);

  const ScaleLine x(cases.x, b.left, b.right, s.axis), y(cases.y, b.bottom, b.top);
  for (const auto& [value, text] : y.ticks(ink, false))
    plane.number(text, {b.left - s.label_clear, y.at(value) + 0.33 * s.axis}, 1);
  for (const auto& [value, text] : x.ticks(ink, true)) plane.number(text, {x.at(value), b.bottom + 1.3 * s.axis}, 0.5);
  const Titles titles(ink, cases, room.right - room.left);
  const double left = b.left - left_of(ink, cases), above = b.top - (1.9 + titles.above()) * s.axis;
  for (std::size_t i = 0; i < titles.y.size(); ++i)
    ink.text(titles.y[i], {left, above + (1 + Titles::pitch * static_cast<double>(i)) * s.axis}, {s.axis, Role::muted});
  const double middle = titles.x.size() > 1 ? (room.left + room.right) / 2 : (b.left + b.right) / 2;
  for (std::size_t i = 0; i < titles.x.size(); ++i)
    ink.text(titles.x[i], {middle, b.bottom + (2.7 + Titles::pitch * static_cast<double>(i)) * s.axis},
             {s.axis, Role::muted, 0.5});
  if (key) key->draw(ink, room.left, room.right, b.bottom + (3.1 + titles.below()) * s.axis);
}

}  // namespace isect::viz
