#pragma once
// Exact arithmetic in a fixed number of bits: a whole number times a power of two, without a loop or a branch on the
// size. It settles what comes out equal, at a few nanoseconds an operation, where rounded numbers can't.
//
// A value that needs more bits is unknown, and so is any result of it, except that 0 times anything is 0. That alone
// settles the many ties of shapes along the axes, where each product has a factor 0.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <isect/numbers/double_double.h>

namespace isect {

namespace detail {
__extension__ using Whole128 = unsigned __int128;

/// A whole number modulo 2^256: low + 2^128 high.
struct Whole256 {
  Whole128 low = 0, high = 0;

  friend bool operator==(const Whole256& x, const Whole256& y) { return ((x.low ^ y.low) | (x.high ^ y.high)) == 0; }
};

// The operations that both have. A number is below 0 iff its highest bit is set.

ISECT_INLINE Whole128 sum(Whole128 x, Whole128 y) { return x + y; }
ISECT_INLINE Whole128 product(Whole128 x, Whole128 y) { return x * y; }
ISECT_INLINE Whole128 negative(Whole128 x) { return -x; }
ISECT_INLINE Whole128 shifted(Whole128 x, int by) { return x << by; }
ISECT_INLINE bool below_zero(Whole128 x) { return static_cast<std::uint64_t>(x >> 64) >> 63 != 0; }
ISECT_INLINE Whole128 whole(std::int64_t x, Whole128) { return static_cast<Whole128>(x); }
/// x or y, without a branch that is hard to predict: `mask` is all ones or 0.
ISECT_INLINE Whole128 either(std::int64_t mask, Whole128 x, Whole128 y) {
  return y ^ ((x ^ y) & static_cast<Whole128>(mask));
}
ISECT_INLINE int either(std::int64_t mask, int x, int y) { return y ^ ((x ^ y) & static_cast<int>(mask)); }

ISECT_INLINE Whole256 sum(const Whole256& x, const Whole256& y) {
  const Whole128 low = x.low + y.low;
  return {low, x.high + y.high + (low < y.low)};
}
ISECT_INLINE Whole256 product(const Whole256& x, const Whole256& y) {
  const std::uint64_t x0 = static_cast<std::uint64_t>(x.low), x1 = static_cast<std::uint64_t>(x.low >> 64),
                      y0 = static_cast<std::uint64_t>(y.low), y1 = static_cast<std::uint64_t>(y.low >> 64);
  const Whole128 p00 = static_cast<Whole128>(x0) * y0, p01 = static_cast<Whole128>(x0) * y1,
                 p10 = static_cast<Whole128>(x1) * y0, p11 = static_cast<Whole128>(x1) * y1;
  const Whole128 middle = (p00 >> 64) + static_cast<std::uint64_t>(p01) + static_cast<std::uint64_t>(p10);
  return {middle << 64 | static_cast<std::uint64_t>(p00),
          p11 + (p01 >> 64) + (p10 >> 64) + (middle >> 64) + x.low * y.high + x.high * y.low};
}
ISECT_INLINE Whole256 negative(const Whole256& x) { return {-x.low, ~x.high + (x.low == 0)}; }
ISECT_INLINE Whole256 shifted(const Whole256& x, int by) {
  const int rest = by & 127;
  const Whole128 low = x.low << rest, high = x.high << rest | x.low >> 1 >> (127 - rest);
  const std::int64_t far = -static_cast<std::int64_t>(by >> 7);
  return {either(far, Whole128{0}, low), either(far, low, high)};
}
ISECT_INLINE bool below_zero(const Whole256& x) { return below_zero(x.high); }
ISECT_INLINE Whole256 whole(std::int64_t x, const Whole256&) {
  return {static_cast<Whole128>(x), static_cast<Whole128>(x >> 63)};
}
ISECT_INLINE Whole256 either(std::int64_t mask, const Whole256& x, const Whole256& y) {
  return {either(mask, x.low, y.low), either(mask, x.high, y.high)};
}

inline DoubleDouble to_double_double(std::uint64_t x) {
  return fast_two_sum(static_cast<double>(x >> 32) * 0x1p32, static_cast<double>(x & 0xffffffff));
}
/// x >= 0, within a relative 2^-105.
inline DoubleDouble to_double_double(Whole128 x) {
  return to_double_double(static_cast<std::uint64_t>(x >> 64)) * 0x1p64 +
         to_double_double(static_cast<std::uint64_t>(x));
}
inline DoubleDouble to_double_double(const Whole256& x) {
  const std::uint64_t top = static_cast<std::uint64_t>(x.high >> 64), next = static_cast<std::uint64_t>(x.high);
  if ((top | next) == 0) return to_double_double(x.low);
  const int zeros = top != 0 ? std::countl_zero(top) : 64 + std::countl_zero(next);
  const DoubleDouble leading = to_double_double(shifted(x, zeros).high);  // the 128 highest bits
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + 128 - zeros) << 52);
  return {leading.hi * scale, leading.lo * scale};
}
}  // namespace detail

/// Whole is Whole128 or Whole256: 127 or 255 bits and a sign. With Whole256 operations stay calls, so that a text of
/// them is compiled soon.
template <class Whole>
class FixedExact {
 public:
  FixedExact() = default;
  /// x itself; unknown if x is infinite or NaN.
  ISECT_INLINE FixedExact(double x) : FixedExact(calls ? called_from(x) : from(x)) {}
  ISECT_INLINE static FixedExact difference(double x, double y) {
    return calls ? called_difference(x, y) : sum(from(x), -from(y));
  }

  ISECT_INLINE friend FixedExact operator+(const FixedExact& a, const FixedExact& b) {
    return calls ? called_sum(a, b) : sum(a, b);
  }
  ISECT_INLINE friend FixedExact operator-(const FixedExact& a, const FixedExact& b) {
    return calls ? called_difference(a, b) : sum(a, -b);
  }
  ISECT_INLINE friend FixedExact operator*(const FixedExact& a, const FixedExact& b) {
    return calls ? called_product(a, b) : product(a, b);
  }
  ISECT_INLINE friend FixedExact operator-(const FixedExact& a) {
    return {detail::negative(a.whole_), a.exponent_, a.bits_};
  }
  ISECT_INLINE friend FixedExact abs(const FixedExact& a) { return detail::below_zero(a.whole_) ? -a : a; }

  /// 1, 0, -1, or nothing where it is unknown.
  ISECT_INLINE std::optional<int> sign() const {
    if (!known()) return {};
    return whole_ == Whole{} ? 0 : detail::below_zero(whole_) ? -1 : 1;
  }

  /// The nearest double, for reports; NaN where it is unknown.
  double rounded() const {
    if (!known()) return std::numeric_limits<double>::quiet_NaN();
    return whole_ == Whole{} ? 0 : std::ldexp(mantissa().hi, exponent_);
  }
  /// The double nearest to x / y, y != 0, up to a relative 2^-100; NaN where one is unknown.
  [[gnu::noinline]] friend double quotient(const FixedExact& x, const FixedExact& y) {
    if (!x.known() || !y.known()) return std::numeric_limits<double>::quiet_NaN();
    if (x.whole_ == Whole{}) return 0;
    return std::ldexp(quotient(x.mantissa(), y.mantissa()), x.exponent_ - y.exponent_);
  }
  /// The square root of x >= 0, within a relative 2^-103; unknown where x is.
  [[gnu::noinline]] friend FixedExact sqrt(const FixedExact& x) {
    if (!x.known() || x.whole_ == Whole{}) return x;
    const int odd = x.exponent_ & 1;
    const DoubleDouble root = sqrt(x.mantissa() * (1.0 + odd));
    FixedExact result = FixedExact(root.hi) + FixedExact(root.lo);
    result.exponent_ += (x.exponent_ - odd) / 2;
    return result;
  }

 private:
  static constexpr bool calls = sizeof(Whole) > 16;

  ISECT_INLINE static FixedExact from(double x) {
    const std::uint64_t digits = std::bit_cast<std::uint64_t>(x), hidden = std::uint64_t{1} << 52;
    const int field = static_cast<int>(digits >> 52 & 0x7ff);
    const int subnormal = field == 0;
    const std::uint64_t mantissa = (digits & (hidden - 1)) | static_cast<std::uint64_t>(1 - subnormal) << 52;
    const int zeros = std::countr_zero(mantissa | hidden);
    const std::int64_t size = static_cast<std::int64_t>(mantissa >> zeros),
                       sign = static_cast<std::int64_t>(digits) >> 63, zero = -static_cast<std::int64_t>(size == 0);
    return {detail::whole((size ^ sign) - sign, Whole{}),
            detail::either(zero, zero_exponent, field + subnormal - 1075 + zeros),
            detail::either(zero, zero_bits, 53 - zeros + (static_cast<int>(field == 0x7ff) << 10))};
  }
  ISECT_INLINE static FixedExact sum(const FixedExact& a, const FixedExact& b) {
    const int ahead = a.exponent_ - b.exponent_, behind = ahead & ahead >> 31, up = ahead - behind;
    const int bits_a = a.bits_ + up, bits_b = b.bits_ - behind, more = bits_a - bits_b;
    const int bits = bits_a - (more & more >> 31) + 1, exponent = b.exponent_ + behind;
    const Whole whole = detail::sum(detail::shifted(a.whole_, up & most), detail::shifted(b.whole_, -behind & most));
    const std::int64_t zero = -static_cast<std::int64_t>((whole == Whole{}) & (bits <= most));
    return {whole, detail::either(zero, zero_exponent, exponent), detail::either(zero, zero_bits, bits)};
  }
  ISECT_INLINE static FixedExact product(const FixedExact& a, const FixedExact& b) {
    return {detail::product(a.whole_, b.whole_), a.exponent_ + b.exponent_, a.bits_ + b.bits_};
  }
  [[gnu::noinline]] static FixedExact called_from(double x) { return from(x); }
  [[gnu::noinline]] static FixedExact called_sum(const FixedExact& a, const FixedExact& b) { return sum(a, b); }
  [[gnu::noinline]] static FixedExact called_product(const FixedExact& a, const FixedExact& b) { return product(a, b); }
  [[gnu::noinline]] static FixedExact called_difference(const FixedExact& a, const FixedExact& b) { return sum(a, -b); }
  [[gnu::noinline]] static FixedExact called_difference(double x, double y) { return sum(from(x), -from(y)); }

  bool known() const { return bits_ <= most; }
  /// The number divided by 2^exponent, within a relative 2^-105.
  DoubleDouble mantissa() const {
    return detail::below_zero(whole_) ? -detail::to_double_double(detail::negative(whole_))
                                      : detail::to_double_double(whole_);
  }

  static constexpr int most = 8 * sizeof(Whole) - 1;
  // 0 is a multiple of any power of two and has no bits, whatever it is multiplied by: sums and products need no
  // branch.
  static constexpr int zero_exponent = 1 << 13, zero_bits = -(1 << 16);

  ISECT_INLINE FixedExact(const Whole& whole, int exponent, int bits)
      : whole_(whole), exponent_(exponent), bits_(bits) {}

  Whole whole_ = {};  // |whole| < 2^bits where that is known
  int exponent_ = zero_exponent;
  int bits_ = zero_bits;
};

using ShortExact = FixedExact<detail::Whole128>;
using MediumExact = FixedExact<detail::Whole256>;

}  // namespace isect
