// Markers at their data. Those that overlap are told apart by size and shape, and named beside.

#include <algorithm>
#include <cmath>

#include "viz/chart/chart_parts.h"

namespace isect::viz {
namespace {

/// A marker with its size; `cluster`: the first marker of the group that it overlaps, directly or through others.
struct Sized {
  const Marker* marker;
  double radius;
  std::size_t cluster;
};

std::vector<Sized> sized(const std::vector<Marker>& markers, double radius) {
  std::vector<Sized> all;
  for (const Marker& marker : markers) {
    const std::size_t own = all.size();
    all.push_back({&marker, radius, own});
    const auto near = [&](const Sized& other) { return (other.marker->at - marker.at).norm() < 2.2 * radius; };
    int covered = 0;
    for (std::size_t i = 0; i < own; ++i) {
      if (!near(all[i])) continue;
      covered += (all[i].marker->at - marker.at).norm() < 1.2 * radius;
      const std::size_t from = all[own].cluster, to = all[i].cluster;
      for (Sized& s : all)
        if (s.cluster == from || s.cluster == to) s.cluster = std::min(from, to);
    }
    all[own].radius *= std::pow(0.72, std::min(covered, 4));
  }
  return all;
}

/// The names of one cluster's markers in a column.
class Names {
 public:
  Names(ChartInk& ink, std::vector<Sized> cluster) : ink_(ink), cluster_(std::move(cluster)) {
    box_ = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (const Sized& s : cluster_) {
      const Vec2& p = s.marker->at;
      box_ = {std::min(box_.left, p.x() - s.radius), std::min(box_.top, p.y() - s.radius),
              std::max(box_.right, p.x() + s.radius), std::max(box_.bottom, p.y() + s.radius)};
      width_ = std::max(width_, ink.width(s.marker->name, size()));
    }
  }

  /// Places the names beside the cluster, right before left, as near as there is room.
  /// Adds the leaders to `lines`.
  void place(const std::vector<Sized>& all, std::vector<Obstacle>& lines, const Bounds& panel) {
    const double height = pitch() * static_cast<double>(cluster_.size()), middle = (box_.top + box_.bottom) / 2;
    std::optional<TextBox> best;
    double least = INFINITY;
    bool best_right = true;
    for (int far = 0; far < 24; ++far)
      for (int k = 0; k < 120; ++k)
        for (const bool right : {true, false}) {
          const double gap = (1.1 + 0.5 * far) * size(), off = 0.25 * pitch() * ((k + 1) / 2) * (k % 2 ? -1 : 1);
          const double left = right ? box_.right + gap : box_.left - gap - width_, top = middle - height / 2 + off;
          const TextBox column = {left, top, left + width_, top + height};
          if (gap + std::abs(off) > least - 1e-6 || !is_free(column, all, lines, panel) ||
              !are_free(leaders(column, right), all))
            continue;
          best = column, least = gap + std::abs(off), best_right = right;
        }
    if (!best) return;
    draw(*best, best_right);
    for (const auto& [from, to] : leaders(*best, best_right)) lines.push_back({from, to, ink_.sizes().leader, false});
  }

 private:
  double size() const { return ink_.sizes().axis; }
  double pitch() const { return 1.2 * size(); }

  bool is_free(const TextBox& column, const std::vector<Sized>& all, const std::vector<Obstacle>& lines,
               const Bounds& panel) const {
    if (column.left < panel.left || column.right > panel.right || column.top < panel.top ||
        column.bottom > panel.bottom - 0.3 * size())
      return false;
    const TextBox wide = grown(column, 0.25 * size());
    const auto meets = [&](const TextBox& b) {
      return wide.left < b.right && b.left < wide.right && wide.top < b.bottom && b.top < wide.bottom;
    };
    return std::ranges::none_of(all,
                                [&](const Sized& s) {
                                  return meets(box_around(s.marker->at, {s.radius, s.radius}));
                                }) &&
           std::ranges::none_of(lines, [&](const Obstacle& o) { return length_inside(o.from, o.to, wide) > 0; }) &&
           std::ranges::none_of(ink_.labels(), [&](const PlacedLabel& label) { return meets(label.box); });
  }

  /// Returns leaders that do not cross: from beside the names, from top to bottom, to the markers.
  std::vector<std::pair<Vec2, Vec2>> leaders(const TextBox& column, bool right) {
    const Vec2 middle(right ? column.left : column.right, (column.top + column.bottom) / 2);
    const auto slope = [&](const Sized& s) {
      return (s.marker->at.y() - middle.y()) / std::abs(s.marker->at.x() - middle.x());
    };
    std::ranges::stable_sort(cluster_, [&](const Sized& a, const Sized& b) { return slope(a) < slope(b) - 1e-6; });
    std::vector<std::pair<Vec2, Vec2>> lines;
    double y = column.top + pitch() / 2;
    for (const Sized& s : cluster_) {
      const Vec2 from(right ? column.left - 0.2 * size() : column.right + 0.2 * size(), y);
      lines.emplace_back(from, s.marker->at + 0.9 * s.radius * (from - s.marker->at).normalized());
      y += pitch();
    }
    return lines;
  }

  /// Whether the leaders keep off the markers of other clusters, and off their names.
  bool are_free(const std::vector<std::pair<Vec2, Vec2>>& leaders, const std::vector<Sized>& all) const {
    const auto meets = [&](const TextBox& b) {
      return std::ranges::any_of(leaders,
                                 [&](const auto& line) { return length_inside(line.first, line.second, b) > 0; });
    };
    return std::ranges::none_of(
               all,
               [&](const Sized& s) {
                 return s.cluster != cluster_.front().cluster && meets(box_around(s.marker->at, {s.radius, s.radius}));
               }) &&
           std::ranges::none_of(ink_.labels(), [&](const PlacedLabel& label) { return meets(label.box); });
  }

  void draw(const TextBox& column, bool right) {
    const auto lines = leaders(column, right);
    for (std::size_t i = 0; i < cluster_.size(); ++i) {
      const auto& [from, to] = lines[i];
      ink_.line({from, to}, ink_.theme().ink(Role::construction), ink_.sizes().leader);
      ink_.text(cluster_[i].marker->name, {right ? column.left : column.right, from.y() + 0.33 * size()},
                {size(), Role::text, right ? 0.0 : 1.0}, cluster_[i].marker->at);
    }
  }

  ChartInk& ink_;
  std::vector<Sized> cluster_;
  TextBox box_;
  double width_ = 0;
};

}  // namespace

void draw_markers(ChartInk& ink, const std::vector<Marker>& markers, std::vector<Obstacle> lines, const Bounds& panel) {
  const std::vector<Sized> all = sized(markers, ink.glyph_radius());
  std::vector<const Sized*> by_size;
  for (const Sized& s : all) by_size.push_back(&s);
  std::ranges::stable_sort(by_size, [](const Sized* a, const Sized* b) { return a->radius > b->radius; });
  for (const Sized* s : by_size) {
    const bool meets = std::ranges::count(all, s->cluster, &Sized::cluster) > 1;
    ink.glyph(s->marker->glyph, s->marker->at, s->radius, s->marker->colour, s->marker->hollow, meets);
  }

  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Sized> cluster;
    for (const Sized& s : all)
      if (s.cluster == i && !s.marker->name.empty()) cluster.push_back(s);
    if (cluster.size() > 1) Names(ink, cluster).place(all, lines, panel);
  }
}

}  // namespace isect::viz
