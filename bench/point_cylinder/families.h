#pragma once
// Points that are hard to tell in or out of a cylinder, or of a cone.

#include "bench/round_families.h"

namespace isect::bench {

template <class S, class Solid>
using PointAndSolid = Pair<Point<S, 3>, Solid>;

namespace point_and_solid {

template <class S, template <class> class Solid>
PointAndSolid<S, Solid<S>> ordinary(Random& random) {
  const Point<S, 3> point = random.in_box<3>(1).template cast<S>();
  return {point, ordinary_solid<Solid<S>>(random)};
}

/// A point on the surface up to rounding and a few ulp.
template <class S, template <class> class Solid, Patch patch>
PointAndSolid<S, Solid<S>> near_surface(Random& random) {
  const Solid<S> solid = ordinary_solid<Solid<S>>(random);
  Point<S, 3> point = spot(random, cast<double>(solid), patch).at.template cast<S>();
  for (S& x : point) x = moved(x, random.integer(-2, 2));
  return {point, solid};
}

/// Integers: a point on the surface.
template <class S, template <class> class Solid>
PointAndSolid<S, Solid<S>> exact_touch(Random& random) {
  const auto whole = whole_solid<Solid<double>>(random, all_patches[random.below(3)]);
  PointAndSolid<S, Solid<S>> c = {whole.at.template cast<S>(), cast<S>(whole.solid)};
  const int exponent = random.integer(-20, 20);
  bench::scale(exponent, c.a), scale_solid(exponent, c.b);
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S, template <class> class Solid>
PointAndSolid<S, Solid<S>> scale(Random& random) {
  PointAndSolid<S, Solid<S>> c = near_surface<S, Solid, Patch::side>(random);
  const int exponent = beyond_squares<S>(random);
  bench::scale(exponent, c.a), scale_solid(exponent, c.b);
  return c;
}

template <class S, template <class> class Solid>
PointAndSolid<S, Solid<S>> invalid(Random& random) {
  PointAndSolid<S, Solid<S>> c = ordinary<S, Solid>(random);
  if (random.one_in(3))
    c.a[random.below(3)] = std::numeric_limits<S>::quiet_NaN();
  else
    spoil(random, c.b);
  return c;
}

/// Any point and solid; the point is on the surface at times, up to rounding and an ulp.
template <class S, template <class> class Solid>
PointAndSolid<S, Solid<S>> of_any_numbers(Random& random, Numbers numbers) {
  PointAndSolid<S, Solid<S>> c = {vector<S, 3>(random, numbers), solid<Solid<S>>(random, numbers)};
  if (random.one_in(2) || !finite(c.b) || empty(c.b)) return c;
  const Point<double, 3> at = spot(random, cast<double>(c.b), all_patches[random.below(3)]).at;
  for (int i = 0; i < 3; ++i) c.a[i] = moved(static_cast<S>(at[i]), random.integer(-1, 1));
  return c;
}

}  // namespace point_and_solid

template <class S, template <class> class Solid>
constexpr std::array<NamedDraw<PointAndSolid<S, Solid<S>>>, 7> point_and_solid_draws = {{
    {"ordinary", point_and_solid::ordinary<S, Solid>},
    {"side", point_and_solid::near_surface<S, Solid, Patch::side>, "points of the side but for a few ulp."},
    {"end", point_and_solid::near_surface<S, Solid, Patch::end>, "the same of a flat end, or the apex."},
    {"rim", point_and_solid::near_surface<S, Solid, Patch::rim>, "the same where both meet."},
    {"exact-touch", point_and_solid::exact_touch<S, Solid>, "integers: points exactly on the surface."},
    {"scale", point_and_solid::scale<S, Solid>, "sizes at which squares overflow or vanish."},
    {"invalid", point_and_solid::invalid<S, Solid>, "NaN, infinities, negative radii, no axis."},
}};
template <class S>
constexpr auto& point_cylinder_draws = point_and_solid_draws<S, Cylinder>;
template <class S>
constexpr auto& point_cone_draws = point_and_solid_draws<S, Cone>;

}  // namespace isect::bench
