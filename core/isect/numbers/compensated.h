#pragma once
// A double and what rounding took from it: the unevaluated sum hi + lo. hi is what plain doubles compute; lo gathers
// the errors of their operations, which are doubles themselves, to first order. About 100 bits, like DoubleDouble, but
// lo is never folded back into hi, so that an operation costs half as much and none waits for the lo of another.
//
// Bound. Let s be the sum of the products' sizes and k the count of roundings, as in isect/numbers/bounded.h; k < 2^20.
// Then |lo| <= k u s and |truth - (hi + lo)| <= 2 k^2 u^2 s, up to factors of 1 + 4 k u:
//
//   difference of doubles    k = 1: |lo| <= u |hi|, no error.
//   sum                      errors add up; lo rounds twice, (2 k + 1) u^2 s; and 2 k^2 + 2 k + 1 < 2 (k + 1)^2.
//   product                  what hi and lo had, 2 (j^2 + k^2); lo lo', which is dropped, j k; and lo's five roundings,
//                            3 (j + k) + 1; all in u^2 s s'. That is below 2 (j + k + 1)^2.
//
// What is left there, a part of 1 / 2 k at least, pays for the factors. An underflow adds 2^-1072 at most. Where
// something overflows, lo or hi becomes NaN or infinite.
//
// Source: Lange, Rump, Faithfully rounded floating-point computations, ACM TOMS 46 (2020).
//
// Its products cost three operations with a fused multiply-add and eighteen without. A program built for any x86-64
// finds out when it runs whether the machine has one: `compensated` does that, and hands its text one type or the
// other. They give the same numbers, bit for bit, as long as neither overflows, beyond 2^996, nor underflows.

#include <array>
#include <cmath>
#include <cstddef>

#include <isect/numbers/double_double.h>

// Whether products may be fused on some of the machines that the program is built for, but not on all. 0 where the
// build says so: then the least of those machines is taken for all.
#ifndef ISECT_DISPATCH
#if defined(__x86_64__) && !defined(__FMA__)
#define ISECT_DISPATCH 1
#else
#define ISECT_DISPATCH 0
#endif
#endif

namespace isect {

template <bool fused>
struct CompensatedBy {
  double hi = 0, lo = 0;

  CompensatedBy() = default;
  CompensatedBy(double value, double rest = 0) : hi(value), lo(rest) {}
  ISECT_INLINE static CompensatedBy difference(double x, double y) {
    const DoubleDouble d = two_sum(x, -y);
    return {d.hi, d.lo};
  }
};

/// Compensated fuses products if the compiler was told to, Fused in any case.
using Compensated = CompensatedBy<fuses_products>;
using Fused = CompensatedBy<true>;

template <class T>
inline constexpr bool is_compensated = false;
template <bool fused>
inline constexpr bool is_compensated<CompensatedBy<fused>> = true;

namespace detail {
/// Whether the compiler sees that x is 0, as for a leaf: that saves the products and sums with it.
ISECT_INLINE bool nothing(double x) { return __builtin_constant_p(x == 0) && x == 0; }
ISECT_INLINE double plus(double x, double y) { return nothing(y) ? x : nothing(x) ? y : x + y; }
ISECT_INLINE double times(double x, double y) { return nothing(y) ? 0 : x * y; }
}  // namespace detail

template <bool fused>
ISECT_INLINE CompensatedBy<fused> operator+(const CompensatedBy<fused>& x, const CompensatedBy<fused>& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  return {s.hi, detail::plus(detail::plus(x.lo, y.lo), s.lo)};
}
template <bool fused>
ISECT_INLINE CompensatedBy<fused> operator-(const CompensatedBy<fused>& x) {
  return {-x.hi, -x.lo};
}
template <bool fused>
ISECT_INLINE CompensatedBy<fused> operator-(const CompensatedBy<fused>& x, const CompensatedBy<fused>& y) {
  return x + (-y);
}
template <bool fused>
ISECT_INLINE CompensatedBy<fused> operator*(const CompensatedBy<fused>& x, const CompensatedBy<fused>& y) {
  const DoubleDouble p = two_product<fused>(x.hi, y.hi);
  return {p.hi, detail::plus(p.lo, detail::plus(detail::times(x.hi, y.lo), detail::times(y.hi, x.lo)))};
}

template <bool fused>
ISECT_INLINE CompensatedBy<fused> abs(const CompensatedBy<fused>& x) {
  return x.hi + x.lo < 0 ? -x : x;
}

namespace detail {
/// x / y by `inverse`, 1 / y.hi.
template <bool fused>
ISECT_INLINE double quotient(const CompensatedBy<fused>& x, const CompensatedBy<fused>& y, double inverse) {
  const double q = x.hi * inverse;
  const DoubleDouble back = two_product<fused>(q, y.hi);
  return q + (((x.hi - back.hi) - back.lo) + (x.lo - q * y.lo)) * inverse;
}
}  // namespace detail

/// hi + lo with |lo| <= u |hi|, rounded once where it must be.
template <bool fused>
ISECT_INLINE CompensatedBy<fused> in_two(const CompensatedBy<fused>& x) {
  const DoubleDouble s = two_sum(x.hi, x.lo);
  return {s.hi, s.lo};
}

/// x / y for |lo| <= 2^-32 |hi| in y, within 2^-60 (|hi| + |lo|) / |y| of x before the last rounding; NaN or infinite
/// where it overflows, or 1 / y.
template <bool fused>
ISECT_INLINE double quotient(const CompensatedBy<fused>& x, const CompensatedBy<fused>& y) {
  return detail::quotient(x, y, 1 / y.hi);
}

/// The square root of x > 0, where |lo| <= 2^-32 hi, within a relative 2^-60.
template <bool fused>
inline CompensatedBy<fused> sqrt(const CompensatedBy<fused>& x) {
  const double s = std::sqrt(x.hi);
  const DoubleDouble back = two_product<fused>(s, s);
  return {s, (((x.hi - back.hi) - back.lo) + x.lo) / (2 * s)};
}

namespace detail {
/// Two doubles, computed with side by side.
typedef double Two __attribute__((vector_size(16)));

/// x in both.
ISECT_INLINE Two both(double x) { return Two{x, x}; }

/// Two products exactly.
template <bool fused>
ISECT_INLINE SumOf<Two> two_product_of(const Two& x, const Two& y) {
  const Two p = x * y;
  if constexpr (fused)
    return {p, Two{__builtin_fma(x[0], y[0], -p[0]), __builtin_fma(x[1], y[1], -p[1])}};
  else
    return {p, split_rest(x, y, p)};
}

/// Whether V is a vector of numbers with tails rather than of doubles; head(v, i) is component i without its tail.
template <class V>
inline constexpr bool has_tails = requires(const V& v) {
  v[0].lo;
};
template <class V>
ISECT_INLINE double head(const V& v, int i) {
  if constexpr (has_tails<V>)
    return v[i].hi;
  else
    return v[i];
}
/// n_i x_i and n_i y_i. Where y has tails, x has some.
template <bool fused, class X, class Y, class Z>
ISECT_INLINE SumOf<Two> two_products(const X& n, const Y& x, const Z& y, int i) {
  const Two pair = {head(x, i), head(y, i)}, twice = both(head(n, i));
  SumOf<Two> p = two_product_of<fused>(twice, pair);
  constexpr bool of_n = has_tails<X>, of_x = has_tails<Y>, of_y = has_tails<Z>;
  static_assert(of_x || !of_y);
  const Two tails = [&] {
    if constexpr (of_y)
      return twice * Two{x[i].lo, y[i].lo};
    else if constexpr (of_x)
      return Two{twice[0] * x[i].lo, 0};
    else
      return Two{0, 0};
  }();
  if constexpr (of_n)
    p.lo += tails + n[i].lo * pair;  // the order of operator*, so that the bits are the same
  else if constexpr (of_x)
    p.lo += tails;
  return p;
}
}  // namespace detail

/// The numbers n.x and n.y, found side by side. Each of n, x, y is a vector of doubles or of numbers with tails.
template <bool fused>
struct TwoDots {
  CompensatedBy<fused> x, y;
};
template <bool fused, int N, class X, class Y, class Z>
ISECT_INLINE TwoDots<fused> two_dots(const X& n, const Y& x, const Z& y) {
  static_assert(N == 2 || N == 3);  // without a loop, which GCC would vectorise by way of memory
  using detail::Two;
  const SumOf<Two> p = detail::two_products<fused>(n, x, y, 0), q = detail::two_products<fused>(n, x, y, 1);
  const SumOf<Two> s = two_sum_of(p.hi, q.hi);
  Two hi = s.hi, lo = (p.lo + q.lo) + s.lo;
  if constexpr (N == 3) {
    const SumOf<Two> r = detail::two_products<fused>(n, x, y, 2), t = two_sum_of(hi, r.hi);
    hi = t.hi, lo = (lo + r.lo) + t.lo;
  }
  return {{hi[0], lo[0]}, {hi[1], lo[1]}};
}

namespace detail {
template <class Text>
[[gnu::flatten]] inline auto as_built(const Text& text) {
  return text.template operator()<Compensated>();
}
#if ISECT_DISPATCH
template <class Text>
[[gnu::target("avx,fma"), gnu::noinline, gnu::flatten]] auto fused(const Text& text) {
  return text.template operator()<Fused>();
}
#endif
}  // namespace detail

/// text.operator()<W>() for the faster W of Compensated and Fused on this machine.
template <class Text>
ISECT_INLINE auto compensated(const Text& text) {
#if ISECT_DISPATCH
  if (__builtin_cpu_supports("fma")) return detail::fused(text);
#endif
  return detail::as_built(text);
}

}  // namespace isect
