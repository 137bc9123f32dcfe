#pragma once
// Exact arithmetic as far as 127 bits go: a whole number times a power of two, without a loop or a branch on the size.
// It settles what comes out equal on integers and grids, at a few nanoseconds an operation, before any other
// arithmetic is asked again.
//
// What needs more bits is unknown, and so is what is made of it; but 0 times anything is 0. That alone settles the many
// ties of shapes along the axes, where each product has a factor 0.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace isect {

class ShortExact {
 public:
  ShortExact() = default;
  /// x itself; unknown if x is infinite or NaN.
  ShortExact(double x) {
    const std::uint64_t digits = std::bit_cast<std::uint64_t>(x);
    const int field = static_cast<int>(digits >> 52 & 0x7ff);
    const std::uint64_t fraction = digits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t mantissa = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (field == 0x7ff) *this = unknown();
    if (field == 0x7ff || mantissa == 0) return;
    const int zeros = std::countr_zero(mantissa);
    whole_ = static_cast<Whole>(mantissa >> zeros);
    if (x < 0) whole_ = -whole_;
    bits_ = 64 - std::countl_zero(mantissa) - zeros;
    exponent_ = std::max(field, 1) - 1075 + zeros;
  }

  static ShortExact difference(double x, double y) { return ShortExact(x) - ShortExact(y); }

  friend ShortExact operator+(const ShortExact& a, const ShortExact& b) {
    if (a.whole_ == 0) return b;
    if (b.whole_ == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    const int shift = a.exponent_ - b.exponent_, bits = std::max(a.bits_ + shift, b.bits_) + 1;
    if (bits > most) return unknown();
    return {(a.whole_ << shift) + b.whole_, b.exponent_, bits};
  }
  friend ShortExact operator-(const ShortExact& a, const ShortExact& b) { return a + -b; }
  friend ShortExact operator*(const ShortExact& a, const ShortExact& b) {
    if (a.whole_ == 0 || b.whole_ == 0) return {};
    const int bits = a.bits_ + b.bits_;
    if (bits > most) return unknown();
    return {a.whole_ * b.whole_, a.exponent_ + b.exponent_, bits};
  }
  friend ShortExact operator-(const ShortExact& a) { return {-a.whole_, a.exponent_, a.bits_}; }
  friend ShortExact abs(const ShortExact& a) { return a.whole_ < 0 ? -a : a; }

  /// 1, 0, -1, or nothing where it is unknown.
  std::optional<int> sign() const {
    if (bits_ > most) return {};
    return (whole_ > 0) - (whole_ < 0);
  }

  /// The nearest double, for reports; NaN where it is unknown.
  double rounded() const {
    return bits_ > most ? std::numeric_limits<double>::quiet_NaN() : std::ldexp(static_cast<double>(whole_), exponent_);
  }

 private:
  __extension__ using Whole = __int128;
  static constexpr int most = 127;

  ShortExact(Whole whole, int exponent, int bits) : whole_(whole), exponent_(exponent), bits_(bits) {}
  static ShortExact unknown() { return {1, 0, 2 * most}; }

  Whole whole_ = 0;  // |whole_| < 2^bits_ where bits_ <= most; not 0 where the number is unknown
  int exponent_ = 0;
  int bits_ = 0;
};

}  // namespace isect
