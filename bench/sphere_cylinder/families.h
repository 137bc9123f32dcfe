#pragma once
// Balls that are hard to tell from ones that miss a cylinder, or a cone, or fit in, or hold it.

#include "bench/round_families.h"

namespace isect::bench {

template <class S, class Solid>
using BallAndSolid = Pair<Sphere<S, 3>, Solid>;

namespace ball_and_solid {

template <class S, template <class> class Solid>
BallAndSolid<S, Solid<S>> ordinary(Random& random) {
  const Sphere<S, 3> ball = ordinary_sphere<S>(random);
  return {ball, ordinary_solid<Solid<S>>(random)};
}

/// A radius that makes the ball touch the solid, hold it, or fit in, up to rounding.
template <class Solid>
double critical_radius(const Point<double, 3>& center, Solid solid, Way way) {
  const auto [p, q, narrow] = axis_of(solid);
  const Vector<double, 3> d = q - p, f = center - p;
  const double length = d.stableNorm(), along = f.dot(d / length), beside = (f - along * (d / length)).stableNorm();
  const double r = solid.radius, growth = r - narrow, slant = std::hypot(length, growth);
  const double to_side = ((narrow - beside) * length + growth * along) / slant;  // from within
  if (way == Way::fit_in) return std::min({along, length - along, to_side});
  if (way == Way::contain) return std::max(std::hypot(along, beside + narrow), std::hypot(length - along, beside + r));
  const auto to_edge = [&](double x0, double y0, double x1, double y1) {
    const double u = x1 - x0, v = y1 - y0, all = u * u + v * v;
    const double t = all > 0 ? std::clamp(((along - x0) * u + (beside - y0) * v) / all, 0.0, 1.0) : 0;
    return std::hypot(along - (x0 + t * u), beside - (y0 + t * v));
  };
  return std::min({to_edge(0, 0, 0, narrow), to_edge(0, narrow, length, r), to_edge(length, r, length, 0)});
}

template <class S, template <class> class Solid, Patch patch>
BallAndSolid<S, Solid<S>> near_touch(Random& random) {
  BallAndSolid<S, Solid<S>> c = {{}, ordinary_solid<Solid<S>>(random)};
  const Spot on = spot(random, cast<double>(c.b), patch);
  c.a.center = (on.at + random.uniform(0.05, 1) * on.normal).template cast<S>();
  const double r = critical_radius(c.a.center.template cast<double>(), cast<double>(c.b), Way::touch);
  c.a.radius = moved(static_cast<S>(r), random.integer(-2, 2));
  return c;
}

/// Balls that hold the solid, or fit in, up to rounding.
template <class S, template <class> class Solid, Way way>
BallAndSolid<S, Solid<S>> near_fit(Random& random) {
  BallAndSolid<S, Solid<S>> c = {{}, ordinary_solid<Solid<S>>(random)};
  auto [p, q, narrow] = axis_of(c.b);
  const S t = static_cast<S>(random.uniform(0.2, 0.9));
  c.a.center = p + t * (q - p);
  if (way == Way::contain) c.a.center += random.in_box<3>(1).template cast<S>();
  if (way == Way::fit_in) c.a.center += (c.b.radius / 8) * random.in_box<3>(1).template cast<S>();
  const double r = critical_radius(c.a.center.template cast<double>(), cast<double>(c.b), way);
  c.a.radius = moved(static_cast<S>(r), random.integer(-2, 2));
  return c;
}

/// Integers: balls that touch from outside, or from within.
template <class S, template <class> class Solid>
BallAndSolid<S, Solid<S>> exact_touch(Random& random) {
  const auto whole = whole_solid<Solid<double>>(random, all_patches[random.below(3)]);
  const int k = random.integer(-1, 8);
  const Point<double, 3> center = whole.at + k * whole.normal;
  BallAndSolid<S, Solid<S>> c = {{center.cast<S>(), static_cast<S>(75 * std::abs(k))}, cast<S>(whole.solid)};
  const int exponent = random.integer(-20, 20);
  bench::scale(exponent, c.a.center, c.a.radius), scale_solid(exponent, c.b);
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S, template <class> class Solid>
BallAndSolid<S, Solid<S>> scale(Random& random) {
  BallAndSolid<S, Solid<S>> c = near_touch<S, Solid, Patch::side>(random);
  const int exponent = beyond_squares<S>(random);
  bench::scale(exponent, c.a.center, c.a.radius), scale_solid(exponent, c.b);
  return c;
}

template <class S, template <class> class Solid>
BallAndSolid<S, Solid<S>> invalid(Random& random) {
  BallAndSolid<S, Solid<S>> c = ordinary<S, Solid>(random);
  switch (random.below(4)) {
    case 0:
      c.a.center[random.below(3)] = std::numeric_limits<S>::quiet_NaN();
      break;
    case 1:
      c.a.radius = -c.a.radius;
      break;
    default:
      spoil(random, c.b);
  }
  return c;
}

/// Any ball and solid: on the axis at times, and with a radius that makes it touch, fit in or hold the solid, nearly.
template <class S, template <class> class Solid>
BallAndSolid<S, Solid<S>> of_any_numbers(Random& random, Numbers numbers) {
  const Sphere<S, 3> drawn = ball<S, 3>(random, numbers);
  BallAndSolid<S, Solid<S>> c = {drawn, solid<Solid<S>>(random, numbers)};
  const auto [p, q, narrow] = axis_of(c.b);
  if (random.one_in(6)) c.a.center = p / 2 + q / 2;
  if (random.one_in(12)) c.a.center = random.one_in(2) ? p : q;
  if (random.one_in(3) || !finite(c.b) || empty(c.b) || !finite(c.a)) return c;
  const Way way = std::array{Way::touch, Way::contain, Way::fit_in}[static_cast<std::size_t>(random.below(3))];
  const S r = static_cast<S>(critical_radius(c.a.center.template cast<double>(), cast<double>(c.b), way));
  if (std::isfinite(r)) c.a.radius = moved(std::abs(r), random.integer(-2, 2));
  return c;
}

}  // namespace ball_and_solid

template <class S, template <class> class Solid>
constexpr std::array<NamedDraw<BallAndSolid<S, Solid<S>>>, 9> ball_and_solid_draws = {{
    {"ordinary", ball_and_solid::ordinary<S, Solid>},
    {"side", ball_and_solid::near_touch<S, Solid, Patch::side>, "balls that touch the side but for a few ulp."},
    {"end", ball_and_solid::near_touch<S, Solid, Patch::end>, "the same of a flat end, or the apex."},
    {"rim", ball_and_solid::near_touch<S, Solid, Patch::rim>, "the same where both meet."},
    {"inside", ball_and_solid::near_fit<S, Solid, Way::fit_in>, "balls that just fit in, or do not."},
    {"around", ball_and_solid::near_fit<S, Solid, Way::contain>, "balls that just hold the solid, or do not."},
    {"exact-touch", ball_and_solid::exact_touch<S, Solid>, "integers: balls that touch exactly."},
    {"scale", ball_and_solid::scale<S, Solid>, "sizes at which squares overflow or vanish."},
    {"invalid", ball_and_solid::invalid<S, Solid>, "NaN, negative radii, no axis."},
}};
template <class S>
constexpr auto& sphere_cylinder_draws = ball_and_solid_draws<S, Cylinder>;
template <class S>
constexpr auto& sphere_cone_draws = ball_and_solid_draws<S, Cone>;

}  // namespace isect::bench
