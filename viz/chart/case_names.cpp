#include "viz/chart/case_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isect::viz {
namespace {

constexpr int scan_lines = 4;          ///< per row of cells
constexpr double nearly_whole = 0.98;  ///< a cell of which this share lies in a region counts as inside it
constexpr double hair = 1e-6;          ///< smaller differences are left to rounding

// What a place for a name costs besides the length of its leader.
constexpr double over_border = 1000, through_name = 2000, over_leader = 2000, over_name = 8000;

bool share_ink(const TextBox& a, const TextBox& b) {
  return a.left < b.right - hair && b.left < a.right - hair && a.top < b.bottom - hair && b.top < a.bottom - hair;
}

double area_of(const Cases::Patch& patch) {
  const auto& [a, b, c, d] = patch.corners;
  return (b.x() - a.x() + c.x() - d.x()) / 2 * (d.y() - a.y());
}

}  // namespace

bool is_thin(const Cases& cases, int branch) {
  return std::ranges::none_of(cases.patches, [&](const Cases::Patch& patch) { return patch.branch == branch; });
}

CaseNames::CaseNames(const Cases& cases, const Bounds& plane)
    : cases_(cases),
      plane_(plane),
      cell_((plane.right - plane.left) / columns, (plane.bottom - plane.top) / rows),
      sums_(cases.branches.size(), std::vector<int>((columns + 1) * (rows + 1), 0)) {
  rasterise(cases);
}

void CaseNames::take(const TextBox& box, bool may_cross) { (may_cross ? crossable_ : taken_).push_back(box); }

void CaseNames::take_leader(const Vec2& from, const Vec2& to) { leaders_.emplace_back(from, to); }

double CaseNames::in_the_way(const Vec2& from, const Vec2& to) const {
  double cost = 0;
  for (const TextBox& t : taken_)
    if (length_inside(from, to, t) > 0) cost += through_name;
  for (const auto& [a, b] : leaders_)
    if (cross(from, to, a, b)) cost += crossed;
  return cost;
}

int& CaseNames::sum(int branch, int x, int y) { return sums_[branch][static_cast<std::size_t>(y) * (columns + 1) + x]; }

int CaseNames::count(int branch, int x0, int y0, int x1, int y1) const {
  const auto at = [&](int x, int y) { return sums_[branch][static_cast<std::size_t>(y) * (columns + 1) + x]; };
  return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0);
}

Vec2 CaseNames::drawn(const Vec2& cells) const {
  return {plane_.left + cells.x() * cell_.x(), plane_.bottom - cells.y() * cell_.y()};
}

/// Sums up, along a few lines of each row, how much of each cell a region covers.
void CaseNames::rasterise(const Cases& cases) {
  const Vec2 lo(cases.x.lo, cases.y.lo), size(cases.x.hi - cases.x.lo, cases.y.hi - cases.y.lo);
  std::vector<std::vector<double>> covered(sums_.size(), std::vector<double>(columns * rows, 0));
  for (const Cases::Patch& patch : cases.patches) {
    const auto in_cells = [&](const Vec2& p) -> Vec2 {
      return (p - lo).cwiseQuotient(size).cwiseProduct(Vec2(columns, rows));
    };
    const Vec2 a = in_cells(patch.corners[0]), b = in_cells(patch.corners[1]), c = in_cells(patch.corners[2]),
               d = in_cells(patch.corners[3]);
    const double off = 0.47;  // keeps the lines off round numbers, where borders lie
    for (int line = static_cast<int>(std::ceil(a.y() * scan_lines - off)); line + off < d.y() * scan_lines; ++line) {
      if (line < 0 || line >= rows * scan_lines) continue;
      const double share = ((line + off) / scan_lines - a.y()) / (d.y() - a.y());
      const double from = a.x() + share * (d.x() - a.x()), to = b.x() + share * (c.x() - b.x());
      for (int x = std::max(0, static_cast<int>(from)); x < std::min<double>(columns, to); ++x)
        covered[patch.branch][static_cast<std::size_t>(line / scan_lines) * columns + x] +=
            std::max(0.0, std::min(to, x + 1.0) - std::max<double>(from, x)) / scan_lines;
    }
  }
  for (int i = 0; i < static_cast<int>(sums_.size()); ++i)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x)
        sum(i, x + 1, y + 1) = (covered[i][static_cast<std::size_t>(y) * columns + x] >= nearly_whole) +
                               sum(i, x, y + 1) + sum(i, x + 1, y) - sum(i, x, y);
}

bool CaseNames::filled(int branch, const Vec2& middle, const Vec2& half) const {
  const Vec2 inset = Vec2::Constant(hair), lo = middle - half + inset, hi = middle + half - inset;
  const bool within = (half.array() >= 0).all() && (lo.array() >= 0).all() && hi.x() <= columns && hi.y() <= rows;
  if (!within) return false;  // also in a plane without room, whose cells have no size
  const int x0 = static_cast<int>(std::floor(lo.x())), y0 = static_cast<int>(std::floor(lo.y())),
            x1 = static_cast<int>(std::ceil(hi.x())), y1 = static_cast<int>(std::ceil(hi.y()));
  if (count(branch, x0, y0, x1, y1) != (x1 - x0) * (y1 - y0)) return false;
  const TextBox box = box_around(drawn(middle), half.cwiseProduct(cell_));
  for (const std::vector<TextBox>* all : {&taken_, &crossable_})
    if (std::ranges::any_of(*all, [&](const TextBox& taken) { return share_ink(box, taken); })) return false;
  return std::ranges::none_of(leaders_, [&](const auto& l) { return length_inside(l.first, l.second, box) > 0; });
}

bool CaseNames::filled(const Vec2& middle, const Vec2& half) const {
  const int x = static_cast<int>(std::clamp(middle.x(), 0.0, columns - 1.0));
  const int y = static_cast<int>(std::clamp(middle.y(), 0.0, rows - 1.0));
  for (int i = 0; i < static_cast<int>(sums_.size()); ++i)
    if (count(i, x, y, x + 1, y + 1) == 1) return filled(i, middle, half);
  return false;
}

CaseNames::Room CaseNames::largest(int branch, const Vec2& name) const {
  constexpr double largest_scale = 8;
  constexpr int halvings = 7;
  constexpr double step = largest_scale / (1 << halvings);
  Room best;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      if (count(branch, x, y, x + 1, y + 1) == 0) continue;
      const Vec2 middle(x + 0.5, y + 0.5);
      if (!filled(branch, middle, (best.scale + step) / 2 * name)) continue;  // no more room than the best has
      double lo = 0, hi = largest_scale;
      for (int i = 0; i < halvings; ++i) {
        const double scale = (lo + hi) / 2;
        (filled(branch, middle, scale / 2 * name) ? lo : hi) = scale;
      }
      if (lo > best.scale + step / 2) best = {middle, lo};
    }
  return best;
}

/// Returns the middle of the region's widest part off what is taken; if thinner than a cell, of its largest patch.
Vec2 CaseNames::some_point_of(int branch) const {
  const double side = 6 * std::min(cell_.x(), cell_.y());
  const Room room = largest(branch, Vec2(side, side).cwiseQuotient(cell_));
  if (room.scale > 0) return drawn(room.middle);

  const Cases::Patch* best = nullptr;
  for (const Cases::Patch& patch : cases_.patches)
    if (patch.branch == branch && (!best || area_of(patch) > (1 + hair) * area_of(*best))) best = &patch;
  if (!best) return drawn(Vec2(columns, rows) / 2);
  const auto& [a, b, c, d] = best->corners;
  const Vec2 lo(cases_.x.lo, cases_.y.lo), size(cases_.x.hi - cases_.x.lo, cases_.y.hi - cases_.y.lo);
  return drawn(((a + b + c + d) / 4 - lo).cwiseQuotient(size).cwiseProduct(Vec2(columns, rows)));
}

/// Returns the nearest place for the whole name in one region, with a free way for the leader from the region's middle,
/// or else from another point of it; over borders only if there is no other. Coarse steps bound the finer search.
NamePlace CaseNames::beside(int branch, const Vec2& size) const {
  const Vec2 middle = some_point_of(branch);
  NamePlace best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const double step : {4.0, 1.0, 0.5}) best = beside(middle, size, step, best.cost + 2 * hair);
  if (best.cost < crossed) return best;

  constexpr int apart = 6;
  const Vec2 side = Vec2::Constant(apart * std::min(cell_.x(), cell_.y()) / 4).cwiseQuotient(cell_);
  std::vector<Vec2> others;
  for (int y = apart / 2; y < rows; y += apart)
    for (int x = apart / 2; x < columns; x += apart)
      if (const Vec2 at(x, y); filled(branch, at, side)) others.push_back(drawn(at));
  const auto cheapest = [&](double step, double most) {
    NamePlace found;
    found.cost = most;
    for (const Vec2& to : others)
      if (const NamePlace other = beside(to, size, step, found.cost); other.cost < found.cost - hair) found = other;
    return found;
  };
  const double bound = std::min(cheapest(4, best.cost).cost + 2 * hair, best.cost);
  const NamePlace other = cheapest(1, bound);
  return other.cost < bound - hair ? other : best;
}

NamePlace CaseNames::beside(const Vec2& to, const Vec2& size, double step, double most) const {
  const Vec2 half = size / 2;
  NamePlace best = {to, to, false, most};
  const double least =
      through_name * static_cast<double>(std::ranges::count_if(taken_, [&](const TextBox& t) {
        return t.left + hair < to.x() && to.x() < t.right - hair && t.top + hair < to.y() && to.y() < t.bottom - hair;
      }));  // wherever a leader comes from
  const auto too_far = [&](double from, double place, double reach) {
    return std::abs(place - from) - reach + least > best.cost;
  };
  for (int y = 0; y * step <= rows; ++y) {
    if (too_far(to.y(), drawn({0, y * step}).y(), half.y())) continue;
    for (int x = 0; x * step <= columns; ++x) {
      const Vec2 at(x * step, y * step), middle = drawn(at);
      if (too_far(to.x(), middle.x(), half.x())) continue;
      const TextBox box = box_around(middle, half);
      if (box.left < plane_.left || box.right > plane_.right || box.top < plane_.top || box.bottom > plane_.bottom)
        continue;
      const Vec2 from = nearest_in(box, to);
      double cost = (to - from).norm() + 0.1 * (to - middle).norm();
      if ((to - from).norm() < 0.8 * size.y() || cost + least > best.cost - hair) continue;
      for (const TextBox& t : taken_)
        if (share_ink(box, t)) cost += over_name;
      if (cost + least > best.cost - hair) continue;
      cost += in_the_way(from, to);
      for (const auto& [a, b] : leaders_)
        if (length_inside(a, b, box) > 0) cost += over_leader;
      if (cost > best.cost - hair) continue;
      const bool on_border = !filled(at, half.cwiseQuotient(cell_));
      if (on_border) cost += over_border;
      if (cost < best.cost - hair) best = {middle, to, on_border, cost};
    }
  }
  return best;
}

NamePlace CaseNames::place(int branch, const Vec2& size) const {
  const Room room = largest(branch, size.cwiseQuotient(cell_));
  return room.scale >= 1 ? NamePlace{drawn(room.middle)} : beside(branch, size);
}

}  // namespace isect::viz
