#pragma once
// The grid that a number lies on, so that a number that is exactly zero is known to be zero.
//
// Every double is a whole multiple of a power of two, that of its last bit which is not 0. Sums of multiples of g are
// multiples of g, and products of multiples of g and h are multiples of g h. So each polynomial has a grid g of its
// own, a coarse one where its arguments are integers, halves or short fractions. Where |value| + error < g, the truth,
// being a multiple of g, is 0.
//
// In doubles that is where nothing was rounded: shapes that touch on integers cost little more than others. In
// Compensated it is so up to some 100 bits, which products of two differences of like doubles nearly have.
//
// 0 is a multiple of anything: its grid is taken as a large power. A grid that underflows is 0, and then no zero is
// certain. One that overflows is infinite; then so is the size of the number, unless that is 0.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <isect/conventions.h>

namespace isect {

/// A number's grid: a power of two, or 0 where none is known. It runs in a polynomial's text in place of the number.
class Grid {
 public:
  Grid() = default;
  /// The grid of x itself: its last bit if that is normal, else 0. Without a branch, as whether a coordinate is 0 is
  /// hard to predict.
  ISECT_INLINE Grid(double x) : step_(std::bit_cast<double>(bits_of(x))) {}

  ISECT_INLINE static Grid difference(double x, double y) {
    const std::int64_t none = mask_of_zero(x - y), finer = std::min(bits_of(x), bits_of(y));
    return Grid(std::bit_cast<double>((finer & ~none) | (coarse & none)), nullptr);
  }

  ISECT_INLINE friend Grid operator+(const Grid& a, const Grid& b) { return Grid(std::min(a.step_, b.step_), nullptr); }
  ISECT_INLINE friend Grid operator-(const Grid& a, const Grid& b) { return a + b; }
  ISECT_INLINE friend Grid operator*(const Grid& a, const Grid& b) { return Grid(a.step_ * b.step_, nullptr); }
  ISECT_INLINE friend Grid operator-(const Grid& a) { return a; }
  ISECT_INLINE friend Grid abs(const Grid& a) { return a; }

  /// NaN where a number of unknown grid was multiplied by one of infinite grid.
  double step() const { return step_; }

 private:
  static constexpr std::int64_t coarse = std::bit_cast<std::int64_t>(0x1p256);

  ISECT_INLINE Grid(double step, std::nullptr_t) : step_(step) {}

  /// All ones if x is 0, else 0.
  ISECT_INLINE static std::int64_t mask_of_zero(double x) {
    return -static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) << 1 == 0);
  }
  ISECT_INLINE static std::int64_t bits_of(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x), hidden = std::uint64_t{1} << 52;
    const std::int64_t exponent = static_cast<std::int64_t>(bits & std::uint64_t{0x7ff} << 52);
    const std::int64_t step = exponent - (static_cast<std::int64_t>(52 - std::countr_zero(bits | hidden)) << 52);
    return (step & ~(step >> 63)) | (mask_of_zero(x) & coarse);
  }

  double step_ = std::bit_cast<double>(coarse);
};

}  // namespace isect
