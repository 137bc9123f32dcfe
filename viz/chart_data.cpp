// One panel's data: the front as steps with the dominated side tinted, markers that make room for each other and keep a
// line to their place, curves with their names at their ends.

#include <algorithm>
#include <cmath>

#include "viz/chart_parts.h"

namespace isect::viz {
namespace {

struct Placed {
  Vec2 at;
  double radius;
};

/// Marker by marker: at its true place if that is free; else smaller, at the nearest free place.
class Stacker {
 public:
  Stacker(const Bounds& room, double radius) : room_(room), radius_(radius) {}

  Placed place(const Vec2& at) {
    Placed best = {at, radius_};
    if (!free(best)) best = nearby(at, 0.74 * radius_);
    placed_.push_back(best);
    return best;
  }

 private:
  bool free(const Placed& p) const {
    return std::none_of(placed_.begin(), placed_.end(),
                        [&](const Placed& q) { return (p.at - q.at).norm() < 1.12 * (p.radius + q.radius); });
  }

  Placed nearby(const Vec2& at, double radius) const {
    for (int ring = 4; ring < 60; ++ring)
      // never to the left, where it would look faster than it is
      for (const Vec2& way : {Vec2(0, -1), Vec2(0.5, -0.9), Vec2(0.9, -0.5), Vec2(1, 0), Vec2(0.7, 0.7)}) {
        const Placed p = {at + 0.35 * ring * radius * way, radius};
        if (p.at.x() > room_.left + radius && p.at.x() < room_.right - radius && p.at.y() > room_.top - radius &&
            p.at.y() < room_.bottom - 0.4 * radius && free(p))
          return p;
      }
    return {at, radius};
  }

  Bounds room_;
  double radius_;
  std::vector<Placed> placed_;
};

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

  void front() {
    std::vector<Vec2> corners;
    for (const Spot& spot : panel_.spots)
      if (spot.front) corners.push_back(at(spot.x, spot.y));
    if (corners.empty()) return;
    std::sort(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    std::vector<Vec2> steps = {{corners.front().x(), b_.top}};
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
    ink_.line({top, low}, colour(spot), 0.75 * s().outline);
    ink_.line({{low.x() - half, low.y()}, {low.x() + half, low.y()}}, colour(spot), 0.75 * s().outline);
  }

  void markers(const std::vector<const Spot*>& spots) {
    Stacker stacker({b_.left, b_.top, b_.right, b_.bottom}, ink_.glyph_radius());
    std::vector<Placed> places;
    for (const Spot* spot : spots) {
      places.push_back(stacker.place(at(spot->x, spot->y)));
    }
    for (std::size_t i = spots.size(); i-- > 0;)
      ink_.glyph(plot_.series[spots[i]->series].glyph, places[i].at, places[i].radius, colour(*spots[i]),
                 !spots[i]->front);
    for (std::size_t i = 0; i < spots.size(); ++i) lead(*spots[i], places[i]);
  }

  /// From a marker that had to move to a dot on its true place.
  void lead(const Spot& spot, const Placed& placed) {
    const Vec2 true_place = at(spot.x, spot.y), way = true_place - placed.at;
    if (way.norm() <= placed.radius) return;
    ink_.line({placed.at + placed.radius * way.normalized(), true_place}, colour(spot), s().hairline);
    ink_.glyph(Glyph::disc, true_place, 0.25 * placed.radius, colour(spot), false);
  }

  void curves() {
    int order = 0;
    for (const Curve& curve : panel_.curves) {
      const Series& series = plot_.series[curve.series];
      std::vector<Vec2> points;
      for (const Vec2& p : curve.points) points.push_back(at(p.x(), p.y()));
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

  /// A marker or two on a smooth curve, each curve's at another height so that equal curves still show all of theirs.
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

  /// Names at the right ends, spread until no two meet; a thin line leads to one that had to move.
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
};

}  // namespace

void draw_data(ChartInk& ink, const Plot& plot, const Panel& panel, const Bounds& bounds) {
  PanelInk(ink, plot, panel, bounds).run();
}

}  // namespace isect::viz
