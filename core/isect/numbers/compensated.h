#pragma once
// A double and what rounding took from it: the unevaluated sum hi + lo. hi is what plain doubles compute; lo gathers
// the errors of their operations, which are doubles themselves, to first order. About 100 bits, like DoubleDouble, but
// lo is never folded back into hi, so that an operation costs half as much and none waits for the lo of another.
//
// Bound. Let s be the sum of the products' sizes and k the count of roundings, as in isect/numbers/bounded.h; k < 2^20.
// Then |lo| <= k u s and |truth - (hi + lo)| <= 2 k^2 u^2 s, but for factors of 1 + 4 k u:
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

#include <isect/numbers/double_double.h>

namespace isect {

struct Compensated {
  double hi = 0, lo = 0;

  Compensated() = default;
  Compensated(double value, double rest = 0) : hi(value), lo(rest) {}
  [[gnu::always_inline]] static Compensated difference(double x, double y) {
    const DoubleDouble d = two_sum(x, -y);
    return {d.hi, d.lo};
  }
};

[[gnu::always_inline]] inline Compensated operator+(const Compensated& x, const Compensated& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  return {s.hi, (x.lo + y.lo) + s.lo};
}
[[gnu::always_inline]] inline Compensated operator-(const Compensated& x) { return {-x.hi, -x.lo}; }
[[gnu::always_inline]] inline Compensated operator-(const Compensated& x, const Compensated& y) { return x + (-y); }
[[gnu::always_inline]] inline Compensated operator*(const Compensated& x, const Compensated& y) {
  const DoubleDouble p = two_product(x.hi, y.hi);
  return {p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi)};
}

[[gnu::always_inline]] inline Compensated abs(const Compensated& x) { return x.hi + x.lo < 0 ? -x : x; }

/// The double nearest to x / y but for a relative 2^-100.
inline double quotient(const Compensated& x, const Compensated& y) {
  return quotient(two_sum(x.hi, x.lo), two_sum(y.hi, y.lo));
}

}  // namespace isect
