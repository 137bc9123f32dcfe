#pragma once
// What all arithmetics of the core have in common: the unit roundoff, differences of doubles, the double that leads a
// number, quotients. Each arithmetic obeys
//
//   x + y -> x (1 + e1) + y (1 + e2),   x y -> x y (1 + e),   |e| <= u,   u = unit<W>,
//
// so that one derivation of an error bound, written in u, serves them all; with u = 0 every sign is certain.
// Derivations write g(k) = k u / (1 - k u) for k such factors (Higham, Accuracy and Stability, 2nd ed.,
// ch. 3).

#include <cmath>
#include <concepts>
#include <limits>
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

/// x - y of two doubles in W; exact unless W is double or counts its roundings.
template <class W>
W difference(double x, double y) {
  if constexpr (std::same_as<W, DoubleDouble>)
    return two_sum(x, -y);
  else
    return W(x) - W(y);
}
template <class W>
requires requires { W::difference(0., 0.); }
ISECT_INLINE W difference(double x, double y) { return W::difference(x, y); }

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
inline double leading(const TripleDouble& x) { return in_two(x).hi; }
template <Unrounded W>
double leading(const W&) {
  return 0;
}

/// x / y, rounded to double at last.
template <std::floating_point W>
double quotient(W x, W y) {
  return static_cast<double>(x / y);
}

}  // namespace isect
