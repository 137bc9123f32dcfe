#pragma once
// Interval against interval as it is written in practice: for lessons and comparison. `intersects` in
// isect/interval_interval.h is right for all input; where no interval is empty, it is the note's `ends` there.

#include <algorithm>
#include <variant>

#include <isect/interval_interval.h>

namespace isect::interval_interval {

/// The middles' distance against the sum of the half-lengths, as rounded.
template <class S>
struct Middles {
  S distance, reach;
};
template <class S>
using MethodEvent = std::variant<Common<S>, Middles<S>>;

/// Whether the larger lower end is at most the smaller upper end. One comparison decides, without a branch; if one
/// interval is inverted, the common part is inverted, too. NaN may slip through std::max and std::min, and infinite
/// ends are taken for numbers.
template <class S, class Trace = NoTrace>
bool min_max(const Interval<S>& a, const Interval<S>& b, Trace&& trace = {}) {
  const Interval<S> common = {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  trace(Common<S>{common});
  return common.lo <= common.hi;
}

/// Compares middles and half-lengths, as engines keep them. Naive: the middle rounds, so that a quarter of the
/// intervals that touch come apart.
template <class S, class Trace = NoTrace>
bool by_middles(const Interval<S>& a, const Interval<S>& b, Trace&& trace = {}) {
  const S apart = (a.lo + a.hi) / S(2) - (b.lo + b.hi) / S(2);
  const S distance = apart < S(0) ? -apart : apart;
  const S reach = (a.hi - a.lo) / S(2) + (b.hi - b.lo) / S(2);
  trace(Middles<S>{distance, reach});
  return distance <= reach;
}

}  // namespace isect::interval_interval
