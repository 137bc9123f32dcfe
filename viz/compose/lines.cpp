// Lines, arrows, chains, circles, spans and right angles.

#include <Eigen/Geometry>

#include <algorithm>

#include "viz/compose/canvas.h"
#include "viz/compose/marks.h"

namespace isect::viz {
namespace {

/// Returns what hides the line, and those facets of meshes that the eye sees on both sides of it.
Occluders with_facets(const Canvas& c, const Vec3& from, const Vec3& to, Role role, Pen pen) {
  Occluders all = c.around({from, to}, role, pen);
  for (const SortedMesh& sorted : c.meshes)
    for (const int i : facets_across(sorted, c.view, from, to).facets) {
      const auto& [p, q, r] = sorted.mesh->triangles[i];
      const std::vector<Vec3>& at = sorted.mesh->vertices;
      all.screens.push_back({{{at[p], at[q], at[r]}}});
    }
  return all;
}

void segment(Canvas& c, const Vec3& from, const Vec3& to, Role role, Pen pen, bool named = false) {
  if (Canvas::is_split(pen, false))
    c.curve(named && !c.meshes.empty() ? stretches(from, to, c.view, with_facets(c, from, to, role, pen))
                                       : c.seen({from, to}, false, role, pen),
            c.theme.ink(role), c.width(pen, role), true);
  else
    c.plain_line({c.at(from), c.at(to)}, false, role, pen);
}

/// Gives the visible parts of a yellow line an edge, as lines that are never hidden have (Canvas::plain_line).
void edge(Canvas& c, const std::vector<Stretch>& parts, double width) {
  if (c.theme.name == ThemeName::dark) return;
  for (const Stretch& part : parts)
    if (!part.hidden)
      c.lines.emplace_back(Stroke{
          polyline(c.projected(part.points)), c.theme.ink(Role::text), width + 2 * c.sizes().hairline, {0, 0}, true});
}

/// An arrow head at `to` that keeps `keep_off` pixels off it, larger on a broad line. An arrow towards the eye has no
/// head.
class Head {
 public:
  Head(const Canvas& c, const Vec3& from, const Vec3& to, double keep_off, Role role, Pen pen)
      : from_(from),
        to_(to),
        keep_off_(keep_off),
        role_(role),
        edged_(pen == Pen::highlight && c.theme.name != ThemeName::dark),
        size_(std::max(c.sizes().arrow, pen == Pen::highlight ? 4.4 * c.width(pen, role) : 0.0)),
        length_((c.at(to) - c.at(from)).norm()) {
    shown_ = length_ > 1.2 * size_ + keep_off;
  }

  /// Returns where the line must end so that the head covers its end.
  Vec3 line_end() const { return shown_ ? before_end(keep_off_ + 0.8 * size_) : to_; }

  /// Call it before the line, which covers it at the head's base (Canvas::plain_line has the same edge).
  void draw_edge(Canvas& c) const {
    if (shown_ && edged_)
      c.lines.emplace_back(Stroke{path(c), c.theme.ink(Role::text), 2 * c.sizes().hairline, {0, 0}, true});
  }
  void draw(Canvas& c) const {
    if (!shown_) return;
    c.lines.emplace_back(Fill{path(c), c.theme.ink(role_), 0, 0, {}});
    const Vec2 tip = c.at(before_end(keep_off_)), base = c.at(before_end(keep_off_ + size_));
    c.obstacles.push_back({tip, tip, 0.5 * size_, true});
    if (edged_) c.obstacles.push_back({tip, base, 0.4 * size_, true});
  }

 private:
  Vec3 before_end(double pixels) const { return to_ + (pixels / length_) * (from_ - to_); }
  Path path(const Canvas& c) const {
    return arrow_head(c.at(before_end(keep_off_)), (c.at(to_) - c.at(from_)) / length_, size_);
  }

  Vec3 from_, to_;
  double keep_off_;
  Role role_;
  bool edged_;
  double size_, length_;
  bool shown_;
};

}  // namespace

void draw(Canvas& c, const Line& it) { segment(c, it.from, it.to, it.role, it.pen, !it.name.empty()); }

void draw(Canvas& c, const Arrow& it) {
  const Head head(c, it.from, it.to, c.dot_radius(it.to), it.role, it.pen);
  head.draw_edge(c);
  segment(c, it.from, head.line_end(), it.role, it.pen, !it.name.empty());
  head.draw(c);
}

void draw(Canvas& c, const Chain& it) {
  if (it.points.size() < 2) return;
  if (!Canvas::is_split(it.pen, true) || c.occluders.none())
    return c.plain_line(c.projected(it.points), it.closed, it.role, it.pen);
  const std::vector<Stretch> parts = c.seen(it.points, it.closed, it.role, it.pen);
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
    return c.curve(stretches(it.center, u, v, c.view, c.around(whole.front().points, it.role, it.pen), -1), ink,
                   c.width(it.pen, it.role), true);
  std::vector<Vec2> points = c.projected(whole.front().points);
  points.pop_back();
  c.plain_line(points, true, it.role, it.pen);
}

void draw(Canvas& c, const Span& it) {
  const Head to(c, it.from, it.to, 0, it.role, it.pen), from(c, it.to, it.from, 0, it.role, it.pen);
  if (it.open_from) from.draw_edge(c);
  if (it.open_to) to.draw_edge(c);
  segment(c, it.open_from ? from.line_end() : it.from, it.open_to ? to.line_end() : it.to, it.role, it.pen);
  if (it.open_from)
    from.draw(c);
  else
    draw(c, Dot{it.from, Mark::disc, it.role});
  if (it.open_to)
    to.draw(c);
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
