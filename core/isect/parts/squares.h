#pragma once
// The order of two squared lengths, at the price of computing them.
//
// A squared distance is a sum of at most four squares of differences of doubles; the square of a radius, or of the
// sum or difference of two, is one such term. No term is negative, so nothing cancels, and the computed x is close to
// the true X relatively: a difference carries one rounding, its square three, four of them summed six. With g(k) = k
// u / (1 - k u) (Higham, Accuracy and Stability, 2nd ed., ch. 3) and 2^-1075 for each product that underflows,
//
//   |x - X| <= g(6) X + 2^-1073,   so   |(x - y) - (X - Y)| <= g(6) (X + Y) + 2^-1072 < 6.1 u (x + y) + 2^-1071.
//
// In float the same holds with 2^-150 for 2^-1075, so that floats need no doubles where they are not in doubt. What
// overflows becomes infinite and stays so, and then x + y is infinite too.

#include <cmath>
#include <concepts>
#include <limits>

#include <isect/numbers/predicate.h>

namespace isect {

/// Whether squared lengths X and Y, computed in S as above, are ordered as x and y are: x < y or x > y can be trusted.
/// The factor 8 and the last term, 2^-1000 or 2^-104, have room for the roundings of the comparison itself. Never true
/// where a number in them is NaN or infinite.
template <std::floating_point S>
bool ordered(S x, S y) {
  constexpr S relative = static_cast<S>(8 * unit<S>), absolute = S(0x1p22) * std::numeric_limits<S>::min();
  return std::abs(x - y) > relative * (x + y) + absolute;
}

/// The sign of X - Y: that of x - y, or where that can't be trusted what `settle()` finds.
template <std::floating_point S, class Settle>
int order_of_squares(S x, S y, const Settle& settle) {
  if (ordered(x, y)) [[likely]]
    return x < y ? -1 : 1;
  return settle();
}

/// The sign of X - Y as the text finds it, where that of x - y can't be trusted. Six roundings lead to x - y, which
/// serves the text for what doubles find of it. Finite arguments.
template <std::floating_point S, class Text, class Trace>
int settled_squares(const Text& text, S x, S y, Trace&& trace) {
  if constexpr (std::is_same_v<S, double> && !heard<Trace>)
    return detail::sign_after_doubles(text, Bounded<double>(x - y, x + y + 0x1p-950, 6));
  else
    return sign_of(text, trace);
}

}  // namespace isect
