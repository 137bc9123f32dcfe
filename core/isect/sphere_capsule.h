#pragma once
// Sphere against capsule.
//
// A capsule is a segment grown by a radius s. The ball around c meets it iff the segment's point nearest to c is at
// most r + s away, and lies inside it iff that point is at most s - r away. The capsule is the convex hull of the balls
// around its ends, so it lies inside the ball iff both of these do. Distances are compared squared and multiplied
// out: no division, no square root.
//
// Source: Ericson, Real-Time Collision Detection (2005), 4.5.1 and 5.1.2.

#include <functional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/point_segment.h>
#include <isect/parts/unit_of_length.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_capsule {

using point_segment::Nearest;

/// The segment's point nearest to the center, and the sign of its distance compared with r + s.
struct Reach {
  Nearest nearest;
  int sign;
};
/// relate: whether the ball lies in the capsule, the capsule in the ball.
struct Contained {
  bool ball, capsule;
};
using Event = std::variant<Reach, Contained, Fallback>;

namespace detail {
/// Compares the distance with r + s; both are finite and not empty.
template <int N, class Trace>
Reach reach(const Sphere<double, N>& ball, const Capsule<double, N>& capsule, Trace&& trace) {
  const Nearest nearest = point_segment::detail::nearest<N>(ball.center, capsule.p, capsule.q, trace);
  return {nearest, point_segment::detail::compare<N>(ball.center, capsule.p, capsule.q, nearest, ball.radius,
                                                     capsule.radius, std::plus<>(), trace)};
}

template <int N, class Trace>
Contained contained(const Sphere<double, N>& ball, const Capsule<double, N>& capsule, Nearest nearest, Trace&& trace) {
  const auto holds_end = [&](const Point<double, N>& end) {
    return point_segment::detail::compare<N>(end, ball.center, ball.center, Nearest::p, ball.radius, capsule.radius,
                                             std::minus<>(), trace) <= 0;
  };
  Contained result = {};
  if (ball.radius <= capsule.radius)
    result.ball = point_segment::detail::compare<N>(ball.center, capsule.p, capsule.q, nearest, capsule.radius,
                                                    ball.radius, std::minus<>(), trace) <= 0;
  if (capsule.radius <= ball.radius) result.capsule = holds_end(capsule.p) && holds_end(capsule.q);
  return result;
}
}  // namespace detail

}  // namespace sphere_capsule

/// Whether the ball and the capsule have a common point. Exact; an empty one, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Sphere<S, N>& sphere, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (empty(sphere) || empty(capsule) || !finite(sphere) || !finite(capsule)) return false;
  return in_doubles_first(
      [&](auto& listener) {
        return settled_in_own_unit<decltype(listener)>(
            in_doubles(sphere), in_doubles(capsule), [&](const Sphere<double, N>& x, const Capsule<double, N>& y) {
              const sphere_capsule::Reach reach = sphere_capsule::detail::reach<N>(x, y, listener);
              listener(reach);
              return reach.sign <= 0;
            });
      },
      trace);
}

/// How the ball and the capsule lie, the ball being a. Exact. A ball of radius 0 is a point, and a capsule of radius 0
/// a segment. An empty one, NaN or an infinite coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Sphere<S, N>& sphere, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (empty(sphere) || empty(capsule) || !finite(sphere) || !finite(capsule)) return Relation::disjoint;
  return in_doubles_first(
      [&](auto& listener) {
        const Sphere<double, N> ball = cast<double>(sphere);
        const Capsule<double, N> wide = cast<double>(capsule);
        const sphere_capsule::Reach reach = sphere_capsule::detail::reach<N>(ball, wide, listener);
        listener(reach);
        if (reach.sign > 0) return Relation::disjoint;

        const sphere_capsule::Contained inside =
            sphere_capsule::detail::contained<N>(ball, wide, reach.nearest, listener);
        listener(inside);
        if (inside.ball) return inside.capsule ? Relation::equal : Relation::a_inside_b;
        if (inside.capsule) return Relation::b_inside_a;
        return reach.sign == 0 ? Relation::touching : Relation::overlapping;
      },
      trace);
}

}  // namespace isect
