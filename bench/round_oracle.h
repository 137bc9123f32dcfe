#pragma once
// A cylinder or a cone in rationals: between its ends, by divisions, at each height a disc.

#include "bench/rational.h"

namespace isect::oracle {

struct RoundSolid {
  Coordinates<3> start, d;
  Rational at_start, at_end;  ///< how wide it is there
  bool exists;

  /// 0 at the start of the axis, 1 at its end.
  Rational height(const Coordinates<3>& x) const { return dot(x - start, d) / dot(d, d); }
  Rational from_axis2(const Coordinates<3>& x) const {
    const Coordinates<3> off = x - (start + height(x) * d);
    return dot(off, off);
  }
  Rational radius(const Rational& height) const { return at_start + height * (at_end - at_start); }
  Location locate(const Coordinates<3>& x) const {
    if (!exists) return Location::out;
    const Rational h = height(x);
    if (h < 0 || h > 1) return Location::out;
    const Rational r = radius(h), distance2 = from_axis2(x);
    if (distance2 > r * r) return Location::out;
    return h > 0 && h < 1 && distance2 < r * r ? Location::in : Location::on;
  }
};

template <class S>
RoundSolid round_solid(const Cylinder<S>& c) {
  if (!finite(c) || empty(c)) return {{}, {}, 0, 0, false};
  return {rational(c.p), rational(c.q) - rational(c.p), c.radius, c.radius, true};
}
template <class S>
RoundSolid round_solid(const Cone<S>& c) {
  if (!finite(c) || empty(c)) return {{}, {}, 0, 0, false};
  return {rational(c.apex), rational(c.base) - rational(c.apex), 0, c.radius, true};
}

template <class Solid>
concept Round = requires(const Solid& solid) {
  round_solid(solid);
};

}  // namespace isect::oracle
