#pragma once
// Rays that are hard to tell from ones that miss a cylinder, or a cone.

#include "bench/random_rays.h"
#include "bench/round_families.h"

namespace isect::bench {

template <class S, class Solid>
using RayAndSolid = Pair<Ray<S, 3>, Solid>;

namespace ray_and_solid {

template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> ordinary(Random& random) {
  const Ray<S, 3> ray = ordinary_ray<S>(random);
  return {ray, ordinary_solid<Solid<S>>(random)};
}

/// A ray through a place of the surface, in a plane that touches the solid there, up to rounding.
template <class S>
Ray<S, 3> tangent(Random& random, const Spot& spot) {
  const Vector<double, 3> across = spot.normal.cross(random.heading<3>()).normalized();
  Ray<S, 3> ray = {(spot.at - random.uniform(1, 3) * across).template cast<S>(), across.cast<S>()};
  ray.direction = spot.at.template cast<S>() - ray.origin;
  return ray;
}
template <class S, template <class> class Solid, Patch patch>
RayAndSolid<S, Solid<S>> near_tangent(Random& random) {
  const Solid<S> solid = ordinary_solid<Solid<S>>(random);
  return {tangent<S>(random, spot(random, cast<double>(solid), patch)), solid};
}

/// A ray along the side, up to rounding; on a cone along a line of it, where the quadratic is nearly linear.
template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> along_side(Random& random) {
  Solid<double> wide = ordinary_solid<Solid<double>>(random);
  const Spot on = spot(random, wide, Patch::side);
  const auto [p, q, narrow] = axis_of(wide);
  const Vector<double, 3> around = (q - p).cross(on.normal), along = around.cross(on.normal).normalized();
  Ray<S, 3> ray = {(on.at - random.uniform(1, 3) * along).template cast<S>(), along.cast<S>()};
  if (random.one_in(2)) ray.origin += (random.uniform(-0.3, 0.1) * on.normal).template cast<S>();
  return {ray, cast<S>(wide)};
}

/// Integers: a ray in a plane that touches the solid, through the point of touch.
template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> exact_touch(Random& random) {
  const auto whole = whole_solid<Solid<double>>(random, all_patches[random.below(3)]);
  const Vector<double, 3> second = whole.normal.cross(whole.tangent) / 75;
  const Vector<double, 3> along = random.integer(1, 4) * whole.tangent + random.integer(-4, 4) * second;
  const Point<double, 3> from = whole.at - random.integer(0, 4) * along;
  RayAndSolid<S, Solid<S>> c = {{from.cast<S>(), along.cast<S>()}, cast<S>(whole.solid)};
  const int exponent = random.integer(-20, 20);
  bench::scale(exponent, c.a.origin), scale_solid(exponent, c.b);
  return c;
}

/// A near tangent from far away.
template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> far(Random& random) {
  RayAndSolid<S, Solid<S>> c = near_tangent<S, Solid, Patch::side>(random);
  c.a.origin -= static_cast<S>(std::abs(random.magnitude(2, std::is_same_v<S, float> ? 4 : 9))) * c.a.direction;
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> scale(Random& random) {
  RayAndSolid<S, Solid<S>> c = ordinary<S, Solid>(random);
  const int exponent = beyond_squares<S>(random);
  bench::scale(exponent, c.a.origin), scale_solid(exponent, c.b);
  if (random.one_in(2)) bench::scale(exponent, c.a.direction);
  return c;
}

template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> invalid(Random& random) {
  RayAndSolid<S, Solid<S>> c = ordinary<S, Solid>(random);
  switch (random.below(4)) {
    case 0:
      c.a.origin[random.below(3)] = std::numeric_limits<S>::quiet_NaN();
      break;
    case 1:
      c.a.direction[random.below(3)] = std::numeric_limits<S>::infinity();
      break;
    default:
      spoil(random, c.b);
  }
  return c;
}

/// Any ray and solid: along its axis or from a point of that at times, or through a place of the surface, in a plane
/// that touches it, up to rounding.
template <class S, template <class> class Solid>
RayAndSolid<S, Solid<S>> of_any_numbers(Random& random, Numbers numbers) {
  RayAndSolid<S, Solid<S>> c = {ray<S, 3>(random, numbers), solid<Solid<S>>(random, numbers)};
  const auto [p, q, narrow] = axis_of(c.b);
  if (random.one_in(6)) c.a.direction = q - p;
  if (random.one_in(8)) c.a.origin = p / 2 + q / 2;
  if (random.one_in(8)) c.a.origin = random.one_in(2) ? p : q;
  if (random.one_in(2)) {
    const auto end = [&] { return static_cast<S>(random.integer(-8, 8)) / 4; };
    const S first = end(), last = end();
    c.a.range = {random.one_in(3) ? infinite<S>.lo : std::min(first, last),
                 random.one_in(2) ? infinite<S>.hi : std::max(first, last)};
  }
  if (random.one_in(2) || !finite(c.b) || empty(c.b)) return c;
  Solid<double> wide = cast<double>(c.b);
  const Spot on = spot(random, wide, all_patches[random.below(3)]);
  const double size = (axis_of(wide).q - axis_of(wide).p).stableNorm() + wide.radius;
  const Vector<double, 3> along = random.one_in(4) ? Vector<double, 3>((axis_of(wide).q - on.at) / size)
                                                   : Vector<double, 3>(on.normal.cross(random.heading<3>()));
  const double back = static_cast<double>(random.integer(0, 8)) / 4;
  c.a.direction = (size * along).template cast<S>();
  c.a.origin = (on.at - back * size * along).template cast<S>();
  return c;
}

}  // namespace ray_and_solid

template <class S, template <class> class Solid>
constexpr std::array<NamedDraw<RayAndSolid<S, Solid<S>>>, 9> ray_and_solid_draws = {{
    {"ordinary", ray_and_solid::ordinary<S, Solid>},
    {"side", ray_and_solid::near_tangent<S, Solid, Patch::side>, "rays that touch the side but for a few ulp."},
    {"end", ray_and_solid::near_tangent<S, Solid, Patch::end>, "rays in the plane of an end but for a few ulp."},
    {"rim", ray_and_solid::near_tangent<S, Solid, Patch::rim>, "rays that touch where side and end meet."},
    {"along", ray_and_solid::along_side<S, Solid>, "rays parallel to a line of the side but for a few ulp."},
    {"exact-touch", ray_and_solid::exact_touch<S, Solid>, "integers: rays that touch exactly."},
    {"far", ray_and_solid::far<S, Solid>, "rays that touch the side nearly, from far away."},
    {"scale", ray_and_solid::scale<S, Solid>, "sizes at which squares overflow or vanish."},
    {"invalid", ray_and_solid::invalid<S, Solid>, "NaN, infinities, negative radii, no axis."},
}};
template <class S>
constexpr auto& ray_cylinder_draws = ray_and_solid_draws<S, Cylinder>;
template <class S>
constexpr auto& ray_cone_draws = ray_and_solid_draws<S, Cone>;

}  // namespace isect::bench
