#pragma once
// Which part of a line lies in a convex set, in rationals: no quadratic and no root. Whether the line has entered by a
// given t follows from that t and from one at which it is inside.

#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "bench/rational.h"

namespace isect::oracle {

/// A line with a direction: whether it is inside at t, and some t at which it is inside, if there is one.
class LineInConvex {
 public:
  LineInConvex(std::function<bool(const Rational&)> holds, std::optional<Rational> inside)
      : holds_(std::move(holds)), inside_(std::move(inside)) {}

  bool holds(const Rational& t) const { return holds_(t); }
  bool meets() const { return inside_.has_value(); }
  /// Whether it enters at t or before, and whether it leaves at t or after. The line must meet the set.
  bool entered(const Rational& t) const { return t >= *inside_ || holds(t); }
  bool stays(const Rational& t) const { return t <= *inside_ || holds(t); }

  /// Whether it meets the set in a range, which has points and may be infinite.
  bool meets(const Interval<double>& range) const {
    if (!meets()) return false;
    return (std::isinf(range.hi) || entered(Rational(range.hi))) && (std::isinf(range.lo) || stays(Rational(range.lo)));
  }

  /// The double nearest to where it enters or leaves; infinite beyond the largest.
  double passes_at(bool leaves) const {
    const auto past = [&](const Rational& t) { return leaves ? !stays(t) : entered(t); };
    // The least double that is past it, by bisection over all doubles in their order
    const auto ordinal = [](double x) {
      const std::int64_t bits = std::bit_cast<std::int64_t>(x);
      return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
    };
    const auto number = [](std::int64_t i) {
      return std::bit_cast<double>(i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i);
    };
    constexpr double most = std::numeric_limits<double>::max(), inf = std::numeric_limits<double>::infinity();
    if (past(Rational(-most))) return -inf;
    if (!past(Rational(most))) return inf;
    std::int64_t lo = ordinal(-most), hi = ordinal(most);
    while (hi - 1 > lo) {
      const std::int64_t middle = lo / 2 + hi / 2 + (lo % 2 + hi % 2) / 2;
      (past(Rational(number(middle))) ? hi : lo) = middle;
    }
    const double below = number(lo), above = number(hi);
    return past(Rational((Rational(below) + Rational(above)) / 2)) ? below : above;
  }

  /// Whether x is within `k` units in the last place of S, on its own side, of where the line enters or leaves; within
  /// one unit more where x is subnormal.
  template <class S>
  bool is_within(S x, bool leaves, double k) const {
    using Limits = std::numeric_limits<S>;
    const auto past = [&](const Rational& t) { return leaves ? !stays(t) : entered(t); };
    if (std::isnan(x)) return false;
    if (std::isinf(x)) return x > 0 ? !past(Rational(Limits::max())) : past(Rational(-Limits::max()));
    if (std::abs(x) < Limits::min()) k += 1;
    const auto step = [&](S towards) {
      const S next = std::nextafter(x, towards);
      return std::isinf(next) ? Rational(std::nextafter(x, -towards)) - Rational(x) : Rational(x) - Rational(next);
    };
    const Rational less = abs(Rational(step(-Limits::infinity()))), more = abs(Rational(step(Limits::infinity())));
    return !past(Rational(Rational(x) - Rational(k) * less)) && past(Rational(Rational(x) + Rational(k) * more));
  }

 private:
  std::function<bool(const Rational&)> holds_;
  std::optional<Rational> inside_;
};

}  // namespace isect::oracle
