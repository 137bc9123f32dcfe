#pragma once
// A line against the slabs of a box, of whatever kind.
//
// On the line x = o + t d each slab says lo <= rate t <= hi. For a rate that is not 0 it is entered at one of the
// quotients lo / rate, hi / rate and left at the other; for rate 0 the line runs beside it, within iff lo <= 0 <= hi.
// The line is in the box from the last entry to the first exit. Quotients are compared by cross-multiplication: all
// verdicts are signs of polynomials. Source: Kay, Kajiya, Ray tracing complex scenes, SIGGRAPH (1986).

#include <array>
#include <optional>

#include <isect/parts/ray_range.h>

namespace isect::slabs {

/// The line runs beside a slab, outside.
struct Outside {
  int slab;
};
/// The slab entered last, and the slab left first.
struct Stretch {
  int entered, left;
};

namespace detail {

/// Two quotients of polynomials: the sign of a - b, when the dens have these signs.
template <class A, class B, class Trace>
int compare(const A& a, int den_a, const B& b, int den_b, Trace&& trace) {
  const auto cross = [&]<class W>() -> W {
    const Ratio<W> x = a.template operator()<W>(), y = b.template operator()<W>();
    return x.num * y.den - y.num * x.den;
  };
  return den_a * den_b * sign_of(cross, trace);
}

/// What doubles find of a line and slabs: the t at which it enters and leaves each.
template <int N>
struct Estimate {
  std::array<double, N> entries, exits;
  std::array<bool, N> backwards;
  std::array<bool, N> sound;  ///< the line does not run beside the slab
  double error;               ///< of those that are sound
  int meets;                  ///< 1: some t of the range is in all slabs; -1: none is; 0: rounding may decide, or NaN
};

/// Uses the slabs in doubles only; their lo may be the larger.
///
/// Bound. Let n and d be a num and the rate as computed, off by at most e and f < |d| / 4. The true quotient is off n /
/// d by at most (e + |n / d| f) / (3/4 |d|); dividing by a reciprocal adds 2.1 u |n / d|, and f is more than 0.9 u |d|.
/// So 4 (e + |n / d| f) / |d| has room for both and for its own roundings, where reciprocals are normal; 2^-1000 is for
/// underflow. The largest of such numbers is off by no more than the sum of all.
template <class S, int N, class Slabs>
Estimate<N> estimate(const Interval<S>& range, const Slabs& slabs) {
  Estimate<N> seen;
  double in = range.lo, out = range.hi, error = 0x1p-1000;
  bool certain = range.lo <= range.hi;
  for (int i = 0; i < N; ++i) {
    const Bounded<double> rate = slabs.template rate<Bounded<double>>(i), lo = slabs.template lo<Bounded<double>>(i),
                          hi = slabs.template hi<Bounded<double>>(i);
    const double size = std::abs(rate.value()), inverse = 1 / rate.value();
    const bool sound =
        4 * rate.error() < size && 0x1p-1000 < size && size < 0x1p1000;  // else beside the slab, or nearly

    const double t1 = lo.value() * inverse, t2 = hi.value() * inverse;
    const double both = std::max(lo.error(), hi.error()) + (std::abs(t1) + std::abs(t2)) * rate.error();
    const double off = 4 * both * std::abs(inverse);
    error += sound ? off : 0;
    certain &= sound;
    seen.sound[i] = sound;
    seen.backwards[i] = inverse < 0;
    seen.entries[i] = std::min(t1, t2), seen.exits[i] = std::max(t1, t2);
    in = std::max(in, seen.entries[i]), out = std::min(out, seen.exits[i]);
  }
  certain &= error <= std::numeric_limits<double>::max();
  seen.error = error;
  seen.meets = certain ? (out - in > error) - (in - out > error) : 0;
  return seen;
}

/// Returns what `clip` does, once the estimate shows that some t is in all slabs. Open when two slabs may be the last
/// entered, or the first left.
template <class S, int N, class Slabs, class Fine>
Interval<S> stretch(const Interval<S>& range, const Estimate<N>& seen, const Slabs& slabs, DoublesOnly<Fine>& first) {
  int last = 0, left = 0;  // the slab entered last, the slab left first
  for (int i = 1; i < N; ++i) {
    last = seen.entries[i] > seen.entries[last] ? i : last;
    left = seen.exits[i] < seen.exits[left] ? i : left;
  }
  const double in = seen.entries[last], out = seen.exits[left];
  int contenders = 0;
  for (int i = 0; i < N; ++i)
    contenders += (in - seen.entries[i] <= 2 * seen.error) + (seen.exits[i] - out <= 2 * seen.error);
  first.open |= contenders > 2;
  if (first.open) [[unlikely]]
    return range;

  const auto crossing = [&](int i, bool at_lo) {
    return [&slabs, i, at_lo]<class W>() -> Ratio<W> {
      return {at_lo ? slabs.template lo<W>(i) : slabs.template hi<W>(i), slabs.template rate<W>(i)};
    };
  };
  S lo = range.lo, hi = range.hi;
  if (in + seen.error >= lo) lo = std::max(lo, value_of<S>(crossing(last, !seen.backwards[last]), first));
  if (out - seen.error <= hi) hi = std::min(hi, value_of<S>(crossing(left, seen.backwards[left]), first));
  lo = std::min(lo, range.hi);
  return {lo, std::max(lo, hi)};
}

/// The t of the range in all slabs. `slabs` has N of them, as templates rate<W>(i), lo<W>(i), hi<W>(i), lo <= hi.
/// Verdict exact; the ends within 2 ulp of S, in the range, in order. The whole range for a line beside all slabs.
/// What is clear from `seen` is not asked again.
template <class S, int N, class Slabs, class Trace>
std::optional<Interval<S>> clip(const Interval<S>& range, const Slabs& slabs, Trace&& trace,
                                const Estimate<N>* seen = nullptr) {
  if (!ray_range::has_points(range)) return {};

  std::array<int, N> rates;
  for (int i = 0; i < N; ++i) {
    if (seen && seen->sound[i]) {
      rates[i] = seen->backwards[i] ? -1 : 1;
      continue;
    }
    rates[i] = sign_of([&]<class W>() -> W { return slabs.template rate<W>(i); }, trace);
    if (rates[i] != 0) continue;
    const bool outside = sign_of([&]<class W>() -> W { return slabs.template lo<W>(i); }, trace) > 0 ||
                         sign_of([&]<class W>() -> W { return slabs.template hi<W>(i); }, trace) < 0;
    if (!outside) continue;
    trace(Outside{i});
    return {};
  }

  const auto crossing = [&](int i, bool entry) {
    const bool at_lo = entry == (rates[i] > 0);
    return [&slabs, i, at_lo]<class W>() -> Ratio<W> {
      return {at_lo ? slabs.template lo<W>(i) : slabs.template hi<W>(i), slabs.template rate<W>(i)};
    };
  };
  const auto about = [&](int i, bool entry) -> double {
    return seen && seen->sound[i] ? (entry ? seen->entries : seen->exits)[i] : std::numeric_limits<double>::quiet_NaN();
  };
  const auto clear = [&](double x, double y) -> int {  // the sign of x - y, or 0 where it may be another
    return seen ? (x - y > 2 * seen->error) - (y - x > 2 * seen->error) : 0;
  };
  const auto order = [&](int i, bool entry, int j, bool other_entry) -> int {
    const int sign = clear(about(i, entry), about(j, other_entry));
    return sign ? sign : compare(crossing(i, entry), rates[i], crossing(j, other_entry), rates[j], trace);
  };
  const auto order_of_end = [&](int i, bool entry, double end) -> int {
    const int sign = clear(about(i, entry), end);
    return sign ? sign : ray_range::compare(crossing(i, entry), rates[i], end, trace);
  };

  int last = -1, first = -1;  // the slab entered last, the slab left first
  for (int i = 0; i < N; ++i) {
    if (rates[i] == 0) continue;
    if (last < 0 || order(i, true, last, true) > 0) last = i;
    if (first < 0 || order(i, false, first, false) < 0) first = i;
  }
  if (last < 0) return range;
  trace(Stretch{last, first});

  if (last != first && order(last, true, first, false) > 0) return {};
  const Interval<double> wide = cast<double>(range);
  if (order_of_end(last, true, wide.hi) > 0) return {};
  if (order_of_end(first, false, wide.lo) < 0) return {};

  // an end of the range is taken as it is; two ends that are equal may round apart, but not out of order
  const bool from_inside = order_of_end(last, true, wide.lo) <= 0;
  const bool to_inside = order_of_end(first, false, wide.hi) >= 0;
  const S in = from_inside ? range.lo : ray_range::clamped(value_of<S>(crossing(last, true), trace), range);
  const S out = to_inside ? range.hi : ray_range::clamped(value_of<S>(crossing(first, false), trace), range);
  return Interval<S>{in, std::max(in, out)};
}

}  // namespace detail

}  // namespace isect::slabs
