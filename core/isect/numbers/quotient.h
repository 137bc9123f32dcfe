#pragma once
// The other question that an algorithm asks of arithmetic: what is this quotient of two polynomials? For the first,
// what sign one has, see isect/numbers/predicate.h.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <isect/numbers/predicate.h>

namespace isect {

/// A quotient of two polynomials, not divided yet; den is not zero.
template <class W>
struct Ratio {
  W num, den;
};
/// Three quotients with one denominator.
template <class W>
struct ThreeRatios {
  W x, y, z, den;
};

/// The steps of a quotient's text as a text of their own.
class RecordedRatio {
 public:
  template <class Text>
  explicit RecordedRatio(const Text& text)
      : quick_(text.template operator()<Bounded<double>>()), steps_([&] {
          const Ratio<Recorded> r = text.template operator()<Recorded>();
          return std::array{r.num, r.den};
        }) {}
  template <class W>
  Ratio<W> operator()() const {
    if constexpr (std::is_same_v<W, Bounded<double>>) {
      return quick_;
    } else {
      const std::vector<W> found = steps_.run<W>();
      return {found[0], found[1]};
    }
  }

 private:
  Ratio<Bounded<double>> quick_;
  Recording steps_;
};

namespace detail {
/// The quotient by what doubles found, for the float of an S.
template <class Text>
std::optional<double> rough_quotient(const Text& text, double tolerance) {
  const auto [num, den] = text.template operator()<Bounded<double>>();
  if (!num.within(tolerance) || !den.within(tolerance)) return {};
  return num.value() / den.value();
}

/// Num and den in W, Compensated or Fused. Safe: neither loses more than 14 bits by cancellation, so that |lo| <= 2^-32
/// |hi| in both, and both are within a relative 2^-76; or num is 0. By the sizes and roundings that doubles found.
struct FineRatio {
  double num, num_rest, den, den_rest;
  bool safe;
};
/// Whether x loses no more than 14 bits by cancellation.
template <class W>
ISECT_INLINE bool ordinary(const Bounded<double>& quick, const W& fine) {
  const double size = std::abs(fine.hi);
  return (size >= 0x1p-14 * quick.size()) & (size >= 0x1p-800) & (quick.roundings() <= 64);
}
template <class W, class Text>
ISECT_INLINE FineRatio fine_ratio(const Text& text) {
  const Ratio<Bounded<double>> quick = text.template operator()<Bounded<double>>();
  const Ratio<W> r = text.template operator()<W>();
  const bool safe = (ordinary(quick.num, r.num) | (quick.num.size() == 0)) & ordinary(quick.den, r.den);
  return {r.num.hi, r.num.lo, r.den.hi, r.den.lo, safe};
}
template <class W, class Text>
ISECT_INLINE std::optional<double> fine_quotient(const Text& text) {
  const FineRatio r = fine_ratio<W>(text);
  const double q = quotient(W(r.num, r.num_rest), W(r.den, r.den_rest));
  const bool good = r.safe & (std::abs(q) <= std::numeric_limits<double>::max());
  return good ? std::optional(q) : std::nullopt;
}

/// The quotient in V by its own bounds, if it is finite there and num and den are within a relative `tolerance`.
template <class V, class Text>
[[gnu::noinline]] std::optional<double> bounded_quotient(const Text& text, double tolerance) {
  const Ratio<Bounded<V>> r = text.template operator()<Bounded<V>>();
  if (!r.num.within(tolerance) || !r.den.within(tolerance)) return {};
  const double q = quotient(r.num.value(), r.den.value());
  return std::isfinite(q) ? std::optional(q) : std::nullopt;  // beyond 2^996 DoubleDouble's steps overflow
}

template <class W>
std::array<const W*, 1> numerators(const Ratio<W>& r) {
  return {&r.num};
}
template <class W>
std::array<const W*, 3> numerators(const ThreeRatios<W>& r) {
  return {&r.x, &r.y, &r.z};
}

/// Those of the three quotients that value_of finds without settling; the others stay as they are.
template <class S, class Text>
[[gnu::noinline]] void find_ordinary(const Text& text, double tolerance, std::array<std::optional<double>, 3>& q) {
  const ThreeRatios<Bounded<double>> quick = text.template operator()<Bounded<double>>();
  const auto rough = numerators(quick);
  const auto each = [&q](const auto& find) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!q[i]) q[i] = find(i);
  };
  if constexpr (std::is_same_v<S, float>)
    each([&](std::size_t i) {
      const bool good = rough[i]->within(tolerance) && quick.den.within(tolerance);
      return good ? std::optional(rough[i]->value() / quick.den.value()) : std::nullopt;
    });
  else
    compensated([&]<class W>() {
      const ThreeRatios<W> fine = text.template operator()<W>();
      const auto num = numerators(fine);
      each([&](std::size_t i) {
        const double value = quotient(*num[i], fine.den);
        const bool good = (ordinary(*rough[i], *num[i]) | (rough[i]->size() == 0)) & ordinary(quick.den, fine.den) &
                          (std::abs(value) <= std::numeric_limits<double>::max());
        return good ? std::optional(value) : std::nullopt;
      });
      return true;
    });
}

/// K quotients with one denominator, those that are not known yet: by what doubles found, where num is 0 or both are
/// exact there; then finer.
template <std::size_t K, class Text>
[[gnu::noinline]] std::array<double, K> settled_quotients(const Text& text, double tolerance,
                                                          std::array<std::optional<double>, K> q = {}) {
  const auto settled = [&q](const auto& ratios, const auto& found) {
    const auto num = numerators(ratios);
    bool all = true;
    for (std::size_t i = 0; i < K; ++i) {
      if (!q[i]) q[i] = found(*num[i], i);
      all &= q[i].has_value();
    }
    return all;
  };
  const auto values = [&q] {
    std::array<double, K> all;
    for (std::size_t i = 0; i < K; ++i) all[i] = *q[i];
    return all;
  };

  if (std::ranges::all_of(q, [](const auto& x) { return x.has_value(); })) return values();
  const auto quick = text.template operator()<Bounded<double>>();
  const auto grid = text.template operator()<Grid>();
  const auto sizes = numerators(quick);
  const auto steps = numerators(grid);
  const bool den_is_exact = quick.den.error() < grid.den.step();
  if (settled(quick, [&](const Bounded<double>& num, std::size_t i) -> std::optional<double> {
        const double step = steps[i]->step();
        if (std::abs(num.value()) + num.error() < step) return 0;
        if (num.error() < step && den_is_exact) return num.value() / quick.den.value();
        return {};
      }))
    return values();

  const auto in_range = [](const Bounded<double>& x) { return 0x1p-800 < x.size() && x.size() < 0x1p900; };
  const auto by = [&]<class W>() -> bool {
    const auto fine = text.template operator()<W>();
    const Bounded<W> den(fine.den, quick.den.size(), quick.den.roundings());
    return settled(fine, [&](const W& x, std::size_t i) -> std::optional<double> {
      if (!in_range(*sizes[i])) return {};
      const Bounded<W> num(x, sizes[i]->size(), sizes[i]->roundings());
      if (std::abs(leading(x)) + num.error() < steps[i]->step()) return 0;
      if (!num.within(tolerance) || !den.within(tolerance)) return {};
      const double value = quotient(two_sum(x.hi, x.lo), two_sum(fine.den.hi, fine.den.lo));
      return std::isfinite(value) ? std::optional(value) : std::nullopt;
    });
  };
  if (in_range(quick.den) && compensated(by)) return values();

  const auto medium = text.template operator()<MediumExact>();
  if (settled(medium, [&](const MediumExact& num, std::size_t) -> std::optional<double> {
        const double value = quotient(num, medium.den);
        return std::isnan(value) ? std::nullopt : std::optional(value);
      }))
    return values();
  const auto exact = text.template operator()<Exact>();
  settled(exact, [&](const Exact& num, std::size_t) { return std::optional(near_quotient(num, exact.den)); });
  return values();
}
}  // namespace detail

/// The quotient in S, within 2 ulp of S of its true value; infinite beyond the largest S. The text returns a
/// Ratio<W> whose den is not zero.
///
/// Bound. Each of num and den is within a relative eps / 3 of the truth, eps that of S, or Exact takes over; so the
/// quotient is within 2/3 eps (1 + eps), at most 1.34 ulp, rounded once to S: within 1.85 ulp in all. Subnormal results
/// lose what S loses there: half a unit of the least subnormal more. In double most are within 0.51 ulp.
template <class S, class Text, class Trace = NoTrace>
S value_of(const Text& text, Trace&& trace = {}) {
  if constexpr (detail::recorded_for<Text, Trace> && !std::is_same_v<Text, RecordedRatio>)
    return value_of<S>(RecordedRatio(text), trace);
  constexpr double tolerance = std::numeric_limits<S>::epsilon() / 3;
  std::optional<double> q;
  if constexpr (std::is_same_v<S, float>)
    q = detail::rough_quotient(text, tolerance);
  else if constexpr (first_try<Trace>)
    q = detail::fine_quotient<typename std::remove_cvref_t<Trace>::Fine>(text);
  else
    q = compensated([&]<class W>() { return detail::fine_quotient<W>(text); });
  if constexpr (first_try<Trace>) {
    trace.open |= !q;
    return static_cast<S>(q.value_or(0));
  } else {
    if (q) return static_cast<S>(*q);
    trace(Fallback{});
    return static_cast<S>(detail::settled_quotients<1>(text, tolerance)[0]);
  }
}

/// The three quotients, each as value_of finds it; `zero` tells which of them are known to be 0.
template <class S, class Text, class Trace = NoTrace>
ISECT_INLINE std::array<S, 3> values_of(const Text& text, const std::array<bool, 3>& zero, Trace&& trace = {}) {
  if constexpr (first_try<Trace> && std::is_same_v<S, double>) {
    using W = typename std::remove_cvref_t<Trace>::Fine;
    const ThreeRatios<Bounded<double>> quick = text.template operator()<Bounded<double>>();
    const ThreeRatios<W> fine = text.template operator()<W>();
    const double inverse = 1 / fine.den.hi;
    bool safe = detail::ordinary(quick.den, fine.den);
    const auto value = [&](const Bounded<double>& rough, const W& num, bool is_zero) __attribute__((always_inline))
                           ->double {
      const double q = detail::quotient(num, fine.den, inverse);
      const bool good = detail::ordinary(rough, num) & (std::abs(q) <= std::numeric_limits<double>::max());
      safe &= good | is_zero;
      return is_zero ? 0 : q;
    };
    const double x = value(quick.x, fine.x, zero[0]), y = value(quick.y, fine.y, zero[1]);
    const double z = value(quick.z, fine.z, zero[2]);
    trace.open |= !safe;
    return {x, y, z};
  } else if constexpr (!first_try<Trace> && !detail::recorded_for<Text, Trace>) {
    constexpr double tolerance = std::numeric_limits<S>::epsilon() / 3;
    std::array<std::optional<double>, 3> known;
    for (int i = 0; i < 3; ++i)
      if (zero[i]) known[i] = 0;
    detail::find_ordinary<S>(text, tolerance, known);
    const std::array<double, 3> q = detail::settled_quotients<3>(text, tolerance, known);
    return {static_cast<S>(q[0]), static_cast<S>(q[1]), static_cast<S>(q[2])};
  } else {
    const auto value = [&](auto part, bool is_zero) -> S {
      const auto ratio = [&]<class W>() -> Ratio<W> {
        const ThreeRatios<W> all = text.template operator()<W>();
        return {all.*part(all), all.den};
      };
      return is_zero ? S(0) : value_of<S>(ratio, trace);
    };
    const S x = value([]<class W>(const ThreeRatios<W>&) { return &ThreeRatios<W>::x; }, zero[0]);
    const S y = value([]<class W>(const ThreeRatios<W>&) { return &ThreeRatios<W>::y; }, zero[1]);
    return {x, y, value([]<class W>(const ThreeRatios<W>&) { return &ThreeRatios<W>::z; }, zero[2])};
  }
}

/// The signs of num and den.
struct Signs {
  int num, den;
};
template <class S, class Text, class Trace = NoTrace>
ISECT_INLINE Signs signs_of(const Text& text, Trace&& trace = {}) {
  if constexpr (first_try<Trace> && std::is_same_v<S, double>) {  // those of what value_of finds, too
    const detail::FineRatio r = detail::fine_ratio<typename std::remove_cvref_t<Trace>::Fine>(text);
    trace.open |= !r.safe;
    return {(r.num > 0) - (r.num < 0), (r.den > 0) - (r.den < 0)};
  } else {
    const int den = sign_of([&]<class W>() -> W { return text.template operator()<W>().den; }, trace);
    return {sign_of([&]<class W>() -> W { return text.template operator()<W>().num; }, trace), den};
  }
}

/// n.x / n.y, each of which is a vector of doubles or of W.
template <Filtered W, int N, class X, class Y, class Z>
ISECT_INLINE Ratio<W> ratio_of_dots(const X& n, const Y& x, const Z& y) {
  if constexpr (is_compensated<W>) {
    const auto both = two_dots<std::is_same_v<W, Fused>, N>(n, x, y);
    return {W(both.x.hi, both.x.lo), W(both.y.hi, both.y.lo)};
  } else {
    return {dot(in<W, N>(n), in<W, N>(x)), dot(in<W, N>(n), in<W, N>(y))};
  }
}

}  // namespace isect
