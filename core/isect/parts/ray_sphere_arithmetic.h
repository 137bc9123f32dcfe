#pragma once
// What the text of a ray and a sphere asks of the arithmetic that it runs in. Its bounds are derived by hand, in the
// unit roundoff: one derivation serves doubles, double-doubles and the exact numbers.

#include <concepts>
#include <optional>

#include <isect/numbers/arithmetic.h>

namespace isect::ray_sphere::detail {

template <class W>
concept Arithmetic = std::same_as<W, double> || std::same_as<W, DoubleDouble> || Unrounded<W>;

/// x y in W, where either may still be a double.
template <Arithmetic W, class X, class Y>
W product(const X& x, const Y& y) {
  if constexpr (!std::same_as<W, DoubleDouble>)
    return W(x) * W(y);
  else if constexpr (std::same_as<X, double> && std::same_as<Y, double>)
    return two_product(x, y);
  else if constexpr (std::same_as<X, double>)
    return y * x;
  else
    return x * y;
}

/// The nearest double, for reports.
inline double rounded(double x) { return x; }
inline double rounded(const DoubleDouble& x) { return x.hi; }
template <Unrounded W>
double rounded(const W& x) {
  return x.rounded();
}

/// The sign of x, whose error squared is known to be below `bound2`; nothing when x lies within it, or has outgrown
/// ShortExact. Exact is certain.
template <Arithmetic W>
std::optional<int> certain_sign(const W& x, double bound2) {
  if constexpr (Unrounded<W>) {
    return x.sign();
  } else {
    const double head = leading(x);
    if (head * head > bound2) return head > 0 ? 1 : -1;  // false for NaN
    return {};
  }
}

/// Whether W may work with squared lengths of this size: products of four of them, and bounds of a relative
/// 2^-200 on those, neither overflow nor lose bits. Always where nothing is rounded; never for NaN.
template <Arithmetic W>
bool in_range(double size) {
  return Unrounded<W> || (0x1p-100 <= size && size <= 0x1p100);
}

}  // namespace isect::ray_sphere::detail
