#include "app/scene/along_capsule.h"

#include <algorithm>
#include <optional>

#include <isect/numbers/exact.h>
#include <isect/numbers/predicate.h>
#include <isect/parts/ray_range.h>

namespace isect::program::scene {

namespace {

using Exact3 = Components<Exact, 3>;

/// The sign of x + y sqrt(square), square >= 0.
int sign_with_root(const Exact& x, const Exact& y, const Exact& square) {
  const int a = x.sign(), b = y.sign() * square.sign();
  if (a * b >= 0) return a != 0 ? a : b;
  return a * (x * x - y * y * square).sign();
}

/// The roots of a t^2 + 2 b t + c, a > 0, and the numbers that they are made of: (-b -+ sqrt(discriminant)) / a.
struct Roots {
  Exact a, b, discriminant;
  Interval<double> values;  ///< the nearest doubles, but for a relative 2^-100
};

/// Nothing where there are none. The root that would cancel is found from the other one.
std::optional<Roots> roots(const Exact& a, const Exact& b, const Exact& c) {
  const Exact discriminant = b * b - a * c;
  if (a.sign() == 0 || discriminant.sign() < 0) return {};
  const Exact root = sqrt(discriminant), q = b.sign() < 0 ? root - b : -(root + b);
  const double t = near_quotient(q, a), other = q.sign() == 0 ? t : near_quotient(c, q);
  return Roots{a, b, discriminant, {std::min(t, other), std::max(t, other)}};
}

std::optional<Roots> roots(const Exact3& from_center, const Exact3& direction, const Exact& r2) {
  return roots(dot(direction, direction), dot(from_center, direction), dot(from_center, from_center) - r2);
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
    for (const Exact3& f : {f_, from_q})
      if (const auto ball = roots(f, d_, r2_)) take_first(ball->values.lo), take_last(ball->values.hi);
    const Exact3 e = cross(d_, v_), g = cross(f_, v_);
    const auto round = roots(dot(e, e), dot(e, g), dot(g, g) - r2_ * dot(v_, v_));
    if (round && beside_axis(*round, -1)) take_first(round->values.lo);
    if (round && beside_axis(*round, 1)) take_last(round->values.hi);
  }

  Interval<double> within(const Interval<double>& range) const {
    const double lo = ray_range::clamped(first_.value_or(range.lo), range);
    return {lo, std::max(lo, ray_range::clamped(last_.value_or(range.hi), range))};
  }

 private:
  void take_first(double t) { first_ = std::min(t, first_.value_or(t)); }
  void take_last(double t) { last_ = std::max(t, last_.value_or(t)); }
  /// Whether the line's point at the lower (-1) or the upper (1) root lies between the ends of the axis, in its
  /// direction.
  bool beside_axis(const Roots& at, int side) const {
    const Exact rate = dot(d_, v_), along = dot(f_, v_) * at.a - rate * at.b, turn = side < 0 ? -rate : rate;
    return sign_with_root(along, turn, at.discriminant) >= 0 &&
           sign_with_root(along - dot(v_, v_) * at.a, turn, at.discriminant) <= 0;
  }

  Exact3 d_, v_, f_;
  Exact r2_;
  std::optional<double> first_, last_;
};

}  // namespace

Interval<double> part_in(const Ray<double, 3>& ray, const Capsule<double, 3>& capsule) {
  return Through(ray.origin, exactly<Exact>(ray.direction), capsule).within(ray.range);
}

Interval<double> part_in(const Segment<double, 3>& segment, const Capsule<double, 3>& capsule) {
  return Through(segment.p, difference<Exact>(segment.q, segment.p), capsule).within({0, 1});
}

LineAndBall line_and_ball(const Segment<double, 3>& segment, const Sphere<double, 3>& ball) {
  const Exact r = ball.radius;
  const auto found = roots(difference<Exact>(segment.p, ball.center), difference<Exact>(segment.q, segment.p), r * r);
  if (!found) return {};
  return {found->discriminant.sign() == 0 ? 1 : 2, found->values};
}

}  // namespace isect::program::scene
