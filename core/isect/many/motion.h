#pragma once
// Moving objects: at discrete times, in between, and exactly.
//
// Testing a scene time after time misses what happens in between: a bullet is before the wall at one time and behind
// it at the next. It tunnels. A remedy that never misses tests the volumes which the objects sweep: too large ones,
// so that the answer is "perhaps". The exact remedy lets one object stand still and the other move with the
// difference w of the velocities. Then the motion is a ray, and the still object has grown by the moving one:
//
//   boxes     a.lo - b.hi <= t w <= a.hi - b.lo  on every axis: a ray against the slabs of a box,
//   balls     |f + t w| <= r + s,  f = b - a:    a ray against a sphere.
//
// The grown box and ball are never computed, as they would be rounded: all verdicts are signs of polynomials in the
// arguments. Source: the note, N25 (discrete times), N16 (rays as stand-ins for moving objects); Ericson, Real-Time
// Collision Detection (2005), 5.5.

#include <optional>
#include <variant>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/parts/slabs.h>
#include <isect/sphere_sphere.h>

namespace isect {

/// A shape that is at shape + t velocity at the time t.
template <template <class, int> class Shape, class S, int N>
struct Moving {
  Shape<S, N> shape;
  Vector<S, N> velocity;
};

namespace motion {

/// discrete_hits: whether the shapes met at this time.
template <class S>
struct At {
  S time;
  bool meet;
};
/// may_collide: the boxes that hold all that the shapes sweep.
template <class S, int N>
struct Swept {
  Aabb<S, N> a, b;
};
/// first_contact of balls: the signs of distance - reach at the times 0 and `duration`, of the change of the distance
/// at these times, and of the discriminant: of reach - least distance, over all time.
struct Approach {
  int apart, apart_at_end, receding, receding_at_end, discriminant;
};
template <class S, int N>
using Event = std::variant<At<S>, Swept<S, N>, slabs::Outside, slabs::Stretch, Approach, Fallback>;

/// The shape moved by a vector, each coordinate rounded.
template <class S, int N>
Aabb<S, N> moved(const Aabb<S, N>& box, const Vector<S, N>& by) {
  return {box.lo + by, box.hi + by};
}
template <class S, int N>
Sphere<S, N> moved(const Sphere<S, N>& ball, const Vector<S, N>& by) {
  return {ball.center + by, ball.radius};
}

namespace detail {

/// The largest S that is not above x + y. The rounding error of a sum is a double; NaN where it overflows.
template <class S>
S sum_below(S x, S y) {
  const DoubleDouble sum = two_sum(double(x), double(y));
  const S below = static_cast<S>(sum.hi);
  const bool fits = below < sum.hi || (below == sum.hi && sum.lo >= 0);
  return fits ? below : std::nextafter(below, -std::numeric_limits<S>::infinity());
}
/// The least S that is not below x + y.
template <class S>
S sum_above(S x, S y) {
  return -sum_below(-x, -y);
}

/// The box that holds the ball.
template <class S, int N>
Aabb<S, N> bounds(const Sphere<S, N>& ball) {
  Aabb<S, N> box;
  for (int i = 0; i < N; ++i) {
    box.lo[i] = sum_below(ball.center[i], -ball.radius);
    box.hi[i] = sum_above(ball.center[i], ball.radius);
  }
  return box;
}
template <class S, int N>
const Aabb<S, N>& bounds(const Aabb<S, N>& box) {
  return box;
}

/// velocity * duration, one number further than the nearest in each component: at least as far as the true one.
template <class S, int N>
Vector<S, N> displacement(const Vector<S, N>& velocity, S duration) {
  Vector<S, N> d = Vector<S, N>::Zero();
  for (int i = 0; i < N; ++i)
    if (velocity[i] != 0 && duration != 0)
      d[i] = std::nextafter(velocity[i] * duration, std::copysign(std::numeric_limits<S>::infinity(), velocity[i]));
  return d;
}

template <template <class, int> class Shape, class S, int N>
bool moves(const Moving<Shape, S, N>& a) {
  return !empty(a.shape) && finite(a.shape) && finite(a.velocity);
}

}  // namespace detail

}  // namespace motion

/// A box that holds the box in every place of its way along the displacement: lo and hi rounded outwards, by one
/// number at most. It may be infinite; then it is beyond S.
template <class S, int N>
Aabb<S, N> swept_aabb(const Aabb<S, N>& box, const Vector<S, N>& displacement) {
  Aabb<S, N> swept = box;
  for (int i = 0; i < N; ++i)
    (displacement[i] < 0 ? swept.lo : swept.hi)[i] = displacement[i] < 0
                                                         ? motion::detail::sum_below(box.lo[i], displacement[i])
                                                         : motion::detail::sum_above(box.hi[i], displacement[i]);
  return swept;
}

/// Whether the shapes may meet at some time from 0 to duration. Never no if they do. No for a shape that is empty,
/// NaN or infinite, and for a duration < 0 or NaN.
template <template <class, int> class Shape, class S, int N, class Trace = NoTrace>
bool may_collide(const Moving<Shape, S, N>& a, const Moving<Shape, S, N>& b, S duration, Trace&& trace = {}) {
  if (!motion::detail::moves(a) || !motion::detail::moves(b) || !(duration >= 0)) return false;
  const Aabb<S, N> swept_a =
      swept_aabb(motion::detail::bounds(a.shape), motion::detail::displacement(a.velocity, duration));
  const Aabb<S, N> swept_b =
      swept_aabb(motion::detail::bounds(b.shape), motion::detail::displacement(b.velocity, duration));
  trace(motion::Swept<S, N>{swept_a, swept_b});

  return !empty(aabb_aabb::common(swept_a, swept_b));  // ends at infinity compare rightly
}

namespace motion {

namespace detail {

/// The box a, grown by the box b, seen from b: lo <= w t <= hi.
template <int N>
struct Slabs {
  const Moving<Aabb, double, N>&a, &b;

  // clang-format off
  template <PolynomialScalar W> W rate(int i) const { return difference<W>(b.velocity[i], a.velocity[i]); }
  template <PolynomialScalar W> W lo(int i) const { return difference<W>(a.shape.lo[i], b.shape.hi[i]); }
  template <PolynomialScalar W> W hi(int i) const { return difference<W>(a.shape.hi[i], b.shape.lo[i]); }
  // clang-format on
};

/// The ball b, seen from a. Its squared distance less reach^2 at the time t is A t^2 + 2 B t + C.
template <int N>
struct Flight {
  const Moving<Sphere, double, N>&a, &b;

  template <PolynomialScalar W>
  Components<W, N> way() const {
    return difference<W>(b.velocity, a.velocity);
  }
  /// C(t) = |f + t w|^2 - (r + s)^2
  template <PolynomialScalar W>
  W apart(double t) const {
    const Components<W, N> f = at<W>(t);
    const W reach = W(a.shape.radius) + W(b.shape.radius);
    return dot(f, f) - reach * reach;
  }
  /// B(t) = (f + t w) . w
  template <PolynomialScalar W>
  W receding(double t) const {
    return dot(at<W>(t), way<W>());
  }
  /// D = B^2 - A C
  template <PolynomialScalar W>
  W discriminant() const {
    const W b_ = receding<W>(0);
    return b_ * b_ - dot(way<W>(), way<W>()) * apart<W>(0);
  }

 private:
  template <PolynomialScalar W>
  Components<W, N> at(double t) const {
    Components<W, N> f = difference<W>(b.shape.center, a.shape.center);
    if (t == 0) return f;
    const Components<W, N> w = way<W>();
    for (int i = 0; i < N; ++i) f[i] = f[i] + W(t) * w[i];
    return f;
  }
};

template <template <class, int> class Shape, class S, int N>
Moving<Shape, double, N> wide(const Moving<Shape, S, N>& a) {
  return {cast<double>(a.shape), a.velocity.template cast<double>()};
}

/// Returns when balls meet that do so by the duration, where C / -B overflows. Half of that may not: it is at most t.
/// Infinite only where they have not met by the largest S.
template <class S, int N>
[[gnu::noinline, gnu::cold]] S late_contact(const Moving<Sphere, S, N>& a, const Moving<Sphere, S, N>& b, S duration,
                                            double root) {
  const Moving<Sphere, double, N> wide_a = wide(a), wide_b = wide(b);
  const Flight<N> flight = {wide_a, wide_b};
  const double time = value_of<double>([&]<class W>() -> Ratio<W> {
                        const W b_ = flight.template receding<W>(0);
                        return {flight.template apart<W>(0), -(b_ + b_)};
                      }) /
                      ((1 + root) / 2);
  const S rounded = std::min(static_cast<S>(time), duration);
  constexpr S most = std::numeric_limits<S>::max();
  return std::isinf(rounded) && first_contact(a, b, most) ? most : rounded;
}

}  // namespace detail

}  // namespace motion

/// The times from 0 to duration at which the boxes meet. Exact: whether there are any; the ends lie within 4 ulp of
/// the true ones. Touching in passing counts. The duration may be infinite. Nothing for a box that is empty, NaN or
/// infinite, a velocity that is not finite, a duration < 0 or NaN.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> contact(const Moving<Aabb, S, N>& a, const Moving<Aabb, S, N>& b, S duration,
                                   Trace&& trace = {}) {
  if (!motion::detail::moves(a) || !motion::detail::moves(b)) return {};
  const Moving<Aabb, double, N> wide_a = motion::detail::wide(a), wide_b = motion::detail::wide(b);
  return slabs::detail::clip<S, N>({S(0), duration}, motion::detail::Slabs<N>{wide_a, wide_b}, trace);
}

/// The first of these times.
template <class S, int N, class Trace = NoTrace>
std::optional<S> first_contact(const Moving<Aabb, S, N>& a, const Moving<Aabb, S, N>& b, S duration,
                               Trace&& trace = {}) {
  const std::optional<Interval<S>> times = contact(a, b, duration, trace);
  return times ? std::optional(times->lo) : std::nullopt;
}

/// The first time from 0 to duration at which the balls meet. Exact: whether there is one; the time lies within 8 ulp
/// of the true one, and a subnormal one within 8 subnormal units. Otherwise as for boxes.
///
/// Balls that are apart at first meet if they approach (B < 0), come near enough at some time (D >= 0), and by the
/// end are not apart any more, or have passed each other. Then t = (-B - sqrt D) / A, without cancellation (C / -B) /
/// (1 + sqrt(D / B^2)). The quotient errs by at most 4 u, the sum by 2.5 u, the division by u.
template <class S, int N, class Trace = NoTrace>
std::optional<S> first_contact(const Moving<Sphere, S, N>& a, const Moving<Sphere, S, N>& b, S duration,
                               Trace&& trace = {}) {
  if (!motion::detail::moves(a) || !motion::detail::moves(b) || !(duration >= 0)) return {};
  const Moving<Sphere, double, N> wide_a = motion::detail::wide(a), wide_b = motion::detail::wide(b);
  const motion::detail::Flight<N> flight = {wide_a, wide_b};
  const double end = double(duration);
  const auto apart = [&](double t) {
    return sign_of([&]<class W>() -> W { return flight.template apart<W>(t); }, trace);
  };
  const auto receding = [&](double t) {
    return sign_of([&]<class W>() -> W { return flight.template receding<W>(t); }, trace);
  };

  motion::Approach signs = {apart(0), 1, 0, 1, 0};
  if (signs.apart > 0) {
    signs.receding = receding(0);
    signs.discriminant = sign_of([&]<class W>() -> W { return flight.template discriminant<W>(); }, trace);
    if (std::isfinite(end)) signs.apart_at_end = apart(end), signs.receding_at_end = receding(end);
  }
  trace(signs);

  if (signs.apart <= 0) return S(0);
  if (signs.receding >= 0 || signs.discriminant < 0) return {};
  if (signs.apart_at_end > 0 && signs.receding_at_end < 0) return {};

  const auto pace = [&]<class W>() -> Ratio<W> {
    return {flight.template apart<W>(0), -flight.template receding<W>(0)};
  };
  const auto depth = [&]<class W>() -> Ratio<W> {
    const W b_ = flight.template receding<W>(0);
    return {flight.template discriminant<W>(), b_ * b_};
  };
  const double root = std::sqrt(value_of<double>(depth, trace));
  const S time = static_cast<S>(value_of<double>(pace, trace) / (1 + root));
  return std::isinf(time) ? motion::detail::late_contact(a, b, duration, root) : std::min(time, duration);
}

}  // namespace isect
