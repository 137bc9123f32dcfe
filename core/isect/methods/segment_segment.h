#pragma once
// Segment against segment by the parameters of the common point, as it is written in practice: for comparison.
// `intersect` in isect/segment_segment.h is right for all input.

#include <optional>
#include <variant>

#include <isect/segment_segment.h>

namespace isect::segment_segment {

// clang-format off
template <class S> struct Determinant { S value; };                       ///< (q - p) x (s - r)
template <class S> struct Parameters { S t, u; bool holds; };             ///< both in [0, 1]
// clang-format on
template <class S>
using ParametricEvent = std::variant<Determinant<S>, Parameters<S>>;

/// The common point, by solving p + t (q - p) = r + u (s - r); nothing for parallel segments, even where they
/// overlap. Naive: rounding may decide. Source: Antonio, Faster line segment intersection, Graphics Gems III (1992).
template <class S, class Trace = NoTrace>
std::optional<Point<S, 2>> parametric_naive(const Segment<S, 2>& a, const Segment<S, 2>& b, Trace&& trace = {}) {
  const Vector<S, 2> d = a.q - a.p, e = b.q - b.p, between = b.p - a.p;
  const S determinant = d[0] * e[1] - d[1] * e[0];
  trace(Determinant<S>{determinant});
  if (determinant == S(0)) return {};

  const S t = (between[0] * e[1] - between[1] * e[0]) / determinant;
  const S u = (between[0] * d[1] - between[1] * d[0]) / determinant;
  const bool holds = S(0) <= t && t <= S(1) && S(0) <= u && u <= S(1);
  trace(Parameters<S>{t, u, holds});
  if (!holds) return {};
  return Point<S, 2>(a.p + t * d);
}

}  // namespace isect::segment_segment
