#pragma once
// Which t of a line a half-space or a box keeps, in rationals: computed from the heights at two places by a division.

#include <algorithm>
#include <optional>

#include "bench/rational.h"

namespace isect::oracle {

/// The range of t that is kept; an end that is nothing is infinite.
struct Kept {
  std::optional<Rational> lo, hi;
};

/// The part of a range where a height that is `at_0` at t = 0 and `at_1` at t = 1 is not negative.
template <class S>
std::optional<Kept> kept_above(const Interval<S>& range, const Rational& at_0, const Rational& at_1) {
  if (!(range.lo <= range.hi)) return {};
  Kept result;
  if (!std::isinf(range.lo)) result.lo = Rational(range.lo);
  if (!std::isinf(range.hi)) result.hi = Rational(range.hi);
  if (at_0 == at_1) return at_0 >= 0 ? std::optional(result) : std::nullopt;
  const Rational t = at_0 / (at_0 - at_1);
  if (at_1 > at_0 && (!result.lo || *result.lo < t)) result.lo = t;
  if (at_1 < at_0 && (!result.hi || *result.hi > t)) result.hi = t;
  if (result.lo && result.hi && *result.lo > *result.hi) return {};
  return result;
}

template <class S, int N>
Rational height(const Plane<S, N>& plane, const Coordinates<N>& x) {
  return dot(rational<S, N>(plane.normal), x) + Rational(plane.d);
}

/// The part of a segment above a plane, which has a normal.
template <class S, int N>
std::optional<Kept> clipped(const Segment<S, N>& s, const Plane<S, N>& plane) {
  return kept_above(Interval<S>{S(0), S(1)}, height<S, N>(plane, rational<S, N>(s.p)),
                    height<S, N>(plane, rational<S, N>(s.q)));
}
/// The part of a segment in a box: what is left by each of its sides.
template <class S, int N>
std::optional<Kept> clipped(const Segment<S, N>& s, const Aabb<S, N>& box) {
  Kept result = {Rational(0), Rational(1)};
  for (int k = 0; k < N; ++k)
    for (const int side : {1, -1}) {
      const Rational bound = Rational(side > 0 ? box.lo[k] : box.hi[k]);
      const auto part =
          kept_above(Interval<S>{S(0), S(1)}, side * (Rational(s.p[k]) - bound), side * (Rational(s.q[k]) - bound));
      if (!part) return {};
      result = {std::max(*result.lo, *part->lo), std::min(*result.hi, *part->hi)};
    }
  return *result.lo <= *result.hi ? std::optional(result) : std::nullopt;
}

}  // namespace isect::oracle
