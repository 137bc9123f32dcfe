#pragma once
// The exact scalar: m 2^e with an integer m of any size. Sums, differences and products of doubles stay
// exact.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include <isect/conventions.h>

namespace isect {

class Exact {
 public:
  Exact() = default;
  /// x itself; x must be finite.
  Exact(double x) {
    int e = 0;
    const double fraction = std::frexp(x, &e);  // 53 bits behind the point at most
    mantissa_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponent_ = e - 53;
  }

  friend Exact operator*(const Exact& x, const Exact& y) {
    return {x.mantissa_ * y.mantissa_, x.exponent_ + y.exponent_};
  }
  friend Exact operator+(const Exact& x, const Exact& y) {
    if (x.sign() == 0) return y;
    if (y.sign() == 0) return x;
    if (x.exponent_ < y.exponent_) return y + x;
    return {(x.mantissa_ << (x.exponent_ - y.exponent_)) + y.mantissa_, y.exponent_};
  }
  friend Exact operator-(const Exact& x) { return {-x.mantissa_, x.exponent_}; }
  friend Exact operator-(const Exact& x, const Exact& y) { return x + (-y); }

  friend Exact abs(const Exact& x) { return x.sign() < 0 ? -x : x; }
  friend Exact ldexp(const Exact& x, int exponent) { return {x.mantissa_, x.exponent_ + exponent}; }
  /// The greatest e with 2^e <= |x|, x != 0.
  friend int ilogb(const Exact& x) { return bits(x.mantissa_) - 1 + x.exponent_; }

  int sign() const { return mantissa_.sign(); }
  /// The nearest double, infinite when there is none.
  double rounded() const { return quotient(*this, Exact(1.0)); }

  /// The square root of x >= 0, truncated to a relative 2^-126.
  friend Exact sqrt(const Exact& x) {
    if (x.sign() == 0) return x;
    int shift = std::max(0, 256 - bits(x.mantissa_));
    if ((x.exponent_ - shift) % 2 != 0) ++shift;  // an even exponent halves
    return {boost::multiprecision::sqrt(Integer(x.mantissa_ << shift)), (x.exponent_ - shift) / 2};
  }

  /// The double nearest to x / y, y != 0; infinite when too large.
  friend double quotient(const Exact& x, const Exact& y) {
    if (x.sign() == 0) return 0;
    const Integer n = abs(x.mantissa_), d = abs(y.mantissa_);
    // so that the integer quotient has 63 or 64 bits, or fewer: two behind the last of a subnormal
    const int shift = std::min(63 + bits(d) - bits(n), x.exponent_ - y.exponent_ + 1076);
    Integer q, rest;
    divide_qr(Integer(shift > 0 ? n << shift : n), Integer(shift < 0 ? d << -shift : d), q, rest);
    const std::uint64_t sticky = rest.is_zero() ? 0 : 1;  // keeps the rounding below right
    const double leading = static_cast<double>(static_cast<std::uint64_t>(q) | sticky);
    const double size = std::ldexp(leading, x.exponent_ - y.exponent_ - shift);
    return x.sign() * y.sign() < 0 ? -size : size;
  }

 private:
  using Integer = boost::multiprecision::cpp_int;

  Exact(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  static int bits(const Integer& m) { return static_cast<int>(msb(abs(m))) + 1; }

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

}  // namespace isect
