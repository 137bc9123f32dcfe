#pragma once
// Which part of a line lies in a cylinder or a cone, in rationals: no quadratic's root and no discriminant. Between the
// planes of both ends the line is inside at once where it comes in, or where it goes out, or where the square of its
// distance from the axis exceeds the square of what is allowed by least, or nowhere.

#include "bench/line_in_convex.h"
#include "bench/round_oracle.h"

namespace isect::oracle {

/// A line that has a direction, and a solid that exists.
inline LineInConvex line_in(const Coordinates<3>& o, const Coordinates<3>& u, const RoundSolid& solid) {
  const auto at = [=](const Rational& t) { return o + t * u; };
  const auto holds = [=](const Rational& t) { return solid.locate(at(t)) != Location::out; };
  const auto excess = [=](const Rational& t) -> Rational {
    const Rational r = solid.radius(solid.height(at(t)));
    return solid.from_axis2(at(t)) - r * r;
  };
  std::vector<Rational> candidates = {0};
  const Rational climb = dot(u, solid.d) / dot(solid.d, solid.d), from = solid.height(o);
  if (climb != 0) candidates = {Rational(-from / climb), Rational((1 - from) / climb)};
  // The excess at -1, 0 and 1 is that of a parabola, whose least value is at -slope / curvature
  const Rational curvature = excess(1) + excess(-1) - 2 * excess(0), slope = (excess(1) - excess(-1)) / 2;
  if (curvature > 0) candidates.push_back(-slope / curvature);
  for (const Rational& t : candidates)
    if (holds(t)) return {holds, t};
  return {holds, {}};
}

template <class S, Round Solid>
LineInConvex line_in(const Ray<S, 3>& ray, const Solid& solid) {
  return line_in(rational(ray.origin), rational(ray.direction), round_solid(solid));
}
/// The line through a segment's exact ends, t = 0 and 1 at them.
template <class S, Round Solid>
LineInConvex line_in(const Segment<S, 3>& segment, const Solid& solid) {
  return line_in(rational(segment.p), rational(segment.q) - rational(segment.p), round_solid(solid));
}

/// Whether the range of a ray that is finite meets the solid.
template <class S, Round Solid>
bool meets(const Ray<S, 3>& ray, const Solid& solid) {
  if (!(ray.range.lo <= ray.range.hi) || ray.range.lo == infinite<S>.hi || ray.range.hi == infinite<S>.lo) return false;
  if (!finite(ray)) return false;
  const RoundSolid exact = round_solid(solid);
  if (!exact.exists) return false;
  if (ray.direction.isZero(0)) return exact.locate(rational(ray.origin)) != Location::out;
  return line_in(ray, solid).meets(cast<double>(ray.range));
}

}  // namespace isect::oracle
