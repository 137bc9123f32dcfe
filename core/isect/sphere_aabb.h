#pragma once
// Sphere against axis-aligned box.
//
// The box's point nearest to the center is the center itself, clamped to the box's interval on every axis; the
// farthest is a corner. The ball meets the box iff it holds the nearest point, and contains the box iff it holds the
// farthest one: squared distances against r^2, no square root. The box contains the ball iff on every axis both ends
// are at least r away from the center.
//
// Source: the note, N15; Arvo, A simple method for box-sphere intersection testing, Graphics Gems (1990).

#include <algorithm>
#include <limits>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/squares.h>
#include <isect/point_sphere.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_aabb {

/// The note's method: one axis; `gap` is 0 where the center lies between lo and hi, `distance2` the sum so far.
template <class S>
struct Axis {
  int axis;
  S center;
  Interval<S> interval;
  S gap, distance2;
};
/// The note's method: the comparison.
template <class S>
struct Compared {
  S distance2, radius2;
};
/// relate: the signs of nearest^2 - r^2 and farthest^2 - r^2, and whether the box contains the ball.
struct Decision {
  int nearest, farthest;
  bool ball_inside;
};
template <class S>
using Event = std::variant<Axis<S>, Compared<S>, Decision, Fallback>;

/// The point of the box nearest to the center. Exact; the box is not empty, and all is finite.
template <int N>
Point<double, N> nearest(const Point<double, N>& center, const Aabb<double, N>& box) {
  return center.cwiseMax(box.lo).cwiseMin(box.hi);
}

namespace detail {

/// The corner farthest from the center.
template <int N, class Trace>
Point<double, N> farthest(const Point<double, N>& center, const Aabb<double, N>& box, Trace&& trace) {
  Point<double, N> corner;
  for (int i = 0; i < N; ++i) {
    const double c = center[i], lo = box.lo[i], hi = box.hi[i];
    const int side = sign_of([&]<class W>() -> W { return difference<W>(c, lo) - difference<W>(hi, c); }, trace);
    corner[i] = side > 0 ? lo : hi;
  }
  return corner;
}

/// The sign of nearest^2 - r^2 where doubles do not settle it; 1 for what is empty or not finite.
template <class S, int N, class Trace>
[[gnu::noinline]] int sign_of_gap(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace) {
  if (empty(sphere) || empty(box) || !finite(sphere) || !finite(box)) return 1;
  const Sphere<double, N> ball = cast<double>(sphere);
  return point_sphere::detail::sign_of_gap<double, N>(nearest<N>(ball.center, cast<double>(box)), ball, trace);
}

/// The sign of farthest^2 - r^2. Rounding keeps order: the truly larger one of c - lo and hi - c is the larger one as
/// computed, too, or both come out equal.
template <int N, class Trace>
int contained(const Aabb<double, N>& box, const Sphere<double, N>& ball, Trace&& trace) {
  const Vector<double, N> f = (ball.center - box.lo).cwiseMax(box.hi - ball.center);
  return order_of_squares(f.squaredNorm(), ball.radius * ball.radius, [&] {
    return point_sphere::detail::sign_of_gap<double, N>(farthest<N>(ball.center, box, trace), ball, trace);
  });
}

/// Whether r <= c - lo and r <= hi - c on every axis.
template <int N, class Trace>
bool contained(const Sphere<double, N>& ball, const Aabb<double, N>& box, Trace&& trace) {
  const auto clear = [&](double x, double y) {
    return sign_of([&]<class W>() -> W { return difference<W>(x, y) - W(ball.radius); }, trace) >= 0;
  };
  for (int i = 0; i < N; ++i)
    if (!clear(ball.center[i], box.lo[i]) || !clear(box.hi[i], ball.center[i])) return false;
  return true;
}

}  // namespace detail

}  // namespace sphere_aabb

/// Whether the ball and the box have a common point. Exact; an empty one, NaN or an infinite coordinate: no.
///
/// No branch depends on the answer. A sum of widths that is NaN or infinite gives away a box with such a
/// coordinate, or one so large that the sum overflows; NaN and infinities in the ball leave the squares unordered.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace = {}) {
  const Vector<S, N> gap = sphere.center - sphere.center.cwiseMax(box.lo).cwiseMin(box.hi);
  const Vector<S, N> widths = box.hi - box.lo;
  const S distance2 = gap.squaredNorm(), radius2 = sphere.radius * sphere.radius;

  const bool plain = ordered(distance2, radius2) & (widths.sum() <= std::numeric_limits<S>::max());
  if (!plain) [[unlikely]]
    return sphere_aabb::detail::sign_of_gap(sphere, box, trace) <= 0;
  return (distance2 < radius2) & (std::min(widths.minCoeff(), sphere.radius) >= 0);  // neither is empty
}

/// How the ball and the box lie, the ball being a. Exact, for a flat box too; a ball of radius 0 is a point. An empty
/// one, NaN or an infinite coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (empty(sphere) || empty(box) || !finite(sphere) || !finite(box)) return Relation::disjoint;
  const Sphere<double, N> ball = cast<double>(sphere);
  const Aabb<double, N> wide_box = cast<double>(box);

  const Vector<double, N> f = ball.center - sphere_aabb::nearest<N>(ball.center, wide_box);
  const int nearest = order_of_squares(f.squaredNorm(), ball.radius * ball.radius,
                                       [&] { return sphere_aabb::detail::sign_of_gap(sphere, box, trace); });
  const int farthest = nearest > 0 ? 1 : sphere_aabb::detail::contained<N>(wide_box, ball, trace);
  const bool ball_inside = nearest <= 0 && sphere_aabb::detail::contained<N>(ball, wide_box, trace);
  if constexpr (heard<Trace>) trace(sphere_aabb::Decision{nearest, farthest, ball_inside});

  if (nearest > 0) return Relation::disjoint;
  if (ball_inside) return farthest <= 0 ? Relation::equal : Relation::a_inside_b;  // both: the same single point
  if (farthest <= 0) return Relation::b_inside_a;
  return nearest == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
