// The floor in the window's themes: a fading grid, soft shadows below the objects, and drop lines.

#include <algorithm>
#include <cmath>

#include "viz/compose/canvas.h"

namespace isect::viz {
namespace {

/// An object that stands on the floor: its middle, the radius of its shadow, its lowest point.
struct Standing {
  Vec3 middle;
  double radius, lowest;
};

/// Returns a shadow as large as the rectangle around the vertices, seen from above.
Standing standing(const std::vector<Vec3>& vertices) {
  Vec3 lo = Vec3::Constant(INFINITY), hi = Vec3::Constant(-INFINITY);
  for (const Vec3& p : vertices) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const Vec3 size = hi - lo;
  return {(lo + hi) / 2, 1.1 * std::sqrt(size.x() * size.z() / std::numbers::pi), lo.y()};
}

std::vector<Standing> all_standing(const Canvas& c) {
  std::vector<Standing> all;
  for (const Ball& b : c.occluders.balls) all.push_back({b.center, b.radius, b.center.y() - b.radius});
  for (const Capsule<double, 3>& capsule : c.occluders.capsules)
    for (const Vec3& end : {capsule.p, capsule.q}) all.push_back({end, capsule.radius, end.y() - capsule.radius});
  for (const Item& item : c.scene.items) {
    if (const Solid* solid = std::get_if<Solid>(&item)) all.push_back(standing(solid->vertices));
    if (const Mesh* mesh = std::get_if<Mesh>(&item)) all.push_back(standing(mesh->vertices));
  }
  return all;
}

void grid(Canvas& c, double level) {
  const View& view = c.view;
  const double reach = 2.2 * view.camera().half_height;
  const Vec3 middle = view.camera().target;
  const double spacing = std::pow(2.0, std::round(std::log2(view.camera().half_height / 3)));
  const auto fade = [&](const Vec3& p) {
    return std::clamp(Vec2(p.x() - middle.x(), p.z() - middle.z()).norm() / reach, 0.0, 1.0);
  };
  const int count = static_cast<int>(std::ceil(reach / spacing));
  const double x0 = spacing * std::round(middle.x() / spacing), z0 = spacing * std::round(middle.z() / spacing);
  for (int i = -count; i <= count; ++i) {
    for (int k = -count; k < count; ++k) {
      const double a = i * spacing, b0 = k * spacing, b1 = (k + 1) * spacing;
      const Vec3 ends[2][2] = {{{x0 + a, level, z0 + b0}, {x0 + a, level, z0 + b1}},
                               {{x0 + b0, level, z0 + a}, {x0 + b1, level, z0 + a}}};
      for (const auto& [from, to] : ends) {
        const double share = fade((from + to) / 2);
        if (share >= 1) continue;
        const Colour colour = mixed(c.theme.ink(Role::grid), c.theme.background, share);
        c.ground.emplace_back(Stroke{polyline({c.at(from), c.at(to)}), colour, c.sizes().hairline, {0, 0}, false});
      }
    }
  }
}

void shadow(Canvas& c, const Standing& thing, double level) {
  const Vec3 below = {thing.middle.x(), level, thing.middle.z()};
  const double scale = c.view.scale_at(below) * thing.radius;
  const bool dark = c.theme.name == ThemeName::dark;
  const Colour ink = dark ? hex(0x000000) : c.theme.ink(Role::text);
  c.ground.emplace_back(Gradient{c.at(below),
                                 {scale, 0},
                                 {0, scale * std::sin(c.view.camera().elevation)},
                                 c.at(below),
                                 ink.with_alpha(dark ? 0.55 : 0.16),
                                 ink.with_alpha(0)});
}

void drop_line(Canvas& c, const Dot& dot, double level) {
  const Vec3 foot = {dot.at.x(), level, dot.at.z()};
  const double w = c.sizes().hairline;
  const Colour ink = c.theme.ink(Role::construction);
  c.ground.emplace_back(Stroke{polyline({c.at(dot.at), c.at(foot)}), ink, w, {1.2 * w, 3.2 * w}, false});
  c.ground.emplace_back(Fill{circle(c.at(foot), 2.2 * w), ink, 0, 0, {}});
  c.block({c.at(dot.at), c.at(foot)}, w, false);
}

}  // namespace

/// Draws the floor at the lowest point of the scene. Its grid fades into the background, so it needs no edge.
void draw_floor(Canvas& c) {
  const std::vector<Standing> things = all_standing(c);
  double lowest = INFINITY;
  for (const Standing& thing : things) lowest = std::min(lowest, thing.lowest);
  for (const Item& item : c.scene.items) {
    if (const Dot* dot = std::get_if<Dot>(&item)) lowest = std::min(lowest, dot->at.y());
    if (const Region* region = std::get_if<Region>(&item))
      for (const std::vector<Vec3>& ring : region->rings)
        for (const Vec3& p : ring) lowest = std::min(lowest, p.y());
  }
  if (!std::isfinite(lowest)) return;

  grid(c, lowest);
  for (const Standing& thing : things) shadow(c, thing, lowest);
  for (const Item& item : c.scene.items) {
    const Dot* dot = std::get_if<Dot>(&item);
    const double least = 2.2e-3 * c.view.camera().half_height;
    if (dot != nullptr && c.theme.like(dot->role) == Role::first && dot->at.y() - lowest >= least)
      drop_line(c, *dot, lowest);
  }
}

}  // namespace isect::viz
