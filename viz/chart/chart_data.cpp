// One panel's data: the front as steps with the dominated side tinted, markers, curves with their names at their ends.

#include <algorithm>
#include <cmath>

#include "viz/chart/chart_parts.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

class PanelInk {
 public:
  PanelInk(ChartInk& ink, const Plot& plot, const Panel& panel, const Bounds& b)
      : ink_(ink), plot_(plot), panel_(panel), b_(b), x_(plot.x, b.left, b.right), y_(plot.y, b.bottom, b.top) {}

  void run() {
    front();
    curves();
    std::vector<const Spot*> spots;
    for (const Spot& spot : panel_.spots) spots.push_back(&spot);
    std::stable_sort(spots.begin(), spots.end(),
                     [](const Spot* a, const Spot* b) { return a->front != b->front ? a->front : a->x < b->x; });
    for (const Spot* spot : spots) whisker(*spot);
    markers(spots);
  }

 private:
  const Sizes& s() const { return ink_.sizes(); }
  Vec2 at(double x, double y) const { return {x_.at(x), y_.at(y)}; }
  Colour colour(const Spot& spot) const {
    const Colour ink = ink_.theme().ink(spot.front ? Role::hit : Role::construction);
    return panel_.muted ? tinted(ink_.theme(), ink, 0.45) : ink;
  }

  /// Returns what is told of a marker, or of a point of a curve.
  std::string told(const std::string& series, double x, double y) const {
    std::string head = plain(series);
    if (!panel_.title.empty()) head += (head.empty() ? "" : ", ") + plain(panel_.title);
    return (head.empty() ? "" : head + "\n") + told_of(plot_.x, x) + "\n" + told_of(plot_.y, y);
  }

  void front() {
    std::vector<Vec2> corners;
    for (const Spot& spot : panel_.spots)
      if (spot.front) corners.push_back(at(spot.x, spot.y));
    if (corners.empty()) return;
    std::sort(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    std::vector<Vec2>& steps = steps_;
    steps = {{corners.front().x(), b_.top}};
    for (const Vec2& corner : corners) {
      steps.emplace_back(corner.x(), steps.back().y());
      steps.push_back(corner);
    }
    steps.emplace_back(b_.right, steps.back().y());

    std::vector<Vec2> dominated = steps;
    dominated.emplace_back(b_.right, b_.top);
    const Colour ink = ink_.theme().ink(Role::hit);
    ink_.fill(dominated, ink.with_alpha(panel_.muted ? 0.03 : 0.075));
    ink_.line(steps, panel_.muted ? tinted(ink_.theme(), ink, 0.45) : ink, 1.25 * s().outline, {0, 0}, true);
  }

  void whisker(const Spot& spot) {
    if (!spot.low) return;
    const Vec2 top = at(spot.x, spot.y), low = at(spot.x, *spot.low);
    const double half = 0.6 * ink_.glyph_radius();
    if (low.y() - top.y() < half) return;
    ink_.line({top + Vec2(0, half), low}, colour(spot), 0.75 * s().outline);  // open markers stay empty
    ink_.line({{low.x() - half, low.y()}, {low.x() + half, low.y()}}, colour(spot), 0.75 * s().outline);
  }

  /// Draws the markers; their names keep off the front's steps and off the whiskers.
  void markers(const std::vector<const Spot*>& spots) {
    std::vector<Marker> all;
    std::vector<Obstacle> lines;
    const auto keep_off = [&](const Vec2& a, const Vec2& b) { lines.push_back({a, b, s().outline, true}); };
    for (const Spot* spot : spots) {
      const Series& series = plot_.series[spot->series];
      all.push_back({at(spot->x, spot->y), series.glyph, colour(*spot), !spot->front, panel_.muted ? "" : series.name});
      if (spot->low) keep_off(all.back().at, at(spot->x, *spot->low));
      const std::string down = spot->low ? ", down to " + shown(*spot->low) : "";
      ink_.tell(all.back().at, told(series.name, spot->x, spot->y) + down);
    }
    for (std::size_t i = 1; i < steps_.size(); ++i) keep_off(steps_[i - 1], steps_[i]);
    draw_markers(ink_, all, lines, b_);
  }

  void curves() {
    int order = 0;
    for (const Curve& curve : panel_.curves) {
      const Series& series = plot_.series[curve.series];
      std::vector<Vec2> points;
      for (const Vec2& p : curve.points) points.push_back(at(p.x(), p.y()));
      for (std::size_t i = 0; i < points.size(); ++i)
        ink_.tell(points[i],
                  told(curve.label.empty() ? series.name : curve.label, curve.points[i].x(), curve.points[i].y()));
      if (points.empty()) continue;
      const Colour ink = ink_.theme().ink(series.role);
      ink_.line(points, ink, 1.1 * s().outline, dash_of(series.dash, s()));
      if (points.size() <= 12 && !curve.label.empty())
        for (const Vec2& p : points) ink_.glyph(series.glyph, p, 0.62 * ink_.glyph_radius(), ink, false);
      else
        marks_on(points, series, ink, order++);
    }
    names();
  }

  /// Draws a marker or two on a smooth curve, each curve's elsewhere, so that equal curves still show all markers.
  void marks_on(const std::vector<Vec2>& points, const Series& series, const Colour& ink, int order) {
    const double share = 0.2 + 0.6 * std::fmod(0.382 * order + 0.1, 1.0);
    const double level = points.front().y() + share * (points.back().y() - points.front().y());
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2 &a = points[i - 1], &b = points[i];
      if ((a.y() - level) * (b.y() - level) > 0 || a.y() == b.y()) continue;
      ink_.glyph(series.glyph, a + (level - a.y()) / (b.y() - a.y()) * (b - a), 0.8 * ink_.glyph_radius(), ink, false);
      return;
    }
  }

  /// Writes names at the right ends, spread until no two meet; a thin line leads to each name that had to move.
  void names() {
    struct Name {
      const Curve* curve;
      Vec2 end;
      double y;
    };
    std::vector<Name> all;
    for (const Curve& curve : panel_.curves)
      if (!curve.label.empty() && !curve.points.empty()) {
        const Vec2 end = at(curve.points.back().x(), curve.points.back().y());
        all.push_back({&curve, end, end.y()});
      }
    std::stable_sort(all.begin(), all.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
    const double pitch = 1.25 * s().label;
    for (int round = 0; round < 200; ++round)
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && all[i].y - all[i - 1].y < pitch) {
          const double push = (pitch - (all[i].y - all[i - 1].y)) / 2;
          all[i - 1].y -= push, all[i].y += push;
        }
        all[i].y = std::clamp(all[i].y, b_.top + 0.4 * s().label, b_.bottom + 0.2 * s().label);
      }
    for (const Name& name : all) {
      const Series& series = plot_.series[name.curve->series];
      const Vec2 from = name.end + Vec2(0.9 * ink_.glyph_radius(), 0), to = {b_.right + 1.0 * s().label, name.y};
      if (std::abs(name.y - name.end.y()) > 0.4 * s().label || to.x() - from.x() > 1.5 * s().label)
        ink_.line({from, to - Vec2(0.15 * s().label, 0)}, ink_.theme().ink(Role::construction), s().leader);
      ink_.text(name.curve->label, {to.x(), name.y + 0.32 * s().label}, {s().label, series.role});
    }
  }

  ChartInk& ink_;
  const Plot& plot_;
  const Panel& panel_;
  Bounds b_;
  ScaleLine x_, y_;
  std::vector<Vec2> steps_;  ///< of the front
};

}  // namespace

void draw_data(ChartInk& ink, const Plot& plot, const Panel& panel, const Bounds& bounds) {
  PanelInk(ink, plot, panel, bounds).run();
}

}  // namespace isect::viz
