#pragma once
// Plane against sphere.
//
// The center is |n.c + d| / |n| away from the plane: the plane misses the ball iff that exceeds r, touches it when it
// is r, and cuts it when it is less. Without the quotient and the root: (n.c + d)^2 against r^2 n.n, whose difference
// is a polynomial. Source: Akenine-Moller, Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.9; the plane of the
// note, N20.

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace plane_sphere {

/// The signs of n.c + d, on which side the center lies, and of (n.c + d)^2 - r^2 n.n, 1 where the ball stays there.
struct Decision {
  int center, clear;
};
using Event = std::variant<Decision, Fallback>;

namespace detail {

/// n.c + d
template <PolynomialScalar W, int N>
W height(const Plane<double, N>& plane, const Point<double, N>& point) {
  return dot(exactly<W, N>(plane.normal), exactly<W, N>(point)) + W(plane.d);
}

/// Both signs, by the plane's equation even where the normal is 0: then n.c + d is d everywhere. Finite arguments.
template <class S, int N, class Trace>
Decision decide(const Plane<S, N>& plane, const Sphere<S, N>& sphere, Trace&& trace) {
  const Plane<double, N> wide = cast<double>(plane);
  const Sphere<double, N> ball = cast<double>(sphere);

  const int center = sign_of([&]<class W>() -> W { return height<W, N>(wide, ball.center); }, trace);
  const int clear = sign_of(
      [&]<class W>() -> W {
        const Components<W, N> n = exactly<W, N>(wide.normal);
        const W h = height<W, N>(wide, ball.center), r = W(ball.radius);
        return h * h - r * r * dot(n, n);
      },
      trace);
  trace(Decision{center, clear});
  return {center, clear};
}

/// Whether there is a plane and a ball at all.
template <class S, int N>
bool meaningful(const Plane<S, N>& plane, const Sphere<S, N>& sphere) {
  return finite(plane) && finite(sphere) && !empty(sphere) && !plane.normal.isZero(0);
}

}  // namespace detail

}  // namespace plane_sphere

/// The sign of n.x + d for all points x of the ball, or 0 where the ball meets the plane. Exact. A zero normal, which
/// makes no plane, an empty ball, NaN or an infinite coordinate: 0.
template <class S, int N, class Trace = NoTrace>
int side(const Plane<S, N>& plane, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  if (!plane_sphere::detail::meaningful(plane, sphere)) return 0;
  const plane_sphere::Decision signs = plane_sphere::detail::decide(plane, sphere, trace);
  return signs.clear > 0 ? signs.center : 0;
}

/// Returns disjoint; touching, when the ball has points in the plane and on one side of it at most; or overlapping,
/// when it has points on both sides. Exact. A ball of radius 0 can only touch. A zero normal, which makes no plane, an
/// empty ball, NaN or an infinite coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Plane<S, N>& plane, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  if (!plane_sphere::detail::meaningful(plane, sphere)) return Relation::disjoint;
  const plane_sphere::Decision signs = plane_sphere::detail::decide(plane, sphere, trace);
  if (signs.clear > 0) return Relation::disjoint;
  return signs.clear == 0 ? Relation::touching : Relation::overlapping;
}

/// Whether the plane and the ball have a common point. Exact; degenerate arguments as for relate.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Plane<S, N>& plane, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  return relate(plane, sphere, trace) != Relation::disjoint;
}

}  // namespace isect
