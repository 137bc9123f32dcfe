#pragma once
// A double, what rounding took from it, and what rounding took from that: the unevaluated sum hi + lo + rest. As
// isect/numbers/compensated.h, one order further: about 150 bits. Products of three differences that cancel except for
// their last bit are known to be 0 or not, and so are quotients of such; numbers of any length would take ten times as
// long.
//
// Bound. Let s be the sum of the products' sizes and k the count of roundings, as in isect/numbers/bounded.h; k < 2^20.
// Then |lo| <= k u s, |rest| <= 2 k^2 u^2 s and |truth - (hi + lo + rest)| <= 8 k^3 u^3 s, up to factors
// near 1:
//
//   difference of doubles    k = 1: |lo| <= u |hi|, no rest, no error.
//   sum                      rest: 2 k^2 u^2 s of the two, and (2 k + 1) u^2 s that two sums of lo leave; below
//                            2 (k + 1)^2 u^2 s. It rounds three times: 6 (k + 1)^2 u^3 s, and 8 k^3 + 6 (k + 1)^2 <
//                            8 (k + 1)^3 for k > 0; for k = 0 nothing is rounded.
//   product                  let K = j + k + 1. rest: 2 (j^2 + k^2) u^2 s s' of the two rests, j k of lo lo', and
//                            3 (j + k) + 1 that the products and sums of lo leave; below 2 K^2. What is dropped,
//                            lo rest' and rest lo', is 2 j k (j + k) u^3 s s'; the products round by j k + 2 j^2 + 2
//                            k^2, six sums by 2 K^2 each. With the two errors, 8 (j^3 + k^3), that is below 8 K^3
//                            unless j = k = 0, where nothing is rounded.
//
// Nothing underflows where the grid of the whole is known, isect/numbers/grid.h: all terms that are exact are multiples
// of theirs. Where something overflows, a part becomes NaN or infinite.
//
// Source: Ogita, Rump, Oishi, Accurate sum and dot product, SISC 26 (2005), for K = 3.

#include <type_traits>

#include <isect/numbers/compensated.h>

namespace isect {

struct TripleDouble {
  double hi = 0, lo = 0, rest = 0;

  TripleDouble() = default;
  TripleDouble(double value, double first = 0, double second = 0) : hi(value), lo(first), rest(second) {}
  ISECT_INLINE static TripleDouble difference(double x, double y) {
    const DoubleDouble d = two_sum(x, -y);
    return {d.hi, d.lo};
  }
};

namespace detail {
template <bool fused>
ISECT_INLINE TripleDouble product(const TripleDouble& x, const TripleDouble& y) {
  const DoubleDouble p = two_product<fused>(x.hi, y.hi), a = two_product<fused>(x.hi, y.lo),
                     b = two_product<fused>(y.hi, x.lo), c = two_sum(a.hi, b.hi), d = two_sum(c.hi, p.lo);
  const double second = x.lo * y.lo + x.hi * y.rest + y.hi * x.rest;
  return {p.hi, d.hi, second + a.lo + b.lo + c.lo + d.lo};
}
}  // namespace detail

// Sums and products stay calls, which find out themselves whether the machine fuses products: inlined, in a text for
// either kind of machine, they would take a sixth of the time that a text takes to compile, and be as fast.
[[gnu::noinline]] inline TripleDouble operator+(const TripleDouble& x, const TripleDouble& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi), a = two_sum(x.lo, y.lo), b = two_sum(a.hi, s.lo);
  return {s.hi, b.hi, x.rest + y.rest + a.lo + b.lo};
}
[[gnu::noinline]] inline TripleDouble operator*(const TripleDouble& x, const TripleDouble& y) {
  return compensated([&]<class W>() { return detail::product<std::is_same_v<W, Fused>>(x, y); });
}

ISECT_INLINE TripleDouble operator-(const TripleDouble& x) { return {-x.hi, -x.lo, -x.rest}; }
ISECT_INLINE TripleDouble operator-(const TripleDouble& x, const TripleDouble& y) { return x + (-y); }

/// hi + lo + rest in two doubles, within u^2 (|lo| + |rest|) of it.
inline DoubleDouble in_two(const TripleDouble& x) {
  const DoubleDouble a = two_sum(x.lo, x.rest), b = two_sum(x.hi, a.hi), c = two_sum(b.lo, a.lo);
  const DoubleDouble d = two_sum(b.hi, c.hi);
  return two_sum(d.hi, d.lo + c.lo);
}
inline TripleDouble abs(const TripleDouble& x) { return in_two(x).hi < 0 ? -x : x; }
inline double quotient(const TripleDouble& x, const TripleDouble& y) { return quotient(in_two(x), in_two(y)); }

}  // namespace isect
