// Balls: a gradient lit from the upper left, the analytic silhouette and one equator. Capsules: the silhouette, and a
// ring at each end of the axis.

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "viz/compose/canvas.h"
#include "viz/compose/outlines.h"

namespace isect::viz {
namespace {

bool same(const Ball& a, const Ball& b) { return a.center == b.center && a.radius == b.radius; }

/// Returns the circle in space whose picture is the ball's outline.
std::vector<Stretch> silhouette(const Canvas& c, const Occluders& around, const Ball& b) {
  const Rim circle = rim(b, c.view);
  Occluders others = around;
  std::erase_if(others.balls, [&](const Ball& other) { return same(other, b); });
  return stretches(circle.middle, circle.u, circle.v, c.view, others, -1);
}

bool alone(const Occluders& occluders) {
  return occluders.balls.size() == 1 && occluders.solids.empty() && occluders.screens.empty() &&
         occluders.capsules.empty();
}

}  // namespace

void draw_ball(Canvas& c, int index) {
  const Ball& b = c.occluders.balls[index];
  const Sizes& s = c.sizes();
  const Outline edge = outline(b, c.view);
  const Colour ink = c.theme.ink(b.role);
  const Path rim = ellipse(edge.center, edge.major, edge.minor);
  if (c.theme.hatched(b.role)) {
    c.fills.emplace_back(Fill{rim, ink.with_alpha(0.07), s.hatch_gap, s.hatch_line, ink});
  } else {
    const double radius = edge.major.norm();
    const Vec2 lit = edge.center + 0.42 * radius * Vec2(-0.35, -0.55);  // towards the light, upper left
    const bool on_dark = c.theme.name == ThemeName::dark;               // there ink is light
    const double inner = on_dark ? 1.9 : 0.3, outer = on_dark ? 0.6 : 1.9;
    c.fills.emplace_back(Gradient{edge.center, edge.major, edge.minor, lit, ink.with_alpha(inner * c.theme.fill_alpha),
                                  ink.with_alpha(outer * c.theme.fill_alpha)});
  }

  const Vec3 u = b.radius * Vec3::UnitX(), v = b.radius * Vec3::UnitZ();
  const Occluders around = around_ball(c.occluders, index, &c.view);
  const auto own = std::find_if(around.balls.begin(), around.balls.end(), [&](const Ball& o) { return same(o, b); });
  c.curve(stretches(b.center, u, v, c.view, around, static_cast<int>(own - around.balls.begin())), ink.with_alpha(0.75),
          s.hidden * 1.1, false);
  if (alone(c.occluders))
    c.lines.emplace_back(Stroke{rim, ink, s.outline, {0, 0}, true});
  else
    c.curve(silhouette(c, around, b), ink, s.outline, false);
  std::vector<Vec2> points = flatten(rim, 0.5);
  points.push_back(points.front());
  c.block(points, s.outline / 2, true);
}

void draw_capsule(Canvas& c, int index, Role role) {
  const Capsule<double, 3>& body = c.occluders.capsules[static_cast<std::size_t>(index)];
  const Sizes& s = c.sizes();
  const Colour ink = c.theme.ink(role);
  const std::vector<Vec3> chain = outline(body, c.view);
  const Path path = polyline(c.projected(chain), true);
  c.fills.emplace_back(area(c, path, role));

  const Vec3 axis = (body.q - body.p).normalized(), u = body.radius * axis.unitOrthogonal(), v = axis.cross(u);
  const Occluders around = around_capsule(c.occluders, index);
  for (const Vec3& end : {body.p, body.q})
    c.curve(stretches(end, u, v, c.view, around, -1), ink.with_alpha(0.75), s.hidden * 1.1, false);
  c.curve(stretches(chain, true, c.view, around_capsule(c.occluders, index, false)), ink, s.outline, false);
  std::vector<Vec2> points = c.projected(chain);
  points.push_back(points.front());
  c.block(points, s.outline / 2, true);
}

}  // namespace isect::viz
