#pragma once
// Ray, segment or line against capsule.
//
// They meet iff the ray comes within r of the capsule's axis. The nearest points of both are an end of the axis and the
// ray's point nearest to it, or an end of the ray and the axis' point nearest to it, or lie between the ends of both.
// With w leading from the ray's origin o to the axis p q, v = q - p and n = d x v, the lines come nearest at
// t = (w x v).n / n.n of the ray and (w x d).n / n.n of the axis, |w.n| / |n| apart. In the plane lines that cross have
// the distance 0. All is compared multiplied out: no division, no square root.
//
// Source: Ericson, Real-Time Collision Detection (2005), 5.1.8 and 5.1.9.

#include <cmath>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/point_segment.h>
#include <isect/parts/ray_range.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace ray_capsule {

/// Whether both lines are nearest to each other strictly between the ends; and if so, the sign of that distance
/// compared with r.
struct Between {
  bool holds;
  int sign;
};
/// An end (0: p, 1: q of the axis, 2: the first, 3: the last point of the ray), and the sign of its distance from the
/// other one compared with r.
struct End {
  int end;
  int sign;
};
using Event = std::variant<Between, End, Fallback>;

namespace detail {

/// The ray's point at t, seen from c.
template <Filtered W, int N>
Components<W, N> seen_from(const Point<double, N>& c, const Ray<double, N>& ray, double t) {
  Components<W, N> x = difference<W, N>(ray.origin, c);
  if (t == 0) return x;
  for (int i = 0; i < N; ++i) x[i] = x[i] + W(t) * W(ray.direction[i]);
  return x;
}

/// The sign of |x|^2 - r^2.
template <class Text, class Trace>
int beyond(double r, const Text& x, Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const auto at = x.template operator()<W>();
        return dot(at, at) - W(r) * W(r);
      },
      trace);
}

/// The sign of the distance of c from the ray compared with r. The direction is not 0.
template <int N, class Trace>
int compare(const Point<double, N>& c, const Ray<double, N>& ray, double r, Trace&& trace) {
  const auto onwards = [&](double t) {  // the sign of what is left from the ray's point at t to the nearest one
    return -sign_of([&]<class W>() -> W { return dot(seen_from<W, N>(c, ray, t), exactly<W>(ray.direction)); }, trace);
  };
  const auto at = [&](double t) {
    return beyond(
        r, [&]<class W>() -> Components<W, N> { return seen_from<W, N>(c, ray, t); }, trace);
  };
  if (std::isfinite(ray.range.lo) && onwards(ray.range.lo) <= 0) return at(ray.range.lo);
  if (std::isfinite(ray.range.hi) && onwards(ray.range.hi) >= 0) return at(ray.range.hi);
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> d = exactly<W>(ray.direction);
        return point_segment::detail::cross_squared(seen_from<W, N>(c, ray, 0), d) - W(r) * W(r) * dot(d, d);
      },
      trace);
}

/// The sign of the distance of the ray's point at t from the axis compared with r.
template <int N, class Trace>
int compare(const Ray<double, N>& ray, double t, const Capsule<double, N>& capsule, Trace&& trace) {
  const auto from_p = [&]<class W>() -> Components<W, N> { return seen_from<W, N>(capsule.p, ray, t); };
  const auto from_q = [&]<class W>() -> Components<W, N> { return seen_from<W, N>(capsule.q, ray, t); };
  const auto along = [&](const auto& x) {
    return sign_of(
        [&]<class W>() -> W { return dot(x.template operator()<W>(), difference<W, N>(capsule.q, capsule.p)); }, trace);
  };
  if (along(from_p) <= 0) return beyond(capsule.radius, from_p, trace);
  if (along(from_q) >= 0) return beyond(capsule.radius, from_q, trace);
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> v = difference<W, N>(capsule.q, capsule.p);
        return point_segment::detail::cross_squared(from_p.template operator()<W>(), v) -
               W(capsule.radius) * W(capsule.radius) * dot(v, v);
      },
      trace);
}

template <Filtered W>
W cross(const Components<W, 2>& x, const Components<W, 2>& y) {
  return x[0] * y[1] - x[1] * y[0];
}

/// Where the lines come nearest, on the ray and on the axis: quotients of polynomials, with one denominator.
template <Filtered W, int N>
struct Places {
  W ray, axis, all;
};
template <Filtered W, int N>
Places<W, N> places(const Ray<double, N>& ray, const Capsule<double, N>& capsule) {
  const Components<W, N> d = exactly<W>(ray.direction), v = difference<W, N>(capsule.q, capsule.p),
                         w = difference<W, N>(capsule.p, ray.origin);
  if constexpr (N == 2) {
    return {cross(w, v), cross(w, d), cross(d, v)};
  } else {
    const Components<W, 3> n = isect::cross(d, v);
    return {dot(isect::cross(w, v), n), dot(isect::cross(w, d), n), dot(n, n)};
  }
}

template <int N, class Trace>
Between between(const Ray<double, N>& ray, const Capsule<double, N>& capsule, Trace&& trace) {
  const int all =
      sign_of([&]<class W>() -> W { return places<W, N>(ray, capsule).all; }, trace);  // in space at least 0
  if (all == 0) return {};
  const auto after = [&](const auto& excess) {
    return all * sign_of([&]<class W>() -> W { return excess(places<W, N>(ray, capsule)); }, trace) > 0;
  };
  if (!after([](const auto& p) { return p.axis; }) || !after([](const auto& p) { return p.all - p.axis; })) return {};
  const double lo = ray.range.lo, hi = ray.range.hi;
  if (std::isfinite(lo) && !after([lo]<class W>(const Places<W, N>& p) { return p.ray - W(lo) * p.all; })) return {};
  if (std::isfinite(hi) && !after([hi]<class W>(const Places<W, N>& p) { return W(hi) * p.all - p.ray; })) return {};
  if constexpr (N == 2) {
    return {true, capsule.radius > 0 ? -1 : 0};
  } else {
    const auto excess = [&]<class W>() -> W {
      const Components<W, 3> n = isect::cross(exactly<W>(ray.direction), difference<W, 3>(capsule.q, capsule.p));
      const W height = dot(difference<W, 3>(capsule.p, ray.origin), n), r = W(capsule.radius);
      return height * height - r * r * dot(n, n);
    };
    return {true, sign_of(excess, trace)};
  }
}

/// Whether the distance of the ray from the axis is at most r. Finite, not empty; the range has a point.
template <int N, class Trace>
bool meets(Ray<double, N> ray, const Capsule<double, N>& capsule, Trace&& trace) {
  const bool point = (ray.direction.array() == 0).all();
  if (point) ray.range = {0, 0};
  for (const int end : {2, 3}) {
    const double t = end == 2 ? ray.range.lo : ray.range.hi;
    if (!std::isfinite(t)) continue;
    const int sign = compare<N>(ray, t, capsule, trace);
    trace(End{end, sign});
    if (sign <= 0 || point) return sign <= 0;
  }
  for (const int end : {0, 1}) {
    const int sign = compare<N>(end == 0 ? capsule.p : capsule.q, ray, capsule.radius, trace);
    trace(End{end, sign});
    if (sign <= 0) return true;
  }
  const Between inner = between<N>(ray, capsule, trace);
  trace(inner);
  return inner.holds && inner.sign <= 0;
}

}  // namespace detail

}  // namespace ray_capsule

/// Whether a point of the ray's range lies in the capsule. Exact, for all finite input; touching counts. A zero
/// direction makes the ray a point. An empty range, an empty capsule, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Ray<S, N>& ray, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule) || !finite(ray) || !ray_range::has_points(ray.range)) return false;
  return in_doubles_first(
      [&](auto& listener) { return ray_capsule::detail::meets<N>(in_doubles(ray), in_doubles(capsule), listener); },
      trace);
}

}  // namespace isect
