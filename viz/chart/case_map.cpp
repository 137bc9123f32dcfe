#include "viz/chart/case_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "viz/lang/message.h"

namespace isect::viz {
namespace {

constexpr int map_columns = 60, map_rows = 36;

/// One level of the plane: from left to right, `branches[i]` up to `cuts[i]`, and the last one up to the end.
struct Level {
  double y = 0;
  std::vector<double> cuts;
  std::vector<int> branches;

  int at(double x) const {
    std::size_t i = 0;
    while (i < cuts.size() && !(x < cuts[i])) ++i;
    return branches[i];
  }
  bool has_cut(double left, double right) const {
    return std::ranges::any_of(cuts, [&](double cut) { return left <= cut && cut <= right; });
  }
};

class Sweep {
 public:
  Sweep(const CaseMap& map, const Parameters& here, Cases& out) : map_(map), here_(here), out_(out) {}

  /// Does a level line, or the strip between two of them; returns false if that was the last one.
  bool next() {
    if (const auto j = static_cast<int>(levels_.size()); j <= map_rows) {
      const double step = (map_.hi.y() - map_.lo.y()) / map_rows;
      levels_.push_back(level(j == map_rows ? map_.hi.y() : map_.lo.y() + j * step));
      return true;
    }
    const int j = row_++;
    between(levels_[j], levels_[j + 1], bent_at(j) || bent_at(j + 1), 7);
    if (row_ < map_rows) return true;
    end_borders();
    return false;
  }

 private:
  static constexpr double off = 1.234e-5;  // a share of width and height

  double width() const { return map_.hi.x() - map_.lo.x(); }
  double abscissa(double i) const { return map_.lo.x() + i * width() / map_columns; }
  int branch(double x, double y) const { return map_.branch(map_.moved(here_, {x, y})); }

  /// Two levels that another one lies between.
  struct Around {
    const Level &below, &above;

    /// Whether both levels have one and the same branch within `wide` of x: then so has any level between them.
    bool agree(double x, double wide) const {
      return below.at(x) == above.at(x) && !below.has_cut(x - wide, x + wide) && !above.has_cut(x - wide, x + wide);
    }
  };

  /// Returns one place per column and, between two levels, some more in each of their narrow regions, which may become
  /// narrower. They avoid round numbers, where lines and points of the plane have branches of their own.
  std::vector<double> samples(const Around* around) const {
    std::vector<double> places;
    for (int i = 0; i <= map_columns; ++i) places.push_back(abscissa(i) + (i == map_columns ? -off : off) * width());
    if (!around) return places;
    for (const Level* level : {&around->below, &around->above})
      for (std::size_t i = 1; i < level->cuts.size(); ++i)
        if (const double from = level->cuts[i - 1], to = level->cuts[i]; to - from < 2 * width() / map_columns)
          for (const double share : {1 / 16.0, 1 / 4.0, 1 / 2.0, 3 / 4.0, 15 / 16.0})
            places.push_back(from + (share + off) * (to - from));
    std::ranges::sort(places);
    return places;
  }

  Level level(double y, const Around* around = nullptr) const {
    Level l{y, {}, {}};
    const double at = y + off * (y == map_.hi.y() ? -1 : 1) * (map_.hi.y() - map_.lo.y());
    const std::vector<double> places = samples(around);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double x = places[i];
      const int there = around && around->agree(x, width() / map_columns) ? around->below.at(x) : branch(x, at);
      if (i == 0) l.branches.push_back(there);
      for (int thinner = 0; l.branches.back() != there && thinner < 4; ++thinner) {
        const double left = l.cuts.empty() ? places[i - 1] : std::max(places[i - 1], l.cuts.back());
        l.cuts.push_back(end_of(l.branches.back(), left, x, at));
        l.branches.push_back(branch(l.cuts.back(), at));
      }
      if (l.branches.back() != there) l.branches.back() = there;
    }
    return l;
  }

  /// Returns the first place found that has another branch, between `left`, where it is `before`, and `right`.
  double end_of(int before, double left, double right, double y) const {
    for (int i = 0; i < 12; ++i) {
      const double middle = (left + right) / 2;
      (branch(middle, y) == before ? left : right) = middle;
    }
    return right;
  }

  /// Whether a border bends visibly at the middle one of three levels; true if the levels have different branches.
  bool bent(const Level& below, const Level& middle, const Level& above) const {
    if (below.branches != middle.branches || middle.branches != above.branches) return true;
    for (std::size_t i = 0; i < middle.cuts.size(); ++i)
      if (std::abs(below.cuts[i] - 2 * middle.cuts[i] + above.cuts[i]) > 0.003 * width()) return true;
    return false;
  }

  bool bent_at(int j) const { return j > 0 && j < map_rows && bent(levels_[j - 1], levels_[j], levels_[j + 1]); }

  /// Fills the strip between two levels. `turns`: a border may bend in it, at a corner or along a curve.
  void between(const Level& below, const Level& above, bool turns, int depth) {
    const bool alike = below.branches == above.branches;
    double moved = 0;  // of the cut that moves most
    if (alike)
      for (std::size_t i = 0; i < below.cuts.size(); ++i)
        moved = std::max(moved, std::abs(below.cuts[i] - above.cuts[i]));
    if (depth > 0 && (!alike || turns || moved > 2.5 * width() / map_columns)) {
      const Around around = {below, above};
      const Level middle = level((below.y + above.y) / 2, &around);
      const bool still = bent(below, middle, above);
      between(below, middle, still, depth - 1);
      between(middle, above, still, depth - 1);
    } else if (alike) {
      strip(below, above);
    } else {
      step(below, above);
    }
  }

  void strip(const Level& below, const Level& above) {
    for (std::size_t i = 0; i < below.branches.size(); ++i) {
      const double a = i == 0 ? map_.lo.x() : below.cuts[i - 1], b = i == 0 ? map_.lo.x() : above.cuts[i - 1];
      const bool last = i == below.cuts.size();
      const double c = last ? map_.hi.x() : below.cuts[i], d = last ? map_.hi.x() : above.cuts[i];
      out_.patches.push_back(
          {{Vec2(a, below.y), Vec2(c, below.y), Vec2(d, above.y), Vec2(b, above.y)}, below.branches[i]});
    }
    if (open_.size() != below.cuts.size()) end_borders();
    open_.resize(below.cuts.size());
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (open_[i].empty()) open_[i].emplace_back(below.cuts[i], below.y);
      open_[i].emplace_back(above.cuts[i], above.y);
    }
  }

  /// Lets regions that begin or end between the levels go on to the middle, where the borders run across.
  void step(const Level& below, const Level& above) {
    const double y = (below.y + above.y) / 2;
    Level up = below, down = above;
    up.y = y, down.y = y;
    strip(below, up);
    end_borders();
    std::vector<double> ends = {map_.lo.x(), map_.hi.x()};
    ends.insert(ends.end(), below.cuts.begin(), below.cuts.end());
    ends.insert(ends.end(), above.cuts.begin(), above.cuts.end());
    std::ranges::sort(ends);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double middle = (ends[i - 1] + ends[i]) / 2;
      if (below.at(middle) != above.at(middle)) out_.borders.push_back({Vec2(ends[i - 1], y), Vec2(ends[i], y)});
    }
    strip(down, above);
  }

  void end_borders() {
    for (std::vector<Vec2>& border : open_)
      if (border.size() > 1) out_.borders.push_back(std::move(border));
    open_.clear();
  }

  const CaseMap& map_;
  const Parameters& here_;
  Cases& out_;
  std::vector<Level> levels_;
  int row_ = 0;                          ///< of those between two levels
  std::vector<std::vector<Vec2>> open_;  ///< one for each cut, while the sequence stays the same
};

/// Returns a few round numbers for the ticks: multiples of halves, ones, twos or fives.
std::vector<std::pair<double, std::string>> ticks(double lo, double hi) {
  double step = 0.5;
  for (const double wider : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if ((hi - lo) / step > 6) step = wider;
  std::vector<std::pair<double, std::string>> ticks;
  for (double k = std::ceil(lo / step); k * step <= hi; ++k) ticks.emplace_back(k * step, shown(k * step + 0.0));
  return ticks;
}

bool within(const CaseMap& map, const Vec2& p) {
  return (p.array() >= map.lo.array()).all() && (p.array() <= map.hi.array()).all();  // not where NaN
}

/// Returns the branches at a place and closely around it; the other parameters are those of `setting`.
std::set<int> around(const CaseMap& map, const Parameters& setting, const Vec2& at) {
  std::set<int> branches;
  for (const Vec2& d : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
    branches.insert(map.branch(map.moved(setting, at + 1e-9 * d.cwiseProduct(map.hi - map.lo))));
  return branches;
}

/// Whether a preset belongs on the map of `here`: its place has the same branch there, or lies on the same border,
/// where rounding may take it to either side.
bool belongs(const CaseMap& map, const Parameters& here, const Parameters& preset, const Vec2& at) {
  const int branch = map.branch(preset);
  const std::set<int> there = around(map, here, at);
  if (there.size() == 1) return map.branch(map.moved(here, at)) == branch;
  return there == around(map, preset, at);
}

/// Returns the map without its regions, and without the presets on it.
Cases map_without_regions(const CaseMap& map, const Parameters& here) {
  Cases cases;
  cases.x = {Scale::Kind::linear, map.lo.x(), map.hi.x(), map.x_title, ticks(map.lo.x(), map.hi.x())};
  cases.y = {Scale::Kind::linear, map.lo.y(), map.hi.y(), map.y_title, ticks(map.lo.y(), map.hi.y())};
  cases.branches = map.branches;
  cases.one_scale = map.one_scale;
  cases.here = spot_on(map, here);
  return cases;
}

/// A map in the making.
class MapParts {
 public:
  MapParts(const Lesson& lesson, const Parameters& here)
      : lesson_(lesson), map_(*lesson.map), here_(here), sweep_(map_, here_, cases_) {}
  MapParts(const MapParts&) = delete;
  MapParts& operator=(const MapParts&) = delete;

  std::optional<Chart> next() {
    if (sweep_.next()) return {};
    for (const Preset& preset : lesson_.presets)
      if (!map_.own_group || preset.parameters.at(lesson_.group_by) == here_.at(lesson_.group_by))
        mark(preset.parameters);
    return Chart{std::move(cases_)};
  }

 private:
  void mark(const Parameters& preset) {
    const Cases::Spot spot = {map_.place(preset), map_.branch(preset)};
    const bool twice = std::ranges::any_of(cases_.presets, [&](const Cases::Spot& s) {
      return s.branch == spot.branch && (s.at - spot.at).norm() < 1e-9;
    });
    if (!twice && within(map_, spot.at) && belongs(map_, here_, preset, spot.at)) cases_.presets.push_back(spot);
  }

  const Lesson& lesson_;
  const CaseMap& map_;
  Parameters here_;
  Cases cases_ = map_without_regions(map_, here_);
  Sweep sweep_;
};

}  // namespace

std::optional<Cases::Spot> spot_on(const CaseMap& map, const Parameters& here) {
  const Vec2 at = map.place(here);
  if (!within(map, at)) return {};
  return Cases::Spot{at, map.branch(here)};
}

Chart case_map(const Lesson& lesson, const Parameters& here) {
  MapParts parts(lesson, here);
  std::optional<Chart> map;
  while (!map) map = parts.next();
  return std::move(*map);
}

std::function<std::optional<Chart>()> case_map_in_parts(const Lesson& lesson, const Parameters& here) {
  return [parts = std::make_shared<MapParts>(lesson, here)] { return parts->next(); };
}

Step map_step(const Lesson& lesson, const Parameters& here, const Cases::Spot& spot, const Step& before) {
  Step step = before;
  step.slug = case_map_slug, step.title = tr("Where this case lies");
  step.caption =
      lesson.map->told + "\n" + tr("The dashed lines lead to this setting. Each small ring is another preset.");
  step.formula = tr("here: {case}", {{"case", lesson.map->branches[spot.branch]}});
  step.decides = false;
  step.comparison.reset(), step.question.reset();
  for (Value& value : step.values) value.fresh = false;
  step.scene = {};
  step.scene.chart = std::make_shared<const Chart>(Chart{map_without_regions(*lesson.map, here)});
  return step;
}

void sweep_map(Walk& walk, const Lesson& lesson, const Parameters& here) {
  if (!lesson.map) return;
  const auto shown = std::ranges::find(walk.steps, case_map_slug, &Step::slug);
  if (shown != walk.steps.end()) shown->scene.chart = std::make_shared<const Chart>(case_map(lesson, here));
}

Walk walk_with_map(const Lesson& lesson, const Parameters& here) {
  Walk walk = lesson.walk(here);
  sweep_map(walk, lesson, here);
  return walk;
}

}  // namespace isect::viz
