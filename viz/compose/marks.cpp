#include "viz/compose/marks.h"

#include <numbers>

namespace isect::viz {

double mark_radius(Mark kind, const Sizes& sizes) {
  switch (kind) {
    case Mark::double_disc:
      return 1.9 * sizes.disc;
    case Mark::cross:
    case Mark::diamond:
    case Mark::no:
      return 1.4 * sizes.disc;
    default:
      return sizes.disc + sizes.marker_line / 2;
  }
}

namespace {

void cross_mark(std::vector<Shape>& out, const Vec2& p, const Colour& ink, const Theme& theme) {
  const Sizes& s = theme.sizes;
  const double a = 1.25 * s.disc;
  for (const bool halo : {true, false})
    for (const Vec2& d : {Vec2(a, a), Vec2(a, -a)})
      out.emplace_back(Stroke{polyline({p - d, p + d}),
                              halo ? theme.background : ink,
                              s.marker_line + (halo ? 2 * s.halo : 0),
                              {0, 0},
                              true});
}

void diamond_mark(std::vector<Shape>& out, const Vec2& p, const Theme& theme) {
  const Sizes& s = theme.sizes;
  const double a = 1.5 * s.disc;
  const Path path = polyline({p + Vec2(a, 0), p + Vec2(0, a), p - Vec2(a, 0), p - Vec2(0, a)}, true);
  const bool dark = theme.name == ThemeName::dark;
  out.emplace_back(Stroke{path, theme.background, 0.5 * s.marker_line + 2 * s.halo, {0, 0}, true});
  out.emplace_back(Fill{path, theme.ink(Role::highlight), 0, 0, {}});
  out.emplace_back(Stroke{path, dark ? theme.background : theme.ink(Role::text), 0.5 * s.marker_line, {0, 0}, true});
}

}  // namespace

void mark(std::vector<Shape>& out, Mark kind, const Vec2& p, Role role, const Theme& theme) {
  const Sizes& s = theme.sizes;
  const Colour ink = theme.ink(role);
  const bool edged = role == Role::highlight && theme.name != ThemeName::dark;  // yellow on white needs an edge
  const auto disc = [&](double radius, const Colour& colour) {
    out.emplace_back(Fill{circle(p, radius), colour, 0, 0, {}});
  };
  const auto ring = [&](double radius, double width, const Colour& colour, std::array<double, 2> dash = {0, 0}) {
    out.emplace_back(Stroke{circle(p, radius), colour, width, dash, false});
  };

  if (kind != Mark::cross && kind != Mark::diamond) disc(mark_radius(kind, s) + s.halo, theme.background);
  switch (kind) {
    case Mark::disc:
      if (edged) disc(s.disc + 0.25 * s.marker_line, theme.ink(Role::text));
      disc(edged ? s.disc - 0.25 * s.marker_line : s.disc, ink);
      break;
    case Mark::ring:
      if (edged) ring(s.ring, 1.5 * s.marker_line, theme.ink(Role::text));
      ring(s.ring, edged ? 0.7 * s.marker_line : s.marker_line, ink);
      break;
    case Mark::no:
      ring(1.4 * s.disc - s.marker_line / 2, s.marker_line, ink);
      break;
    case Mark::double_disc:
      ring(1.8 * s.disc, 0.8 * s.marker_line, ink);
      disc(0.8 * s.disc, ink);
      break;
    case Mark::cross:
      cross_mark(out, p, ink, theme);
      break;
    case Mark::diamond:
      diamond_mark(out, p, theme);
      break;
    case Mark::excluded: {
      const double dash = 2 * std::numbers::pi * s.ring / 14;  // seven dashes round the ring
      ring(s.ring, 0.65 * s.marker_line, theme.ink(Role::construction), {dash, dash});
      break;
    }
    case Mark::uncounted:
      ring(0.85 * s.ring, 0.55 * s.marker_line, theme.ink(Role::construction));
      break;
  }
}

Path arrow_head(const Vec2& tip, const Vec2& direction, double length) {
  const Vec2 side = {-direction.y(), direction.x()};
  const Vec2 base = tip - length * direction, notch = tip - 0.75 * length * direction;
  const double half = 0.36 * length;
  return polyline({tip, base + half * side, notch, base - half * side}, true);
}

}  // namespace isect::viz
