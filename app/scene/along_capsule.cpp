#include "app/scene/along_capsule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <isect/numbers/exact.h>
#include <isect/numbers/predicate.h>

namespace isect::program::scene {

namespace {

using Exact3 = Components<Exact, 3>;
using Part = std::optional<Interval<double>>;

/// Where a t^2 + 2 b t + c <= 0, a >= 0. The root that would cancel is found from the other one.
Part between_roots(const Exact& a, const Exact& b, const Exact& c) {
  const Exact discriminant = b * b - a * c;
  if (a.sign() == 0 || discriminant.sign() < 0) return {};
  const double q = -(b.rounded() + std::copysign(std::sqrt(discriminant.rounded()), b.rounded()));
  const double t = q / a.rounded(), other = q == 0 ? t : c.rounded() / q;
  return Interval<double>{std::min(t, other), std::max(t, other)};
}

/// A capsule is the ball around p, the ball around q, and what of a cylinder lies between them.
class Through {
 public:
  Through(const Point<double, 3>& origin, const Exact3& direction, const Capsule<double, 3>& capsule)
      : d_(direction),
        v_(difference<Exact>(capsule.q, capsule.p)),
        f_(difference<Exact>(origin, capsule.p)),
        r2_(Exact(capsule.radius) * Exact(capsule.radius)) {
    const Exact3 from_q = difference<Exact>(origin, capsule.q);
    for (const Exact3& f : {f_, from_q}) take(between_roots(dot(d_, d_), dot(f, d_), dot(f, f) - r2_));
    const Exact3 e = cross(d_, v_), g = cross(f_, v_);
    const Part round = between_roots(dot(e, e), dot(e, g), dot(g, g) - r2_ * dot(v_, v_));
    if (!round) return;
    if (beside_axis(round->lo) || !part_) lo_ = round->lo;
    if (beside_axis(round->hi) || !part_) hi_ = round->hi;
  }

  Interval<double> within(const Interval<double>& range) const {
    Interval<double> part = part_.value_or(infinite<double>);
    if (lo_) part.lo = *lo_;
    if (hi_) part.hi = *hi_;
    part = {std::max(part.lo, range.lo), std::min(part.hi, range.hi)};
    return {part.lo, std::max(part.lo, part.hi)};
  }

 private:
  void take(const Part& ball) {
    if (!ball) return;
    if (!part_) part_ = ball;
    part_->lo = std::min(part_->lo, ball->lo), part_->hi = std::max(part_->hi, ball->hi);
  }
  /// Whether the line's point at t lies between the ends of the axis, in its direction.
  bool beside_axis(double t) const {
    if (!std::isfinite(t)) return false;
    const Exact along = dot(f_, v_) + Exact(t) * dot(d_, v_);
    return along.sign() >= 0 && (along - dot(v_, v_)).sign() <= 0;
  }

  Exact3 d_, v_, f_;
  Exact r2_;
  Part part_;                      ///< of both balls
  std::optional<double> lo_, hi_;  ///< of the cylinder, where it is entered and left beside the axis
};

}  // namespace

Interval<double> part_in(const Ray<double, 3>& ray, const Capsule<double, 3>& capsule) {
  return Through(ray.origin, exactly<Exact>(ray.direction), capsule).within(ray.range);
}

Interval<double> part_in(const Segment<double, 3>& segment, const Capsule<double, 3>& capsule) {
  return Through(segment.p, difference<Exact>(segment.q, segment.p), capsule).within({0, 1});
}

}  // namespace isect::program::scene
