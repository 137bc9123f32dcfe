#pragma once
// The exact scalar: a whole number in base 2^64, times a power of the base. Sums, differences and products of doubles
// stay exact. What it does stays calls: a text of it is compiled in half the time, and takes as long to run.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include <isect/numbers/double_double.h>

namespace isect {

namespace detail {
using Digit = std::uint64_t;
__extension__ using TwoDigits = unsigned __int128;

/// An array of digits, the least first: up to 208 in place, more on the heap.
class Digits {
 public:
  Digits() = default;
  explicit Digits(int size) : size_(size) {
    if (size > in_place) far_ = std::make_unique_for_overwrite<Digit[]>(size);
  }
  [[gnu::noinline]] Digits(const Digits& other) : Digits(other.size_) { std::copy_n(other.data(), size_, data()); }
  [[gnu::noinline]] Digits(Digits&& other) noexcept : size_(other.size_), far_(std::move(other.far_)) {
    if (!far_) std::copy_n(other.near_, size_, near_);
    other.size_ = 0;
  }
  Digits& operator=(const Digits& other) { return *this = Digits(other); }
  [[gnu::noinline]] Digits& operator=(Digits&& other) noexcept {
    size_ = std::exchange(other.size_, 0);
    far_ = std::move(other.far_);
    if (!far_) std::copy_n(other.near_, size_, near_);
    return *this;
  }

  int size() const { return size_; }
  Digit* data() { return far_ ? far_.get() : near_; }
  const Digit* data() const { return far_ ? far_.get() : near_; }
  /// Keeps only the digits from first to end, not included.
  void keep(int first, int end) {
    if (first > 0) std::copy(data() + first, data() + end, data());
    size_ = end - first;
  }

 private:
  static constexpr int in_place = 208;  // 13,312 bits
  int size_ = 0;
  std::unique_ptr<Digit[]> far_;
  Digit near_[in_place];
};
}  // namespace detail

/// No heap is needed where the highest and the lowest bit of all numbers on the way are less than 13,248 places apart:
/// so never in a polynomial of degree six or less, as a double's bits lie 2,098 places apart at most.
class Exact {
 public:
  Exact() = default;
  /// x itself; x must be finite.
  Exact(double x);
  [[gnu::noinline]] static Exact difference(double x, double y) { return Exact(x) - Exact(y); }

  friend Exact operator+(const Exact& x, const Exact& y) { return sum(x, y, y.negative_); }
  friend Exact operator-(const Exact& x, const Exact& y) { return sum(x, y, !y.negative_); }
  friend Exact operator*(const Exact& x, const Exact& y);
  friend Exact operator-(Exact x) {
    x.negative_ = !x.negative_;
    return x;
  }

  friend Exact abs(Exact x) {
    x.negative_ = false;
    return x;
  }
  friend Exact ldexp(const Exact& x, int exponent) { return x * power(exponent); }
  /// The greatest e with 2^e <= |x|, x != 0.
  friend int ilogb(const Exact& x) { return 64 * x.end() - 1 - std::countl_zero(x.digit(x.end() - 1)); }

  int sign() const { return size() == 0 ? 0 : negative_ ? -1 : 1; }
  /// The nearest double, infinite when there is none.
  double rounded() const { return quotient(*this, power(0)); }

  /// The square root of x >= 0, truncated to a relative 2^-126.
  friend Exact sqrt(const Exact& x);
  /// The double nearest to x / y, y != 0; infinite when too large.
  friend double quotient(const Exact& x, const Exact& y);
  /// Returns what `quotient` does up to a relative 2^-100, in a fraction of the time.
  friend double near_quotient(const Exact& x, const Exact& y);

 private:
  using Digit = detail::Digit;
  using TwoDigits = detail::TwoDigits;

  /// Makes room for `size` digits to be written, the first of which counts 2^(64 first).
  Exact(int size, int first, bool negative) : digits_(size), first_(first), negative_(negative) {}

  /// 2^exponent.
  static Exact power(int exponent) {
    Exact x(1, exponent >> 6, false);
    x.digits_.data()[0] = Digit{1} << (exponent & 63);
    return x;
  }
  /// x + |y|, or x - |y| if `negative_y`.
  static Exact sum(const Exact& x, const Exact& y, bool negative_y);

  int size() const { return digits_.size(); }
  int end() const { return first_ + size(); }
  /// The digit that counts 2^(64 i).
  Digit digit(int i) const { return first_ <= i && i < end() ? digits_.data()[i - first_] : 0; }
  /// |x| / 2^(64 (end() - 2)), within a relative 2^-52.
  double leading() const {
    return static_cast<double>(static_cast<TwoDigits>(digit(end() - 1)) << 64 | digit(end() - 2));
  }
  /// |x| / 2^(64 (end() - 3)), within a relative 2^-105.
  DoubleDouble leading_digits() const {
    DoubleDouble sum;
    for (int i = 1; i <= 3; ++i) {
      const Digit d = digit(end() - i);
      sum = sum * 0x1p64 + fast_two_sum(static_cast<double>(d >> 32) * 0x1p32, static_cast<double>(d & 0xffffffff));
    }
    return sum;
  }
  /// x + y + carry, or x - y - carry, and what is carried on.
  static Digit add(Digit x, Digit y, Digit& carry) {
    const TwoDigits sum = static_cast<TwoDigits>(x) + y + carry;
    carry = static_cast<Digit>(sum >> 64);
    return static_cast<Digit>(sum);
  }
  static Digit subtract(Digit x, Digit y, Digit& carry) {
    const TwoDigits rest = static_cast<TwoDigits>(x) - y - carry;
    carry = static_cast<Digit>(rest >> 64) & 1;
    return static_cast<Digit>(rest);
  }
  /// Drops the zeros at both ends.
  void trim();

  detail::Digits digits_;
  int first_ = 0;
  bool negative_ = false;
};

[[gnu::noinline]] inline Exact::Exact(double x) : digits_(2), negative_(x < 0) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const Digit fraction = bits & ((Digit{1} << 52) - 1);
  const Digit mantissa = field == 0 ? fraction : fraction | Digit{1} << 52;
  const int exponent = std::max(field, 1) - 1075;  // |x| = mantissa 2^exponent
  const TwoDigits both = static_cast<TwoDigits>(mantissa) << (exponent & 63);
  first_ = exponent >> 6;
  digits_.data()[0] = static_cast<Digit>(both);
  digits_.data()[1] = static_cast<Digit>(both >> 64);
  trim();
}

inline void Exact::trim() {
  const Digit* const digits = digits_.data();
  int low = 0, high = size();
  while (high > 0 && digits[high - 1] == 0) --high;
  while (low < high && digits[low] == 0) ++low;
  digits_.keep(low, high);
  first_ += low;
}

[[gnu::noinline]] inline Exact Exact::sum(const Exact& x, const Exact& y, bool negative_y) {
  if (y.size() == 0) return x;
  if (x.size() == 0) return negative_y == y.negative_ ? y : -y;

  const int first = std::min(x.first_, y.first_), end = std::max(x.end(), y.end()) + 1, size = end - first;
  Exact result(size, first, x.negative_);
  Digit* const digits = result.digits_.data();
  Digit carry = 0;
  if (x.negative_ == negative_y) {
    for (int i = 0; i < size; ++i) digits[i] = add(x.digit(first + i), y.digit(first + i), carry);
  } else {
    for (int i = 0; i < size; ++i) digits[i] = subtract(x.digit(first + i), y.digit(first + i), carry);
    if (carry != 0) {  // |y| is the larger: what stands there is the difference to the base's next power
      result.negative_ = negative_y;
      carry = 0;
      for (int i = 0; i < size; ++i) digits[i] = subtract(0, digits[i], carry);
    }
  }
  result.trim();
  return result;
}

[[gnu::noinline]] inline Exact operator*(const Exact& x, const Exact& y) {
  if (x.size() == 0 || y.size() == 0) return {};
  Exact result(x.size() + y.size(), x.first_ + y.first_, x.negative_ != y.negative_);
  const detail::Digit *const a = x.digits_.data(), *const b = y.digits_.data();
  detail::Digit* const digits = result.digits_.data();
  for (int i = 0; i < x.size(); ++i) {
    detail::Digit carry = 0;
    for (int j = 0; j < y.size(); ++j) {
      const detail::TwoDigits p = static_cast<detail::TwoDigits>(a[i]) * b[j] + (i > 0 ? digits[i + j] : 0) + carry;
      digits[i + j] = static_cast<detail::Digit>(p), carry = static_cast<detail::Digit>(p >> 64);
    }
    digits[i + y.size()] = carry;
  }
  result.trim();
  return result;
}

[[gnu::noinline]] inline double quotient(const Exact& x, const Exact& y) {
  if (x.size() == 0) return 0;
  // Doubles above 0 are ordered as their bits are. Whether |x / y| rounds to a larger double than that of these bits:
  const auto rounds_beyond = [&x, &y](std::uint64_t bits) {
    const double most = std::numeric_limits<double>::max(), d = std::bit_cast<double>(bits);
    const double gap = d < most ? std::bit_cast<double>(bits + 1) - d : 0x1p971;
    const int side = (abs(x) - (Exact(d) + ldexp(Exact(gap), -1)) * abs(y)).sign();
    return side > 0 || (side == 0 && bits % 2 != 0);  // a tie goes to the even one
  };
  // A few units from it at most: the leading digits' quotient.
  const double guess = std::ldexp(x.leading() / y.leading(), 64 * (x.end() - y.end()));
  std::uint64_t bits = std::bit_cast<std::uint64_t>(std::min(guess, std::numeric_limits<double>::max()));
  while (std::isfinite(std::bit_cast<double>(bits)) && rounds_beyond(bits)) ++bits;
  while (bits > 0 && !rounds_beyond(bits - 1)) --bits;
  return x.negative_ == y.negative_ ? std::bit_cast<double>(bits) : -std::bit_cast<double>(bits);
}

[[gnu::noinline]] inline double near_quotient(const Exact& x, const Exact& y) {
  if (x.size() == 0) return 0;
  // Even far beyond the range of doubles std::ldexp gives infinity, or 0.
  const double q = std::ldexp(quotient(x.leading_digits(), y.leading_digits()), 64 * (x.end() - y.end()));
  return x.negative_ == y.negative_ ? q : -q;
}

[[gnu::noinline]] inline Exact sqrt(const Exact& x) {
  if (x.sign() == 0) return x;
  const int half = ilogb(x) >> 1;
  const Exact scaled = ldexp(x, -2 * half);  // 1 <= scaled < 4
  // Newton's steps, each by a quotient rounded to a double: the error falls from 2^-52 to 2^-102 to 2^-154.
  Exact root = std::sqrt(scaled.rounded());
  for (int steps = 0; steps < 2; ++steps) root = root + quotient(scaled - root * root, root + root);
  if ((scaled - root * root).sign() != 0) root = root - Exact(0x1p-130);
  return ldexp(root, half);
}

}  // namespace isect
