#pragma once
// Sphere against cylinder.
//
// Let f lead from p to the ball's center c, d = q - p, and h = f.d. The cylinder's point nearest to c is
//
//   c itself              where 0 <= h <= d.d and |f x d|^2 <= r^2 d.d,
//   beside it, |f x d| / |d| - r away          where only the latter does not hold,
//   in an end, |h| / |d| or |h - d.d| / |d| away    where only the former does not,
//   on that end's rim     else: isect/parts/sphere_round.h.
//
// The ball lies in the cylinder iff c is at least s from both planes and at most r - s from the axis, and the cylinder
// in the ball iff both ends do. All is compared squared and multiplied out: no division, no square root.
//
// Source: Ericson, Real-Time Collision Detection (2005), 5.1.2 and 5.1.3, for the nearest point.

#include <functional>
#include <variant>

#include <isect/parts/sphere_round.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_cylinder {

/// Where the cylinder's point nearest to the center lies: at the center itself, or on which part.
enum class Nearest { center, side, end_p, end_q, rim_p, rim_q };
/// That place, and the sign of its distance less the ball's radius.
struct Reach {
  Nearest nearest;
  int sign;
};
/// relate: whether the ball lies in the cylinder, the cylinder in the ball.
struct Contained {
  bool ball, cylinder;
};
using Event = std::variant<Reach, Contained, Fallback>;

namespace detail {

template <class Trace>
Reach reach(const Sphere<double, 3>& ball, const Cylinder<double>& cylinder, Trace&& trace) {
  const auto discs = round_solid::discs(cylinder);
  const round_solid::Signs at = round_solid::signs(ball.center, cylinder, trace);
  const bool before = at.first<0, beyond = at.last> 0;
  if (before || beyond) {
    const round_solid::Disc& end = discs[beyond];
    if (at.side <= 0)
      return {before ? Nearest::end_p : Nearest::end_q, sphere_round::plane(ball, end, cylinder, trace)};
    return {before ? Nearest::rim_p : Nearest::rim_q, sphere_round::rim(ball, end, cylinder, -1, trace)};
  }
  if (at.side <= 0) return {Nearest::center, ball.radius > 0 ? -1 : 0};
  return {Nearest::side, sphere_round::from_axis(ball, discs[0], cylinder, std::plus<>(), trace)};
}

/// Whether a ball that meets the cylinder lies in it, and the cylinder in the ball.
template <class Trace>
Contained contained(const Sphere<double, 3>& ball, const Cylinder<double>& cylinder, Nearest nearest, Trace&& trace) {
  const auto discs = round_solid::discs(cylinder);
  const bool inside = nearest == Nearest::center && ball.radius <= cylinder.radius &&
                      sphere_round::plane(ball, discs[0], cylinder, trace) >= 0 &&
                      sphere_round::plane(ball, discs[1], cylinder, trace) >= 0 &&
                      sphere_round::from_axis(ball, discs[0], cylinder, std::minus<>(), trace) <= 0;
  return {inside, sphere_round::holds(ball, cylinder, trace)};
}

}  // namespace detail

}  // namespace sphere_cylinder

/// Whether the ball and the cylinder have a common point. Exact; an empty one, NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Sphere<S, 3>& sphere, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!sphere_round::exist(sphere, cylinder)) return false;
  const sphere_cylinder::Reach reach = in_doubles_first(
      [&](auto& listener) {
        return sphere_cylinder::detail::reach(in_doubles(sphere), in_doubles(cylinder), listener);
      },
      trace);
  trace(reach);
  return reach.sign <= 0;
}

/// How the ball and the cylinder lie, the ball being a. Exact. A ball of radius 0 is a point, and a cylinder of radius
/// 0 a segment. An empty one, NaN or an infinite coordinate: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Sphere<S, 3>& sphere, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  if (!sphere_round::exist(sphere, cylinder)) return Relation::disjoint;
  return in_doubles_first(
      [&](auto& listener) {
        const Sphere<double, 3>& ball = in_doubles(sphere);
        const Cylinder<double>& wide = in_doubles(cylinder);
        const sphere_cylinder::Reach reach = sphere_cylinder::detail::reach(ball, wide, listener);
        listener(reach);
        if (reach.sign > 0) return Relation::disjoint;

        const sphere_cylinder::Contained inside =
            sphere_cylinder::detail::contained(ball, wide, reach.nearest, listener);
        listener(inside);
        if (inside.ball) return Relation::a_inside_b;
        if (inside.cylinder) return Relation::b_inside_a;
        return reach.sign == 0 ? Relation::touching : Relation::overlapping;
      },
      trace);
}

}  // namespace isect
