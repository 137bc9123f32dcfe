#pragma once
// The two questions that an algorithm asks of arithmetic: what sign has this polynomial, and what is this quotient.
//
// The polynomial is a text over an arithmetic W, written once as a generic lambda:
//
//   sign_of([&]<class W>() -> W { return difference<W>(a[0], c[0]) * difference<W>(b[1], c[1]) - ...; })
//
// It runs in Bounded<double>, whose proved error bound settles nearly every sign, else in Bounded<DoubleDouble>, and at
// last in Exact, where every sign is certain. So the algorithms above read like the book's, branch on true signs alone, and are right
// for all finite input of any magnitude. Arguments must be finite.

#include <limits>
#include <type_traits>

#include "core/bounded.h"
#include "core/exact.h"
#include "core/trace.h"

namespace isect {

namespace detail {
/// Apart and not inlined: the machine code of the slow path stays out of the fast one's way.
template <class Text>
[[gnu::noinline, gnu::cold]] int settled_sign(const Text& text) {
  if (const std::optional<int> s = text.template operator()<Bounded<DoubleDouble>>().sign()) return *s;
  return text.template operator()<Exact>().sign();
}
}  // namespace detail

/// The true sign of the polynomial: 1, 0 or -1. Reports Fallback when doubles do not settle it.
template <class Text, class Trace = NoTrace>
int sign_of(const Text& text, Trace&& trace = {}) {
  if (const std::optional<int> s = text.template operator()<Bounded<double>>().sign()) return *s;
  trace(Fallback{});
  return detail::settled_sign(text);
}

/// A quotient of two polynomials, not divided yet; den is not zero.
template <class W>
struct Ratio {
  W num, den;
};

namespace detail {
/// The quotient in V, if it is finite there and num and den are within a relative `tolerance`.
template <class V, class Text>
std::optional<double> bounded_quotient(const Text& text, double tolerance) {
  const Ratio<Bounded<V>> r = text.template operator()<Bounded<V>>();
  if (!r.num.within(tolerance) || !r.den.within(tolerance)) return {};
  const double q = quotient(r.num.value(), r.den.value());
  return std::isfinite(q) ? std::optional(q) : std::nullopt;  // beyond 2^996 DoubleDouble's steps overflow
}

template <class Text>
[[gnu::noinline, gnu::cold]] double settled_quotient(const Text& text, double tolerance) {
  if (const std::optional<double> q = bounded_quotient<DoubleDouble>(text, tolerance)) return *q;
  const Ratio<Exact> r = text.template operator()<Exact>();
  return quotient(r.num, r.den);
}
}  // namespace detail

/// The quotient in S, within 2 ulp of S of its true value; infinite beyond the largest S. The text returns a
/// Ratio<W> whose den is not zero.
///
/// Bound. Each of num and den is within a relative eps / 8 of the truth, eps that of S, or Exact takes over; so the
/// quotient is within eps / 4 (1 + eps), rounded at most twice: less than an ulp and a half of S in all. Subnormal
/// results lose what S loses there: half a unit of the least subnormal more.
template <class S, class Text, class Trace = NoTrace>
S value_of(const Text& text, Trace&& trace = {}) {
  using V = std::conditional_t<std::is_same_v<S, float>, double, Extended>;
  constexpr double tolerance = std::numeric_limits<S>::epsilon() / 8;
  if (const std::optional<double> q = detail::bounded_quotient<V>(text, tolerance)) return static_cast<S>(*q);
  trace(Fallback{});
  return static_cast<S>(detail::settled_quotient(text, tolerance));
}

// Vectors of any arithmetic, in as many components as the shape has.

template <class W, int N>
using Components = std::array<W, N>;

/// x - y, component by component.
template <Filtered W, int N>
Components<W, N> difference(const Point<double, N>& x, const Point<double, N>& y) {
  Components<W, N> v;
  for (int i = 0; i < N; ++i) v[i] = difference<W>(x[i], y[i]);
  return v;
}

/// x itself in W.
template <Filtered W, int N>
Components<W, N> exactly(const Vector<double, N>& x) {
  Components<W, N> v;
  for (int i = 0; i < N; ++i) v[i] = W(x[i]);
  return v;
}

template <Filtered W, std::size_t N>
W dot(const std::array<W, N>& x, const std::array<W, N>& y) {
  W sum = x[0] * y[0];
  for (std::size_t i = 1; i < N; ++i) sum = sum + x[i] * y[i];
  return sum;
}

template <Filtered W>
std::array<W, 3> cross(const std::array<W, 3>& x, const std::array<W, 3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

}  // namespace isect
