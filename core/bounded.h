#pragma once
// A number that knows how far it may be from the truth, so that one polynomial text is its own proved filter.
//
// In floating point a sum of products, each built with k roundings, errs by at most g(k) times the sum of the
// products' sizes, g(k) = k u / (1 - k u) (Higham, Accuracy and Stability, 2nd ed., ch. 3). Bounded carries all
// three: the value, the size, the count k. The count is a constant to the compiler once the text is inlined, so
// the price is that of a second, sign-less evaluation.
//
//   leaf x             value x            size |x|             0 roundings    (x is a double, taken exactly)
//   difference(x, y)   x - y              |x - y|              1              (its error is relative: no cancellation)
//   a + b, a - b       value              size a + size b      max + 1
//   a b                value              size a size b + tiny sum + 1
//
// Underflow: a product errs by at most 2^-1075 more in double, 2^-1072 in DoubleDouble, which is below u tiny. Overflow
// makes the size infinite or the value NaN, and nothing certain. The size's own roundings, two for each of the value's,
// and those of the last comparison are paid by one more u: (k + 1) u >= g(k) (1 - u)^-2k (1 + u)^4 for k < 2^20.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "core/filter.h"

namespace isect {

/// T is double, Extended or DoubleDouble. The size stays a double, as x87 code for it would be slow.
template <class T>
class Bounded {
 public:
  Bounded() = default;
  Bounded(double x) : value_{x}, size_(std::abs(x)) {}

  static Bounded difference(double x, double y) {
    const T value = isect::difference<T>(x, y);
    return {value, std::abs(leading(value)), 1};
  }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value_ + b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value_ - b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return {a.value_ * b.value_, a.size_ * b.size_ + underflow(a, b), a.roundings_ + b.roundings_ + 1};
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value_, a.size_, a.roundings_}; }
  friend Bounded abs(const Bounded& a) { return leading(a.value_) < 0 ? -a : a; }

  /// 1, 0, -1, or nothing where the error could turn it.
  std::optional<int> sign() const {
    const double head = leading(value_);
    if (std::abs(head) > error()) return head > 0 ? 1 : -1;  // false for NaN
    if (size_ == 0) return 0;                                // nothing but zeros was summed
    return {};
  }
  /// Whether the value lies within a relative `tolerance` of the truth.
  bool within(double tolerance) const {
    return std::isfinite(size_) && error() <= tolerance * std::abs(leading(value_));  // infinity <= infinity
  }

  const T& value() const { return value_; }
  /// |value - truth| <= error(); infinite or NaN where nothing is known.
  double error() const { return (roundings_ + 1) * unit<T> * size_; }

 private:
  /// What a product may lose, in units of u. Nothing when a factor is zero: that would make no sum of zeros certain. In
  /// double asking for it would cost more than it saves.
  static double underflow(const Bounded& a, const Bounded& b) {
    if constexpr (std::is_same_v<T, DoubleDouble>)
      return a.size_ == 0 || b.size_ == 0 ? 0 : 0x1p-960;
    else
      return 0x1p-1000;
  }

  Bounded(const T& value, double size, int roundings) : value_(value), size_(size), roundings_(roundings) {}

  T value_ = {};
  double size_ = 0;
  int roundings_ = 0;
};

/// What the polynomial texts of predicates run in: one after the other.
template <class W>
concept Filtered = std::same_as<W, Bounded<double>> || std::same_as<W, Bounded<Extended>> ||
    std::same_as<W, Bounded<DoubleDouble>> || std::same_as<W, Exact>;

/// x - y of two doubles.
template <Filtered W>
  requires(!Arithmetic<W>)
W difference(double x, double y) {
  return W::difference(x, y);
}

}  // namespace isect
