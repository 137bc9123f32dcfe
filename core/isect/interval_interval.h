#pragma once
// Interval against interval.
//
// Two closed intervals share the points from the larger lower end to the smaller upper end,
//
//   common = [max(a.lo, b.lo), min(a.hi, b.hi)],
//
// which is inverted when they are disjoint, one point when they touch, and a when b contains a. Only inputs are
// compared: exact for free. Source: the note, N12.

#include <algorithm>
#include <limits>
#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace interval_interval {

/// relate: the shared points; none when lo > hi.
template <class S>
struct Common {
  Interval<S> common;
};
/// ends: whether one interval begins after the other has ended.
template <class S>
struct Beyond {
  S lo, hi;
  bool holds;  ///< lo > hi
};
template <class S>
using Event = std::variant<Common<S>, Beyond<S>>;

namespace detail {

/// Whether no number lies in the interval: it is inverted, NaN, or a single end at infinity, which is no number.
template <class S>
bool holds_nothing(const Interval<S>& x) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  return empty(x) || x.lo == infinity || x.hi == -infinity;
}

}  // namespace detail

/// The note's test, disjoint iff a.lo > b.hi or b.lo > a.hi. Exact for intervals that are not empty; inverted ones and
/// NaN, for which no comparison holds, count as overlapping.
template <class S, class Trace = NoTrace>
bool ends(const Interval<S>& a, const Interval<S>& b, Trace&& trace = {}) {
  const bool a_beyond_b = a.lo > b.hi;
  trace(Beyond<S>{a.lo, b.hi, a_beyond_b});
  if (a_beyond_b) return false;

  const bool b_beyond_a = b.lo > a.hi;
  trace(Beyond<S>{b.lo, a.hi, b_beyond_a});
  return !b_beyond_a;
}

}  // namespace interval_interval

/// Whether the intervals have a common number. Exact. An end may be infinite: a half-line, the whole line. An empty
/// interval, or NaN: no.
template <class S, class Trace = NoTrace>
bool intersects(const Interval<S>& a, const Interval<S>& b, Trace&& trace = {}) {
  if (interval_interval::detail::holds_nothing(a) || interval_interval::detail::holds_nothing(b)) return false;
  return interval_interval::ends(a, b, trace);
}

/// How the intervals lie. Exact. A point lies inside an interval whose end it is; half-lines and lines are equal when
/// their ends are. An empty interval, or NaN: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Interval<S>& a, const Interval<S>& b, Trace&& trace = {}) {
  if (interval_interval::detail::holds_nothing(a) || interval_interval::detail::holds_nothing(b))
    return Relation::disjoint;

  const Interval<S> common = {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  trace(interval_interval::Common<S>{common});

  if (common.lo > common.hi) return Relation::disjoint;
  if (a == b) return Relation::equal;
  if (common == a) return Relation::a_inside_b;
  if (common == b) return Relation::b_inside_a;
  return common.lo == common.hi ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
