#pragma once
// Sphere against a disc across the axis of a cylinder or of a cone (isect/parts/round_solid.h), R wide around b.
//
// Let f lead from b to the ball's center c. The disc's rim is nearest to c, and farthest from it, where the plane
// through c and the axis meets it, by
//
//   |f|^2 + R^2 -+ 2 R |f x d| / |d|,
//
// squared. Less s^2 that is E -+ 2 R |f x d| / |d| with E = |f|^2 + R^2 - s^2, whose sign is that of E where the other
// term does not oppose it, else of the difference of their squares, E^2 d.d - 4 R^2 |f x d|^2. For the core's own use.

#include <isect/parts/round_solid.h>

namespace isect::sphere_round {

/// The sign of the center's distance from the nearest (way -1) or the farthest (1) point of the rim less the radius.
template <class Solid, class Trace>
int rim(const Sphere<double, 3>& ball, const round_solid::Disc& disc, const Solid& solid, int way, Trace&& trace) {
  const auto excess = [&]<class W>() -> W {
    const Components<W, 3> f = difference<W>(ball.center, disc.center);
    return dot(f, f) + (W(disc.radius) * W(disc.radius) - W(ball.radius) * W(ball.radius));
  };
  const int sign = sign_of(excess, trace);
  if (sign == way || disc.radius == 0) return sign;
  return -way * sign_of(
                    [&]<class W>() -> W {
                      const Components<W, 3> d = round_solid::axis<W>(solid);
                      const Components<W, 3> n = cross(difference<W>(ball.center, disc.center), d);
                      const W e = excess.template operator()<W>(), twice = W(2) * W(disc.radius);
                      return e * e * dot(d, d) - twice * twice * dot(n, n);
                    },
                    trace);
}

/// The sign of the center's distance from the disc's plane less the radius.
template <class Solid, class Trace>
int plane(const Sphere<double, 3>& ball, const round_solid::Disc& disc, const Solid& solid, Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, 3> d = round_solid::axis<W>(solid);
        const W height = dot(difference<W>(ball.center, disc.center), d), s = W(ball.radius);
        return height * height - s * s * dot(d, d);
      },
      trace);
}

/// The sign of |f x d|^2 - reach^2 d.d, with f leading from the disc's center to the ball's: of the distance from the
/// axis less what radius(W(R), W(s)) says.
template <class Solid, class Radius, class Trace>
int from_axis(const Sphere<double, 3>& ball, const round_solid::Disc& disc, const Solid& solid, const Radius& radius,
              Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, 3> d = round_solid::axis<W>(solid);
        const W reach = radius(W(disc.radius), W(ball.radius));
        return point_segment::detail::cross_squared(difference<W>(ball.center, disc.center), d) -
               reach * reach * dot(d, d);
      },
      trace);
}

/// Whether the ball holds the solid: both discs, whose convex hull it is.
template <class Solid, class Trace>
bool holds(const Sphere<double, 3>& ball, const Solid& solid, Trace&& trace) {
  for (const round_solid::Disc& disc : round_solid::discs(solid))
    if (rim(ball, disc, solid, 1, trace) > 0) return false;
  return true;
}

template <class S, class Solid>
bool exist(const Sphere<S, 3>& ball, const Solid& solid) {
  return !empty(ball) && finite(ball) && round_solid::exists(solid);
}

}  // namespace isect::sphere_round
