#pragma once
// A line against the slabs of a box, of whatever kind.
//
// On the line x = o + t d each slab says lo <= rate t <= hi. For a rate that is not 0 it is entered at one of the
// quotients lo / rate, hi / rate and left at the other; for rate 0 the line runs beside it, within iff lo <= 0 <= hi.
// The line is in the box from the last entry to the first exit. Quotients are compared by cross-multiplication: all
// verdicts are signs of polynomials. Source: Kay, Kajiya, Ray tracing complex scenes, SIGGRAPH (1986).

#include <array>
#include <optional>

#include "core/ray_range.h"

namespace isect::slabs {

/// The line runs beside a slab, outside.
struct Outside {
  int slab;
};
/// The slab entered last, and the slab left first.
struct Stretch {
  int entered, left;
};

/// The slabs, whose coefficients in the arithmetic of the filter are found once.
template <int N, class Slabs>
class Kept {
 public:
  explicit Kept(const Slabs& slabs) : slabs_(slabs) {
    for (int i = 0; i < N; ++i) {
      rate_[i] = slabs.template rate<Quick>(i);
      lo_[i] = slabs.template lo<Quick>(i), hi_[i] = slabs.template hi<Quick>(i);
    }
  }

  template <Filtered W>
  W rate(int i) const {
    if constexpr (std::is_same_v<W, Quick>)
      return rate_[i];
    else
      return slabs_.template rate<W>(i);
  }
  template <Filtered W>
  W lo(int i) const {
    if constexpr (std::is_same_v<W, Quick>)
      return lo_[i];
    else
      return slabs_.template lo<W>(i);
  }
  template <Filtered W>
  W hi(int i) const {
    if constexpr (std::is_same_v<W, Quick>)
      return hi_[i];
    else
      return slabs_.template hi<W>(i);
  }

 private:
  using Quick = Bounded<double>;
  const Slabs& slabs_;
  std::array<Quick, N> rate_, lo_, hi_;
};

/// Two quotients of polynomials: the sign of a - b, when the dens have these signs.
template <class A, class B, class Trace>
int compare(const A& a, int den_a, const B& b, int den_b, Trace&& trace) {
  const auto cross = [&]<class W>() -> W {
    const Ratio<W> x = a.template operator()<W>(), y = b.template operator()<W>();
    return x.num * y.den - y.num * x.den;
  };
  return den_a * den_b * sign_of(cross, trace);
}

/// The t of the range in all slabs. `of_box` has N of them, as templates rate<W>(i), lo<W>(i), hi<W>(i), lo <= hi.
/// Verdict exact; the ends within 2 ulp of S, in the range, in order. The whole range for a line beside all slabs.
template <class S, int N, class Slabs, class Trace>
std::optional<Interval<S>> clip(const Interval<S>& range, const Slabs& of_box, Trace&& trace) {
  if (!ray_range::has_points(range)) return {};
  const Kept<N, Slabs> slabs(of_box);

  std::array<int, N> rates;
  for (int i = 0; i < N; ++i) {
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
  int last = -1, first = -1;  // the slab entered last, the slab left first
  for (int i = 0; i < N; ++i) {
    if (rates[i] == 0) continue;
    const auto order = [&](int j, bool entry) -> int {
      return compare(crossing(i, entry), rates[i], crossing(j, entry), rates[j], trace);
    };
    if (last < 0 || order(last, true) > 0) last = i;
    if (first < 0 || order(first, false) < 0) first = i;
  }
  if (last < 0) return range;
  trace(Stretch{last, first});

  const auto entry = crossing(last, true), exit = crossing(first, false);
  if (last != first && compare(entry, rates[last], exit, rates[first], trace) > 0) return {};
  const Interval<double> wide = cast<double>(range);
  if (ray_range::compare(entry, rates[last], wide.hi, trace) > 0) return {};
  if (ray_range::compare(exit, rates[first], wide.lo, trace) < 0) return {};

  // an end of the range is taken as it is; two ends that are equal may round apart, but not out of order
  const bool from_inside = ray_range::compare(entry, rates[last], wide.lo, trace) <= 0;
  const bool to_inside = ray_range::compare(exit, rates[first], wide.hi, trace) >= 0;
  const S in = from_inside ? range.lo : ray_range::clamped(value_of<S>(entry, trace), range);
  const S out = to_inside ? range.hi : ray_range::clamped(value_of<S>(exit, trace), range);
  return Interval<S>{in, std::max(in, out)};
}

}  // namespace isect::slabs
