#pragma once
// One text, several arithmetics: double, DoubleDouble, ShortExact, MediumExact and Exact run the same
// template. Each obeys
//
//   x + y -> x (1 + e1) + y (1 + e2),   x y -> x y (1 + e),   |e| <= u,   u = unit<W>,
//
// so that one derivation of an error bound, written in u, serves them all; with u = 0 every sign is certain.
// Derivations write g(k) = k u / (1 - k u) for k such factors (Higham, Accuracy and Stability, 2nd ed.,
// ch. 3).

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>

#include <isect/numbers/compensated.h>
#include <isect/numbers/double_double.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/short_exact.h>
#include <isect/numbers/triple_double.h>
#include <isect/shapes.h>

namespace isect {

/// An arithmetic without rounding: each sign that it knows is certain, and it needs no bound.
template <class W>
concept Unrounded = std::same_as<W, ShortExact> || std::same_as<W, MediumExact> || std::same_as<W, Exact>;

/// The unit roundoff u of an arithmetic: 2^-53, 2^-103, 0.
template <class W>
inline constexpr double unit = static_cast<double>(std::numeric_limits<W>::epsilon() / 2);
template <bool fused>
inline constexpr double unit<CompensatedBy<fused>> = unit<double>;  // of hi; compensated.h has the bound of hi + lo
template <>
inline constexpr double unit<DoubleDouble> = 8 * unit<double>* unit<double>;
template <Unrounded W>
inline constexpr double unit<W> = 0;

template <class W>
concept Arithmetic = std::same_as<W, double> || std::same_as<W, DoubleDouble> || Unrounded<W>;

/// x - y of two doubles in W; exact unless W is double.
template <Arithmetic W>
W difference(double x, double y) {
  if constexpr (std::same_as<W, DoubleDouble>)
    return two_sum(x, -y);
  else
    return W(x) - W(y);
}

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

/// The double that leads x, for sizes and bounds; 0 where nothing is rounded, as bounds are 0 there.
template <std::floating_point W>
double leading(W x) {
  return static_cast<double>(x);
}
inline double leading(const DoubleDouble& x) { return x.hi; }
template <bool fused>
double leading(const CompensatedBy<fused>& x) {
  return x.hi + x.lo;
}
template <bool fused>
double leading(const TripleDouble<fused>& x) {
  return in_two(x).hi;
}
template <Unrounded W>
double leading(const W&) {
  return 0;
}

/// x / y, rounded to double at last.
template <std::floating_point W>
double quotient(W x, W y) {
  return static_cast<double>(x / y);
}

/// The nearest double, for reports.
template <std::floating_point W>
double rounded(W x) {
  return static_cast<double>(x);
}
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

}  // namespace isect
