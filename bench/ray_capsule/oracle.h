#pragma once
// Which part of a line lies in a capsule, in rationals: no quadratic and no root. The distance of a point of the line
// from the axis is compared with r by the point's projection onto the axis; it falls to its least and rises then, so
// that whether the line has entered by a given t is told by that t and by where it is nearest.

#include <bit>
#include <cstdint>

#include "bench/sphere_capsule/oracle.h"

namespace isect::oracle {

/// A line, which has a direction, and a capsule.
template <int N>
class LineInCapsule {
 public:
  LineInCapsule(const Coordinates<N>& origin, const Coordinates<N>& direction, const Stretch<N>& axis,
                const Rational& radius)
      : o_(origin), d_(direction), axis_(axis), r_(radius) {
    const Rational dd = dot(d_, d_);
    std::vector<Rational> candidates = {dot(axis.p - o_, d_) / dd, dot(axis.at(1) - o_, d_) / dd};
    const Coordinates<N> w = axis.p - o_;
    const Rational dv = dot(d_, axis.d), vv = dot(axis.d, axis.d), determinant = dd * vv - dv * dv;
    if (determinant != 0) candidates.push_back((dot(w, d_) * vv - dv * dot(w, axis.d)) / determinant);
    nearest_ = candidates.front();
    for (const Rational& t : candidates)
      if (distance2(t) < distance2(nearest_)) nearest_ = t;
  }

  bool holds(const Rational& t) const { return at_most(distance2(t), r_); }
  bool meets() const { return holds(nearest_); }
  /// Whether it enters at t or before; and whether it leaves at t or after. It meets the capsule.
  bool entered(const Rational& t) const { return t >= nearest_ || holds(t); }
  bool stays(const Rational& t) const { return t <= nearest_ || holds(t); }

  /// Whether it meets the capsule in a range, which has points and may be infinite.
  bool meets(const Interval<double>& range) const {
    if (!meets()) return false;
    return (std::isinf(range.hi) || entered(Rational(range.hi))) && (std::isinf(range.lo) || stays(Rational(range.lo)));
  }

  /// Where it enters, or leaves, to the nearest double; infinite beyond the largest.
  double passes_at(bool leaves) const {
    const auto past = [&](const Rational& t) { return leaves ? !stays(t) : entered(t); };
    // The least double that is past it, by halving what is left of all doubles, in their order
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

  /// Whether x is within `k` units in the last place of S, on its own side, of where the line enters, or leaves. One
  /// more where x is subnormal.
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
  Rational distance2(const Rational& t) const { return oracle::distance2<N>(o_ + t * d_, axis_); }

  Coordinates<N> o_, d_;
  Stretch<N> axis_;
  Rational r_, nearest_;
};

template <class S, int N>
LineInCapsule<N> line_in_capsule(const Ray<S, N>& ray, const Capsule<S, N>& capsule) {
  return {rational(ray.origin), rational(ray.direction), stretch(capsule), Rational(capsule.radius)};
}
/// Of a segment with both ends as given.
template <class S, int N>
LineInCapsule<N> line_in_capsule(const Segment<S, N>& segment, const Capsule<S, N>& capsule) {
  return {rational(segment.p), rational(segment.q) - rational(segment.p), stretch(capsule), Rational(capsule.radius)};
}

}  // namespace isect::oracle
