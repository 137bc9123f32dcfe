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
//   a b                value              size a size b        sum + 1         (tiny, where that is less)
//
// Underflow: a product errs by at most 2^-1075 more in double, which is below 2^-62 u tiny: what a product of size tiny
// or more has to spare. In DoubleDouble and Compensated it is 2^-1072, below u^2 tiny, which is added. tiny is so large
// that no error is subnormal, which would take the machine ten times as long. Overflow makes the size infinite or the
// value NaN, and nothing certain. But no size is NaN, which std::max would pass over: only 0 has the size 0, so an
// infinite size times that is the size of 0.
//
// The size's own roundings, two for each of the value's, and those of the last comparison are paid by one more u:
// (k + 1) u >= g(k) (1 - u)^-2k (1 + u)^4 for k < 2^20.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>

#include <isect/numbers/arithmetic.h>
#include <isect/numbers/short_exact.h>

namespace isect {

namespace detail {
/// Raises a product of sizes to tiny at least; to tiny where it is NaN, infinity times 0.
ISECT_INLINE double at_least_tiny(double size) { return std::max(0x1p-960, size); }
}  // namespace detail

/// A value with an error bound. T is double or DoubleDouble; or Compensated or TripleDouble, for one found elsewhere.
template <class T>
class Bounded {
 public:
  Bounded() = default;
  Bounded(double x) : value_{x}, size_(std::abs(x)) {}
  /// A number found elsewhere: a sum of products, each of `roundings` roundings at most, whose sizes add up to `size`
  /// at most. At least 2^-960 of that makes up for products that underflow.
  Bounded(const T& value, double size, int roundings) : value_(value), size_(size), roundings_(roundings) {}

  ISECT_INLINE static Bounded difference(double x, double y) {
    const T value = isect::difference<T>(x, y);
    return {value, std::abs(leading(value)), 1};
  }

  ISECT_INLINE friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value_ + b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  ISECT_INLINE friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value_ - b.value_, a.size_ + b.size_, std::max(a.roundings_, b.roundings_) + 1};
  }
  ISECT_INLINE friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return {a.value_ * b.value_, size_of_product(a.size_, b.size_), a.roundings_ + b.roundings_ + 1};
  }
  ISECT_INLINE friend Bounded operator-(const Bounded& a) { return {-a.value_, a.size_, a.roundings_}; }
  ISECT_INLINE friend Bounded abs(const Bounded& a) { return leading(a.value_) < 0 ? -a : a; }

  /// Whether the value has the sign of the truth. False where it overflowed, as inf - inf is NaN. An error that
  /// underflows is no error: without products all are multiples of the least double.
  ISECT_INLINE bool certain() const { return std::abs(leading(value_)) - error() >= 0; }
  /// The sign of the value, whether or not the truth has it.
  ISECT_INLINE int apparent_sign() const { return (leading(value_) > 0) - (leading(value_) < 0); }
  /// The sign of the truth: 1, 0, -1, or nothing where the error could turn it.
  std::optional<int> sign() const { return certain() ? std::optional(apparent_sign()) : std::nullopt; }
  /// Whether the value lies within a relative `tolerance` of the truth.
  ISECT_INLINE bool within(double tolerance) const { return tolerance * std::abs(leading(value_)) - error() >= 0; }

  const T& value() const { return value_; }
  double size() const { return size_; }
  int roundings() const { return roundings_; }
  /// |value - truth| <= error(), if the value is finite; infinite where nothing is known.
  ISECT_INLINE double error() const {
    const double k = roundings_ + 1;
    constexpr double u = unit<double>;
    if constexpr (std::is_same_v<T, TripleDouble>)
      return 8 * (k * k * k) * (u * u * u) * size_;
    else
      return is_compensated<T> ? 2 * k * k * u * u * size_ : k * unit<T> * size_;
  }

 private:
  /// In DoubleDouble a product with 0 has size 0: else no sum of zeros would be certain. In double the test for 0 would
  /// cost more than it saves.
  static double size_of_product(double a, double b) {
    if constexpr (std::is_same_v<T, DoubleDouble>)
      return a == 0 || b == 0 ? 0 : a * b + 0x1p-960;
    else
      return detail::at_least_tiny(a * b);
  }

  T value_ = {};
  double size_ = 0;
  int roundings_ = 0;
};

/// x.y, its size found from the largest sizes alone: that costs half as much as the sum of all products' sizes.
template <std::size_t N>
ISECT_INLINE Bounded<double> dot(const std::array<Bounded<double>, N>& x, const std::array<Bounded<double>, N>& y) {
  double sum = x[0].value() * y[0].value(), largest_x = x[0].size(), largest_y = y[0].size();
  int roundings = x[0].roundings() + y[0].roundings();
  for (std::size_t i = 1; i < N; ++i) {
    sum += x[i].value() * y[i].value();
    largest_x = std::max(largest_x, x[i].size()), largest_y = std::max(largest_y, y[i].size());
    roundings = std::max(roundings, x[i].roundings() + y[i].roundings());
  }
  return {sum, detail::at_least_tiny(N * (largest_x * largest_y)), roundings + static_cast<int>(N)};
}

/// The cross product of x and y, its sizes found likewise.
ISECT_INLINE std::array<Bounded<double>, 3> cross(const std::array<Bounded<double>, 3>& x,
                                                  const std::array<Bounded<double>, 3>& y) {
  const double largest_x = std::max(std::max(x[0].size(), x[1].size()), x[2].size()),
               largest_y = std::max(std::max(y[0].size(), y[1].size()), y[2].size());
  const double size = detail::at_least_tiny(2 * (largest_x * largest_y));
  const int roundings = std::max(std::max(x[0].roundings(), x[1].roundings()), x[2].roundings()) +
                        std::max(std::max(y[0].roundings(), y[1].roundings()), y[2].roundings()) + 2;
  const auto minor = [&](int i, int j) -> Bounded<double> {
    return {x[i].value() * y[j].value() - x[j].value() * y[i].value(), size, roundings};
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

class Grid;
class Recorded;

/// The arithmetics that the polynomial texts of predicates run in, one after the other.
template <class W>
concept PolynomialScalar = std::same_as<W, Bounded<double>> || std::same_as<W, Grid> || std::same_as<W, Recorded> ||
    is_compensated<W> || std::same_as<W, TripleDouble> || std::same_as<W, Bounded<DoubleDouble>> ||
    std::same_as<W, ShortExact> || std::same_as<W, MediumExact> || std::same_as<W, Exact>;

}  // namespace isect
