// Lines, arrows, chains, circles, spans and right angles.

#include <Eigen/Geometry>

#include "viz/compose/canvas.h"
#include "viz/marks.h"

namespace isect::viz {
namespace {

void segment(Canvas& c, const Vec3& from, const Vec3& to, Role role, Pen pen) {
  if (Canvas::is_split(pen, false))
    c.curve(stretches(from, to, c.view, c.occluders), c.theme.ink(role), c.width(pen, role), true);
  else
    c.plain_line({c.at(from), c.at(to)}, false, role, pen);
}

/// What of a line in yellow is seen gets an edge, as one that is never hidden has (Canvas::plain_line).
void edge(Canvas& c, const std::vector<Stretch>& parts, double width) {
  if (c.theme.name == ThemeName::dark) return;
  for (const Stretch& part : parts)
    if (!part.hidden)
      c.lines.emplace_back(Stroke{
          polyline(c.projected(part.points)), c.theme.ink(Role::text), width + 2 * c.sizes().hairline, {0, 0}, true});
}

/// An arrow head at `to` that keeps `keep_off` pixels off it. An arrow towards the eye has none.
class Head {
 public:
  Head(const Canvas& c, const Vec3& from, const Vec3& to, double keep_off)
      : from_(from), to_(to), keep_off_(keep_off), length_((c.at(to) - c.at(from)).norm()) {
    shown_ = length_ > 1.2 * c.sizes().arrow + keep_off;
  }

  /// Where the line must end so that the head covers its end.
  Vec3 line_end(const Canvas& c) const { return shown_ ? before_end(keep_off_ + 0.8 * c.sizes().arrow) : to_; }

  void draw(Canvas& c, Role role) const {
    if (!shown_) return;
    const Vec2 tip = c.at(before_end(keep_off_));
    c.lines.emplace_back(arrow_head(tip, (c.at(to_) - c.at(from_)) / length_, c.theme.ink(role), c.sizes()));
    c.obstacles.push_back({tip, tip, 0.5 * c.sizes().arrow, true});
  }

 private:
  Vec3 before_end(double pixels) const { return to_ + (pixels / length_) * (from_ - to_); }

  Vec3 from_, to_;
  double keep_off_, length_;
  bool shown_;
};

}  // namespace

void draw(Canvas& c, const Line& it) { segment(c, it.from, it.to, it.role, it.pen); }

void draw(Canvas& c, const Arrow& it) {
  const Head head(c, it.from, it.to, c.dot_radius(it.to));
  segment(c, it.from, head.line_end(c), it.role, it.pen);
  head.draw(c, it.role);
}

void draw(Canvas& c, const Chain& it) {
  if (it.points.size() < 2) return;
  if (!Canvas::is_split(it.pen, true) || c.occluders.none())
    return c.plain_line(c.projected(it.points), it.closed, it.role, it.pen);
  const std::vector<Stretch> parts = stretches(it.points, it.closed, c.view, c.occluders);
  const double width = c.width(it.pen, it.role);
  if (it.pen == Pen::highlight) edge(c, parts, width);
  c.curve(parts, c.theme.ink(it.role), width, true);
}

void draw(Canvas& c, const Circle& it) {
  const Vec3 n = it.normal.normalized();
  const Vec3 u = it.radius * n.unitOrthogonal(), v = n.cross(u);
  const std::vector<Stretch> whole = stretches(it.center, u, v, c.view, {}, -1);
  const Colour ink = c.theme.ink(it.role);
  if (it.filled) {
    Fill disc = area(c, polyline(c.projected(whole.front().points), true), it.role);
    if (!c.view.camera().perspective)  // the picture of a circle by two perpendicular radii: exact
      disc.path =
          ellipse(c.at(it.center), c.at(it.center + u) - c.at(it.center), c.at(it.center + v) - c.at(it.center));
    c.fills.emplace_back(disc);
  }
  if (Canvas::is_split(it.pen, true) && !c.occluders.none())
    return c.curve(stretches(it.center, u, v, c.view, c.occluders, -1), ink, c.width(it.pen, it.role), true);
  std::vector<Vec2> points = c.projected(whole.front().points);
  points.pop_back();
  c.plain_line(points, true, it.role, it.pen);
}

void draw(Canvas& c, const Span& it) {
  const Head to(c, it.from, it.to, 0), from(c, it.to, it.from, 0);
  segment(c, it.open_from ? from.line_end(c) : it.from, it.open_to ? to.line_end(c) : it.to, it.role, it.pen);
  if (it.open_from)
    from.draw(c, it.role);
  else
    draw(c, Dot{it.from, Mark::disc, it.role});
  if (it.open_to)
    to.draw(c, it.role);
  else
    draw(c, Dot{it.to, Mark::disc, it.role});
}

void draw(Canvas& c, const RightAngle& it) {
  const double side = 1.9 * c.sizes().disc / c.view.scale_at(it.at);
  const Vec3 u = side * (it.a - it.at).normalized(), v = side * (it.b - it.at).normalized();
  const std::vector<Vec2> points = c.projected({it.at + u, it.at + u + v, it.at + v});
  c.lines.emplace_back(Stroke{polyline(points), c.theme.ink(Role::construction), c.sizes().construction, {0, 0}, true});
  c.block(points, c.sizes().construction, false);
}

}  // namespace isect::viz
