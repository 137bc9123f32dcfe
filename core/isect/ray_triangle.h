#pragma once
// Ray against triangle, watertight.
//
// With A = a - o, B = b - o, C = c - o the line o + t d passes the edges at the signed volumes
//
//   w_a = d.(B x C),   w_b = d.(C x A),   w_c = d.(A x B),
//
// which are the weights of a, b, c at the point where it meets the plane, times their sum: d.n with
// n = (b - a) x (c - a). So it meets the triangle iff no two of them have opposite signs. Their signs are exact, and
// that of an edge is the same for both triangles that share it: no line slips between them. t = n.A / n.d.
//
// Source: Plucker coordinates, as in Shoemake, Ray Tracing News 11 (1998); Woop, Benthin, Wald, Watertight
// ray/triangle intersection, J. Computer Graphics Techniques 2 (2013).

#include <Eigen/Geometry>
#include <optional>
#include <variant>

#include <isect/parts/ray_range.h>
#include <isect/parts/three_quotients.h>
#include <isect/trace.h>

namespace isect {

/// What a ray and a triangle have in common. t in units of |direction|.
template <class S>
struct RayTriangle {
  bool coplanar = false;              ///< the line lies in the plane of the triangle: an answer of its own, no hit
  Location location = Location::out;  ///< of the line's point in the plane; out when there is none
  std::optional<S> t;                 ///< where the ray meets the triangle
  S u = 0, v = 0;                     ///< the weights of b and c at that point, of [0, 1]; that of a is 1 - u - v

  explicit operator bool() const { return t.has_value(); }
};

namespace ray_triangle {

/// The signs of w_a, w_b, w_c.
struct Volumes {
  int a, b, c;
};
template <class S>
struct Hit {
  S t, u, v;
};
template <class S>
using Event = std::variant<Volumes, Hit<S>, Fallback>;

namespace detail {

/// d.((p - o) x (q - o)): on which side of the line the edge pq passes.
template <PolynomialScalar W>
ISECT_INLINE W volume(const Ray<double, 3>& ray, const Point<double, 3>& p, const Point<double, 3>& q) {
  return dot(exactly<W>(ray.direction), cross(difference<W>(p, ray.origin), difference<W>(q, ray.origin)));
}

/// (b - a) x (c - a)
template <PolynomialScalar W>
ISECT_INLINE Components<W, 3> normal(const Triangle<double, 3>& x) {
  const auto& [a, b, c] = x.vertices;
  return cross(difference<W>(b, a), difference<W>(c, a));
}

/// t on the whole line, as the numerator and the denominator.
template <PolynomialScalar W>
ISECT_INLINE Ratio<W> parameter(const Ray<double, 3>& ray, const Triangle<double, 3>& x) {
  const Components<W, 3> n = normal<W>(x);
  return ratio_of_dots<W, 3>(n, difference<W>(x.vertices[0], ray.origin), ray.direction);
}

/// Whether the triangle has no area.
template <class Trace>
bool flat(const Triangle<double, 3>& x, Trace&& trace) {
  for (int i = 0; i < 3; ++i)
    if (sign_of([&]<class W>() -> W { return normal<W>(x)[i]; }, trace) != 0) return false;
  return true;
}

template <class Trace>
Volumes volumes(const Ray<double, 3>& ray, const Triangle<double, 3>& x, Trace&& trace) {
  const auto& [a, b, c] = x.vertices;
  const auto sign = [&](const Point<double, 3>& p, const Point<double, 3>& q) -> int {
    return sign_of([&]<class W>() -> W { return volume<W>(ray, p, q); }, trace);
  };
  return {sign(b, c), sign(c, a), sign(a, b)};
}

/// t, u, v on the whole line, as numerators and denominator: w_b = -C.(d x A), w_c = B.(d x A).
template <PolynomialScalar W>
ISECT_INLINE ThreeRatios<W> coordinates(const Ray<double, 3>& ray, const Triangle<double, 3>& x) {
  const auto& [a, b, c] = x.vertices;
  const Ratio<W> t = parameter<W>(ray, x);
  const Components<W, 3> moment = cross(exactly<W>(ray.direction), difference<W>(a, ray.origin));
  const Ratio<W> w = ratio_of_dots<W, 3>(moment, difference<W>(c, ray.origin), difference<W>(b, ray.origin));
  return {t.num, -w.num, w.den, t.den};
}

template <class S, class Trace>
RayTriangle<S> meet(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace& trace) {
  RayTriangle<S> result;
  if constexpr (!doubles_only<Trace>)
    if (!finite(ray) || !finite(triangle)) return result;
  const Ray<double, 3>& wide = in_doubles(ray);
  const Triangle<double, 3>& x = in_doubles(triangle);

  const Volumes side = volumes(wide, x, trace);
  trace(side);
  const bool positive = side.a > 0 || side.b > 0 || side.c > 0, negative = side.a < 0 || side.b < 0 || side.c < 0;
  if (positive && negative) return result;

  const auto t = [&]<class W>() __attribute__((always_inline))->Ratio<W> { return parameter<W>(wide, x); };
  if (!positive && !negative) {  // in the plane, a point, or no triangle
    const auto height = [&]<class W>() -> W { return t.template operator()<W>().num; };
    result.coplanar = sign_of(height, trace) == 0 && !flat(x, trace);
    return result;
  }

  result.location = side.a != 0 && side.b != 0 && side.c != 0 ? Location::in : Location::on;
  if (!ray_range::holds(wide.range, t, positive ? 1 : -1, trace)) return result;
  const auto all = [&]<class W>() __attribute__((always_inline))->ThreeRatios<W> { return coordinates<W>(wide, x); };
  const auto [line, u, v] = values_of<S>(all, {false, side.b == 0, side.c == 0}, trace);
  const Interval<S> weights = {S(0), S(1)};
  result.t = ray_range::clamped(line, ray.range);
  result.u = ray_range::clamped(u, weights), result.v = ray_range::clamped(v, weights);
  trace(Hit<S>{*result.t, result.u, result.v});
  return result;
}

template <class S, class Trace>
bool met(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace& trace) {
  if constexpr (!doubles_only<Trace>)
    if (!finite(ray) || !finite(triangle)) return false;
  const Ray<double, 3>& wide = in_doubles(ray);
  const Triangle<double, 3>& x = in_doubles(triangle);

  const Volumes side = volumes(wide, x, trace);
  trace(side);
  const bool positive = side.a > 0 || side.b > 0 || side.c > 0, negative = side.a < 0 || side.b < 0 || side.c < 0;
  if (positive == negative) return false;
  const auto t = [&]<class W>() __attribute__((always_inline))->Ratio<W> { return parameter<W>(wide, x); };
  return ray_range::holds(wide.range, t, positive ? 1 : -1, trace);
}

}  // namespace detail

}  // namespace ray_triangle

/// Where a ray, segment or line meets a triangle, from either side.
///
/// Every verdict (coplanar, location, whether t has a value) is true for all finite input of any magnitude: a line
/// through an edge or a vertex meets all triangles that share it. t lies within 2 ulp of S of its true value and in
/// the range, u and v within 2 ulp of theirs. A zero direction makes the ray a point: no hit, coplanar if it lies in
/// the plane. A triangle without area has no plane: no hit. NaN or an infinite coordinate, or an empty range: no hit.
template <class S, class Trace = NoTrace>
RayTriangle<S> intersect(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  return in_doubles_first<S>([&](auto& pass) { return ray_triangle::detail::meet(ray, triangle, pass); }, trace);
}

/// Whether the ray meets the triangle; see intersect. No for a coplanar ray.
template <class S, class Trace = NoTrace>
bool intersects(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  return in_doubles_first([&](auto& pass) { return ray_triangle::detail::met(ray, triangle, pass); }, trace);
}

}  // namespace isect
