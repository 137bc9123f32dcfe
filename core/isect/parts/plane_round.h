#pragma once
// Plane against a cylinder or a cone (isect/parts/round_solid.h).
//
// The solid is the convex hull of the discs at the ends of its axis, the one at a cone's apex a point. From the height
// n.c + e of its center a disc of radius r, across the axis d, rises and falls by r |n x d| / |d|. So on the way up, or
// down
//
//   n.c + e +- r |n x d| / |d|,
//
// the highest of both discs is the solid's highest point, and the lowest of both its lowest. The sign needs neither the
// quotient nor the root: it is that of n.c + e where the other term does not oppose it, else that of the difference of
// their squares, (n.c + e)^2 d.d - r^2 |n x d|^2. Source: Ericson, Real-Time Collision Detection (2005), 5.2.4, of a
// cone.

#include <algorithm>
#include <array>
#include <variant>

#include <isect/parts/round_solid.h>
#include <isect/plane_sphere.h>
#include <isect/trace.h>

namespace isect::plane_round {

/// The signs of the heights of the solid's lowest and of its highest point.
struct Decision {
  int lowest, highest;
};
using Event = std::variant<Decision, Fallback>;

namespace detail {

/// The sign of the height of the disc's highest point, 1, or of its lowest, -1.
template <class Solid, class Trace>
int extreme(const Plane<double, 3>& plane, const round_solid::Disc& disc, const Solid& solid, int way, Trace&& trace) {
  const auto height = [&]<class W>() -> W { return plane_sphere::detail::height<W, 3>(plane, disc.center); };
  const int center = sign_of(height, trace);
  if (center == way || disc.radius == 0) return center;
  const auto tilt2 = [&]<class W>() -> W {  // what the disc rises and falls by, times |d|, squared
    const Components<W, 3> across = cross(exactly<W, 3>(plane.normal), round_solid::axis<W>(solid));
    return W(disc.radius) * W(disc.radius) * dot(across, across);
  };
  return way * sign_of(
                   [&]<class W>() -> W {
                     const Components<W, 3> d = round_solid::axis<W>(solid);
                     const W h = height.template operator()<W>();
                     return tilt2.template operator()<W>() - h * h * dot(d, d);
                   },
                   trace);
}

template <class Solid, class Trace>
Decision decide(const Plane<double, 3>& plane, const Solid& solid, Trace&& trace) {
  const std::array<round_solid::Disc, 2> discs = round_solid::discs(solid);
  const auto of = [&](const round_solid::Disc& disc, int way) { return extreme(plane, disc, solid, way, trace); };
  return {std::min(of(discs[0], -1), of(discs[1], -1)), std::max(of(discs[0], 1), of(discs[1], 1))};
}

/// Whether there is a plane and a solid at all.
template <class S, class Solid>
bool meaningful(const Plane<S, 3>& plane, const Solid& solid) {
  return finite(plane) && !plane.normal.isZero(0) && round_solid::exists(solid);
}

template <class S, class Solid, class Trace>
Decision decision(const Plane<S, 3>& plane, const Solid& solid, Trace&& trace) {
  const Plane<double, 3> wide = cast<double>(plane);
  return in_doubles_first([&](auto& listener) { return decide(wide, in_doubles(solid), listener); }, trace);
}

}  // namespace detail

}  // namespace isect::plane_round
