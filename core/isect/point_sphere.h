#pragma once
// Point against sphere: |p - c|^2 against r^2, without a square root. Source: the note, N14, for a ball of radius 0.

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/squares.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace point_sphere {

/// The sign of |p - c|^2 - r^2.
struct Distance {
  int sign;
};
using Event = std::variant<Distance, Fallback>;

namespace detail {

/// The sign of |p - c|^2 - r^2 where doubles do not settle it. Finite arguments.
template <class S, int N, class Trace>
[[gnu::noinline]] int sign_of_gap(const Point<S, N>& point, const Sphere<S, N>& sphere, Trace&& trace) {
  const Point<double, N> p = point.template cast<double>();
  const Sphere<double, N> ball = cast<double>(sphere);
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> f = difference<W, N>(p, ball.center);
        return dot(f, f) - W(ball.radius) * W(ball.radius);
      },
      trace);
}

}  // namespace detail

}  // namespace point_sphere

/// Where the point lies with respect to the ball. Exact. The center of a sphere of radius 0 is `on`. An empty ball,
/// NaN or an infinite coordinate: out.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& point, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  if (empty(sphere)) return Location::out;

  const double distance2 = (point.template cast<double>() - sphere.center.template cast<double>()).squaredNorm();
  const double radius2 = double(sphere.radius) * double(sphere.radius);
  const int sign = order_of_squares(distance2, radius2, [&] {
    return finite(point) && finite(sphere) ? point_sphere::detail::sign_of_gap<S, N>(point, sphere, trace) : 1;
  });
  trace(point_sphere::Distance{sign});

  if (sign > 0) return Location::out;
  return sign == 0 ? Location::on : Location::in;
}

}  // namespace isect
