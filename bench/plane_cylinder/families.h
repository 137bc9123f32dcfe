#pragma once
// Planes that are hard to tell from ones that miss a cylinder, or a cone.

#include "bench/round_families.h"

namespace isect::bench {

template <class S, class Solid>
using PlaneAndSolid = Pair<Plane<S, 3>, Solid>;

namespace plane_and_solid {

/// A plane through a point, up to rounding and a few ulp.
template <class S>
Plane<S, 3> through(Random& random, const Point<double, 3>& at, const Vector<double, 3>& normal) {
  const Vector<S, 3> n = normal.template cast<S>();
  return {n, moved(static_cast<S>(-n.template cast<double>().dot(at)), random.integer(-2, 2))};
}

template <class S, template <class> class Solid>
PlaneAndSolid<S, Solid<S>> ordinary(Random& random) {
  const Vector<double, 3> normal = random.heading<3>();
  const Plane<S, 3> plane = {normal.cast<S>(), static_cast<S>(random.uniform(-1.5, 1.5))};
  return {plane, ordinary_solid<Solid<S>>(random)};
}

template <class S, template <class> class Solid, Patch patch>
PlaneAndSolid<S, Solid<S>> near_tangent(Random& random) {
  const Solid<S> solid = ordinary_solid<Solid<S>>(random);
  const Spot on = spot(random, cast<double>(solid), patch);
  return {through<S>(random, on.at, on.normal), solid};
}

/// Integers: planes that touch.
template <class S, template <class> class Solid>
PlaneAndSolid<S, Solid<S>> exact_touch(Random& random) {
  const auto whole = whole_solid<Solid<double>>(random, all_patches[random.below(3)]);
  const Vector<double, 3> normal = random.sign() * whole.normal;
  PlaneAndSolid<S, Solid<S>> c = {{normal.cast<S>(), static_cast<S>(-normal.dot(whole.at))}, cast<S>(whole.solid)};
  const int exponent = random.integer(-20, 20);
  bench::scale(exponent, c.a.d), scale_solid(exponent, c.b);
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S, template <class> class Solid>
PlaneAndSolid<S, Solid<S>> scale(Random& random) {
  PlaneAndSolid<S, Solid<S>> c = near_tangent<S, Solid, Patch::rim>(random);
  const int exponent = beyond_squares<S>(random);
  bench::scale(exponent, c.a.d), scale_solid(exponent, c.b);
  return c;
}

template <class S, template <class> class Solid>
PlaneAndSolid<S, Solid<S>> invalid(Random& random) {
  PlaneAndSolid<S, Solid<S>> c = ordinary<S, Solid>(random);
  switch (random.below(4)) {
    case 0:
      c.a.normal[random.below(3)] = std::numeric_limits<S>::quiet_NaN();
      break;
    case 1:
      c.a.normal.setZero();
      break;
    default:
      spoil(random, c.b);
  }
  return c;
}

/// Any plane and solid: along a coordinate axis, along the solid's, or touching the surface at times, up to rounding.
template <class S, template <class> class Solid>
PlaneAndSolid<S, Solid<S>> of_any_numbers(Random& random, Numbers numbers) {
  const Vector<S, 3> normal = vector<S, 3>(random, random.one_in(2) ? Numbers::grid : numbers);
  const S d = number<S>(random, numbers);
  PlaneAndSolid<S, Solid<S>> c = {{normal, d}, solid<Solid<S>>(random, numbers)};
  const auto [p, q, narrow] = axis_of(c.b);
  if (random.one_in(3)) c.a.normal = Vector<S, 3>::Unit(random.below(3));
  if (random.one_in(6)) c.a.normal = q - p;
  const Vector<double, 3> n = c.a.normal.template cast<double>();
  if (random.one_in(4)) c.a.d = moved(static_cast<S>(-n.dot(q.template cast<double>())), random.integer(-2, 2));
  if (!finite(c.b) || empty(c.b)) return c;
  if (random.one_in(3)) {
    const Spot on = spot(random, cast<double>(c.b), all_patches[random.below(3)]);
    if (finite(on.at) && finite(on.normal)) c.a = through<S>(random, on.at, on.normal);
  } else if (random.one_in(2)) {  // the radius that makes it touch
    const Vector<double, 3> along = (q.template cast<double>() - p.template cast<double>()).stableNormalized();
    const double height = std::abs(n.dot(q.template cast<double>()) + static_cast<double>(c.a.d));
    const double r = height / (n - n.dot(along) * along).stableNorm();
    if (std::isfinite(static_cast<S>(r))) c.b.radius = moved(static_cast<S>(r), random.integer(-2, 2));
  }
  return c;
}

}  // namespace plane_and_solid

template <class S, template <class> class Solid>
constexpr std::array<NamedDraw<PlaneAndSolid<S, Solid<S>>>, 7> plane_and_solid_draws = {{
    {"ordinary", plane_and_solid::ordinary<S, Solid>},
    {"side", plane_and_solid::near_tangent<S, Solid, Patch::side>, "planes that touch the side but for a few ulp."},
    {"end", plane_and_solid::near_tangent<S, Solid, Patch::end>, "planes that lie in an end but for a few ulp."},
    {"rim", plane_and_solid::near_tangent<S, Solid, Patch::rim>, "planes that touch where side and end meet."},
    {"exact-touch", plane_and_solid::exact_touch<S, Solid>, "integers: planes that touch exactly."},
    {"scale", plane_and_solid::scale<S, Solid>, "sizes at which squares overflow or vanish."},
    {"invalid", plane_and_solid::invalid<S, Solid>, "NaN, no normal, negative radii, no axis."},
}};
template <class S>
constexpr auto& plane_cylinder_draws = plane_and_solid_draws<S, Cylinder>;
template <class S>
constexpr auto& plane_cone_draws = plane_and_solid_draws<S, Cone>;

}  // namespace isect::bench
