#pragma once
// An unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi) / 2: about 106 bits, at some 20 operations each.
//
// Bounds below: u = 2^-53, no overflow and no underflow. Underflow of a low part adds at most 2^-1074, which
// the callers' range checks make negligible. Source: Joldes, Muller, Popescu, Tight and rigorous error bounds
// for basic building blocks of double-word arithmetic, ACM TOMS 44 (2017); Ogita, Rump, Oishi, Accurate sum
// and dot product, SISC 26 (2005).

#include <cmath>

#include <isect/conventions.h>

namespace isect {

struct DoubleDouble {
  double hi = 0, lo = 0;
};

/// T is double, or a vector of doubles: then what is said of doubles holds number by number.
template <class T>
struct SumOf {
  T hi, lo;
};

/// a + b exactly. Source: Knuth, TAOCP 2, 4.2.2.
template <class T>
ISECT_INLINE SumOf<T> two_sum_of(const T& a, const T& b) {
  const T s = a + b;
  const T bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}
ISECT_INLINE DoubleDouble two_sum(double a, double b) {
  const auto [hi, lo] = two_sum_of(a, b);
  return {hi, lo};
}

/// a + b exactly, for |a| >= |b| or a = 0. Source: Dekker 1971.
inline DoubleDouble fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// Whether the compiler was told to build for machines with a fused multiply-add.
#if defined(__FMA__) || defined(__aarch64__)
inline constexpr bool fuses_products = true;
#else
inline constexpr bool fuses_products = false;
#endif

namespace detail {
/// a b - p for p = a b, rounded.
template <class T>
ISECT_INLINE T split_rest(const T& a, const T& b, const T& p) {
  constexpr double split = 134217729;  // 2^27 + 1
  const T ta = split * a, tb = split * b;
  const T ah = ta - (ta - a), bh = tb - (tb - b);
  const T al = a - ah, bl = b - bh;
  return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}
}  // namespace detail

/// a * b exactly, with a fused multiply-add or by Veltkamp's splitting: the same value either way, unless a step
/// overflows, beyond 2^996, or underflows.
template <bool fused = fuses_products>
ISECT_INLINE DoubleDouble two_product(double a, double b) {
  const double p = a * b;
  if constexpr (fused)
    return {p, __builtin_fma(a, b, -p)};
  else
    return {p, detail::split_rest(a, b, p)};
}

/// |error| <= 4 u^2 (|x| + |y|).
inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  return fast_two_sum(s.hi, s.lo + (x.lo + y.lo));
}
inline DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi, -x.lo}; }
inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }

/// |error| <= 6 u^2 |x y|.
inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble p = two_product(x.hi, y.hi);
  return fast_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}
inline DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble p = two_product(x.hi, y);
  return fast_two_sum(p.hi, p.lo + x.lo * y);
}

namespace detail {
inline double head(double x) { return x; }
inline double head(const DoubleDouble& x) { return x.hi; }
/// The part of x y that x.hi y.hi leaves out, to first order.
inline double tail(double, double) { return 0; }
inline double tail(const DoubleDouble& x, double y) { return x.lo * y; }
inline double tail(const DoubleDouble& x, const DoubleDouble& y) { return x.hi * y.lo + x.lo * y.hi; }
}  // namespace detail

/// The compensated dot product of n <= 4 doubles or double-doubles: |error| <= 11 n u^2 sum |x_i y_i|. Each
/// term leaves low parts of at most 4 u |x_i y_i|, and every one of at most 2 n + 3 additions of low parts
/// errs by u of them. In the model of isect/numbers/arithmetic.h that is n + 2 factors, two more than a plain dot
/// product has; the bounds there have room for them, and offsets, which count for one, are exact here.
template <int N, class X, class Y>
DoubleDouble compensated_dot(const X& x, const Y& y) {
  DoubleDouble sum = two_product(detail::head(x[0]), detail::head(y[0]));
  sum.lo += detail::tail(x[0], y[0]);
  for (int i = 1; i < N; ++i) {
    const DoubleDouble p = two_product(detail::head(x[i]), detail::head(y[i]));
    const DoubleDouble s = two_sum(sum.hi, p.hi);
    sum = {s.hi, sum.lo + (s.lo + (p.lo + detail::tail(x[i], y[i])))};
  }
  return fast_two_sum(sum.hi, sum.lo);
}

/// x > 0; |error| <= 4 u^2 sqrt(x).
inline DoubleDouble sqrt(const DoubleDouble& x) {
  const double s = std::sqrt(x.hi);
  const DoubleDouble square = two_product(s, s);
  return fast_two_sum(s, ((x.hi - square.hi) - square.lo + x.lo) / (2 * s));
}

/// The double nearest to x / y, up to a relative 8 u^2 before the last rounding.
inline double quotient(const DoubleDouble& x, const DoubleDouble& y) {
  const double t = x.hi / y.hi;
  const DoubleDouble back = two_product(t, y.hi);
  return t + (((x.hi - back.hi) - back.lo) + (x.lo - t * y.lo)) / y.hi;
}

}  // namespace isect
