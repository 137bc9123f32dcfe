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
// Underflow: a product errs by at most 2^-1075 more, which is below u tiny, tiny = 2^-1000. Overflow makes the
// size infinite, and nothing certain. The size's own roundings, two for each of the value's, and those of the last
// comparison are paid by one more u: (k + 1) u >= g(k) (1 - u)^-2k (1 + u)^3 for k < 2^20.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "core/filter.h"

namespace isect {

template <std::floating_point T>
class Bounded {
 public:
  Bounded() = default;
  Bounded(double x) : value_(x), size_(std::abs(value_)) {}

  static Bounded difference(double x, double y) {
    const T value = T(x) - T(y);
    return {value, std::abs(value), 1};
  }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value_ + b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value_ - b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    constexpr T tiny = 0x1p-1000;
    return {a.value_ * b.value_, a.size_ * b.size_ + tiny, a.roundings_ + b.roundings_ + 1};
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value_, a.size_, a.roundings_}; }
  friend Bounded abs(const Bounded& a) { return {std::abs(a.value_), a.size_, a.roundings_}; }

  /// 1, 0, -1, or nothing where the error could turn it.
  std::optional<int> sign() const {
    if (std::abs(value_) > error()) return value_ > 0 ? 1 : -1;  // false for NaN
    if (size_ == 0) return 0;                                    // nothing but zeros was summed
    return {};
  }
  /// Whether the value lies within a relative `tolerance` of the truth.
  bool within(double tolerance) const { return error() <= T(tolerance) * std::abs(value_); }

  T value() const { return value_; }
  /// |value - truth| <= error(); infinite or NaN where nothing is known.
  T error() const { return static_cast<T>((roundings_ + 1) * unit<T>) * size_; }

 private:
  Bounded(T value, T size, int roundings) : value_(value), size_(size), roundings_(roundings) {}

  T value_ = 0, size_ = 0;
  int roundings_ = 0;
};

/// What the polynomial texts of predicates run in: one of these, then Exact.
template <class W>
concept Filtered = std::same_as<W, Bounded<double>> || std::same_as<W, Bounded<long double>> || std::same_as<W, Exact>;

/// x - y of two doubles.
template <Filtered W>
  requires(!Arithmetic<W>)
W difference(double x, double y) {
  return W::difference(x, y);
}

}  // namespace isect
