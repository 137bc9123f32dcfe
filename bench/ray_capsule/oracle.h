#pragma once
// Which part of a line lies in a capsule, in rationals: no quadratic and no root. The distance of a point of the line
// from the axis is compared with r by the point's projection onto the axis; where it is least, the line is inside if it
// is anywhere.

#include <vector>

#include "bench/line_in_convex.h"
#include "bench/sphere_capsule/oracle.h"

namespace isect::oracle {

/// A line, which has a direction, and a capsule.
template <int N>
LineInConvex line_in_capsule(const Coordinates<N>& o, const Coordinates<N>& d, const Stretch<N>& axis,
                             const Rational& radius) {
  const auto from_axis2 = [=](const Rational& t) { return distance2<N>(o + t * d, axis); };
  const Rational dd = dot(d, d);
  std::vector<Rational> candidates = {dot(axis.p - o, d) / dd, dot(axis.at(1) - o, d) / dd};
  const Coordinates<N> w = axis.p - o;
  const Rational dv = dot(d, axis.d), vv = dot(axis.d, axis.d), determinant = dd * vv - dv * dv;
  if (determinant != 0) candidates.push_back((dot(w, d) * vv - dv * dot(w, axis.d)) / determinant);
  Rational nearest = candidates.front();
  for (const Rational& t : candidates)
    if (from_axis2(t) < from_axis2(nearest)) nearest = t;
  const auto holds = [=](const Rational& t) { return at_most(from_axis2(t), radius); };
  return {holds, holds(nearest) ? std::optional(nearest) : std::nullopt};
}

template <class S, int N>
LineInConvex line_in_capsule(const Ray<S, N>& ray, const Capsule<S, N>& capsule) {
  return line_in_capsule<N>(rational(ray.origin), rational(ray.direction), stretch(capsule), Rational(capsule.radius));
}
/// The line through a segment's exact ends, t = 0 and 1 at them.
template <class S, int N>
LineInConvex line_in_capsule(const Segment<S, N>& segment, const Capsule<S, N>& capsule) {
  return line_in_capsule<N>(rational(segment.p), rational(segment.q) - rational(segment.p), stretch(capsule),
                            Rational(capsule.radius));
}

}  // namespace isect::oracle
