#pragma once
// A double and its tail, the unevaluated sum hi + lo, for values: some 75 bits, on any machine, faster than those of
// isect/numbers/compensated.h. There hi is what doubles compute and lo all that rounding took. Here, where no fused
// multiply-add gives that at once, factors are split: hi gets the product of their heads, 26 bits each, which is exact,
// and lo the rest of it, rounded. Heads on one grid, as in dot and cross, add up without rounding, too.
//
// Bound, in the model of isect/numbers/bounded.h, with v = 2^-24, for polynomials of degree 16 at most, and fewer than
// 2^20 roundings. A tail is at most v times its number, or in dot and cross, v times the largest number; so by the
// rules below |lo| <= g v s for g = 1 for a leaf, g + g' + 2 for a product, the larger one for a sum but for 2^-28
// each: g < 49. A sum rounds numbers of that size twice, a product at most five times, so that each of k roundings adds
// at most 5 g u v s, below 2^-69 s: |truth - (hi + lo)| <= k unit<Tailed> s, unit<Tailed> = 2^-68. What underflows in
// lo is less than 2^-1070, as in Compensated. What overflows, or is so large that its head does, becomes NaN or
// infinite.
//
// Source: T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971); for
// heads on one grid, Ozaki, Ogita, Oishi, Rump, Error-free transformations of matrix multiplication, Numer. Algorithms
// 59 (2012).

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <isect/numbers/double_double.h>

namespace isect {

struct Tailed {
  double hi = 0, lo = 0;

  Tailed() = default;
  Tailed(double value, double rest = 0) : hi(value), lo(rest) {}
  [[gnu::always_inline]] static Tailed difference(double x, double y) {
    const DoubleDouble d = two_sum(x, -y);
    return {d.hi, d.lo};
  }
};

namespace detail {
/// x rounded to a whole multiple of 2^-53 `grid`, or somewhat more. What it leaves of x is exact.
[[gnu::always_inline]] inline double head_on(double grid, double x) { return (grid + x) - grid; }
/// Whether the compiler sees that it is 0, which saves what is multiplied by it.
[[gnu::always_inline]] inline bool nothing(double x) { return __builtin_constant_p(x == 0) && x == 0; }
[[gnu::always_inline]] inline double plus(double x, double y) { return nothing(y) ? x : nothing(x) ? y : x + y; }

/// On which numbers up to `largest` have heads of 24 bits. It is 3/2 of a power of two, so that x and -x are split
/// alike.
[[gnu::always_inline]] inline double grid_for(double largest) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(0x1p53 * largest) & std::uint64_t{0x7ff} << 52;
  return std::bit_cast<double>(exponent) * 0x1.8p-24;
}
template <std::size_t N>
[[gnu::always_inline]] inline double grid_for(const std::array<Tailed, N>& x) {
  double largest = std::abs(x[0].hi);
  for (std::size_t i = 1; i < N; ++i) largest = std::max(largest, std::abs(x[i].hi));
  return grid_for(largest);
}

/// x y with their heads on these grids.
[[gnu::always_inline]] inline Tailed product(double grid_x, const Tailed& x, double grid_y, const Tailed& y) {
  const double a = head_on(grid_x, x.hi), b = head_on(grid_y, y.hi);
  const double rest_x = plus(x.hi - a, x.lo), rest_y = plus(y.hi - b, y.lo);
  return {a * b, a * rest_y + rest_x * plus(y.hi, y.lo)};
}
}  // namespace detail

[[gnu::always_inline]] inline Tailed operator+(const Tailed& x, const Tailed& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  return {s.hi, detail::plus(s.lo, detail::plus(x.lo, y.lo))};
}
[[gnu::always_inline]] inline Tailed operator-(const Tailed& x) { return {-x.hi, -x.lo}; }
[[gnu::always_inline]] inline Tailed operator-(const Tailed& x, const Tailed& y) { return x + (-y); }
[[gnu::always_inline]] inline Tailed operator*(const Tailed& x, const Tailed& y) {
#if defined(__FMA__) || defined(__aarch64__)
  const double p = x.hi * y.hi;
  double rest = std::fma(x.hi, y.hi, -p);
#else
  const double a = detail::head_on(0x1p27 * x.hi, x.hi), b = detail::head_on(0x1p27 * y.hi, y.hi), p = a * b;
  double rest = a * (y.hi - b) + (x.hi - a) * y.hi;
#endif
  if (!detail::nothing(y.lo)) rest += x.hi * y.lo;
  if (!detail::nothing(x.lo)) rest += x.lo * detail::plus(y.hi, y.lo);
  return {p, rest};
}

[[gnu::always_inline]] inline Tailed abs(const Tailed& x) { return x.hi + x.lo < 0 ? -x : x; }

/// x.y
template <std::size_t N>
[[gnu::always_inline]] inline Tailed dot(const std::array<Tailed, N>& x, const std::array<Tailed, N>& y) {
  static_assert(N == 2 || N == 3);  // without a loop, which GCC would vectorise by way of memory
  const double grid_x = detail::grid_for(x), grid_y = detail::grid_for(y);
  const Tailed p = detail::product(grid_x, x[0], grid_y, y[0]), q = detail::product(grid_x, x[1], grid_y, y[1]);
  if constexpr (N == 2) return {p.hi + q.hi, p.lo + q.lo};
  const Tailed r = detail::product(grid_x, x[N - 1], grid_y, y[N - 1]);
  return {p.hi + q.hi + r.hi, p.lo + q.lo + r.lo};
}

/// x times y
[[gnu::always_inline]] inline std::array<Tailed, 3> cross(const std::array<Tailed, 3>& x,
                                                          const std::array<Tailed, 3>& y) {
  const double grid_x = detail::grid_for(x), grid_y = detail::grid_for(y);
  const auto minor = [&](int i, int j) __attribute__((always_inline))->Tailed {
    const Tailed p = detail::product(grid_x, x[i], grid_y, y[j]), q = detail::product(grid_x, x[j], grid_y, y[i]);
    return {p.hi - q.hi, p.lo - q.lo};
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// x / y for |lo| <= 2^-7 |hi| in both, within a relative 2^-56 before the last rounding; NaN or infinite where it
/// overflows, or 1 / y.
[[gnu::always_inline]] inline double quotient(const Tailed& x, const Tailed& y) {
  const double inverse = 1 / (y.hi + y.lo), q = (x.hi + x.lo) * inverse;
  const Tailed back = Tailed(q) * y;
  return q + ((x.hi - back.hi) + (x.lo - back.lo)) * inverse;
}

/// The square root of x > 0, where |lo| <= 2^-7 hi, within a relative 2^-56.
inline Tailed sqrt(const Tailed& x) {
  const double s = std::sqrt(x.hi + x.lo);
  const Tailed back = Tailed(s) * Tailed(s);
  return {s, ((x.hi - back.hi) + (x.lo - back.lo)) / (2 * s)};
}

}  // namespace isect
