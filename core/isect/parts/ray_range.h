#pragma once
// Where a t = num / den lies among the ends of a ray's range, without a division: for den > 0,
//
//   num / den < e   iff   num - e den < 0.
//
// For the core's own use.

#include <algorithm>
#include <cmath>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/shapes.h>

namespace isect::ray_range {

/// The sign of num / den - e. The text returns a Ratio<W> whose den has the sign `den`, 1 or -1; e may be infinite.
template <class Text, class Trace = NoTrace>
int compare(const Text& t, int den, double e, Trace&& trace = {}) {
  if (std::isinf(e)) return e > 0 ? -1 : 1;
  const auto excess = [&]<class W>() -> W {
    const Ratio<W> r = t.template operator()<W>();
    return e == 0 ? r.num : r.num - W(e) * r.den;
  };
  return den * sign_of(excess, trace);
}

/// Whether the range holds num / den.
template <class Text, class Trace = NoTrace>
bool holds(const Interval<double>& range, const Text& t, int den, Trace&& trace = {}) {
  if (!(range.lo <= range.hi)) {  // empty, or NaN
    if constexpr (doubles_only<Trace>) trace.open = true;
    return false;
  }
  return compare(t, den, range.lo, trace) >= 0 && compare(t, den, range.hi, trace) <= 0;
}

/// Whether the range holds num / den, where its value is known, as value_of finds it.
template <class S, class Text, class Trace = NoTrace>
bool holds_value(const Interval<double>& range, const Text& t, int den, S value, Trace&& trace = {}) {
  const double x = value, room = std::min(x - range.lo, range.hi - x);
  const bool clear = std::abs(room) > 4 * std::numeric_limits<S>::epsilon() * std::abs(x) && range.lo <= range.hi;
  if constexpr (doubles_only<Trace>) {
    trace.open |= !clear;
    return room > 0;
  } else {
    if (!heard<Trace> && clear) return room > 0;
    return holds(range, t, den, trace);
  }
}

/// Whether some real t lies in the range.
template <class S>
bool has_points(const Interval<S>& range) {
  return range.lo <= range.hi && range.lo < infinite<S>.hi && range.hi > infinite<S>.lo;
}

/// t, or the end of the range that it is beyond by rounding.
template <class S>
S clamped(const S& t, const Interval<S>& range) {
  return std::min(std::max(t, range.lo), range.hi);
}

}  // namespace isect::ray_range
