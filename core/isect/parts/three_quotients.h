#pragma once
// Three quotients with one denominator, found together: where a ray meets a triangle, by t, u and v.

#include <array>
#include <optional>
#include <type_traits>

#include <isect/numbers/quotient.h>

namespace isect {

/// x / den, y / den and z / den, not divided yet; den is not zero.
template <class W>
struct ThreeRatios {
  W x, y, z, den;

  friend std::array<const W*, 4> terms(const ThreeRatios& r) { return {&r.x, &r.y, &r.z, &r.den}; }
};

/// The three quotients, each as value_of finds it; `zero` tells which of them are known to be 0.
template <class S, class Text, class Trace = NoTrace>
ISECT_INLINE std::array<S, 3> values_of(const Text& text, const std::array<bool, 3>& zero, Trace&& trace = {}) {
  if constexpr (doubles_only<Trace> && std::is_same_v<S, double>) {
    using W = typename std::remove_cvref_t<Trace>::Fine;
    const ThreeRatios<Bounded<double>> quick = text.template operator()<Bounded<double>>();
    const ThreeRatios<W> fine = text.template operator()<W>();
    const double inverse = 1 / fine.den.hi;
    bool safe = detail::ordinary(quick.den, fine.den);
    const auto value = [&](const Bounded<double>& rough, const W& num, bool is_zero) __attribute__((always_inline))
                           ->double {
      const double q = detail::quotient(num, fine.den, inverse);
      const bool good = detail::ordinary(rough, num) & (std::abs(q) < detail::most_quotient);
      safe &= good | is_zero;
      return is_zero ? 0 : q;
    };
    const double x = value(quick.x, fine.x, zero[0]), y = value(quick.y, fine.y, zero[1]);
    const double z = value(quick.z, fine.z, zero[2]);
    trace.open |= !safe;
    return {x, y, z};
  } else if constexpr (!doubles_only<Trace> && !detail::recorded_for<Text, Trace>) {
    detail::KnownQuotients<3> known;
    for (int i = 0; i < 3; ++i)
      if (zero[i]) known.values[i] = 0;
    known = detail::quotients_by_stages<S>(text, known);
    return {static_cast<S>(*known.values[0]), static_cast<S>(*known.values[1]), static_cast<S>(*known.values[2])};
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

}  // namespace isect
