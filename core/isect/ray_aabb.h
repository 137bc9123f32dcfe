#pragma once
// Ray against axis-aligned box.
//
// The line x = o + t d is between the planes x_i = lo_i and x_i = hi_i for t between (lo_i - o_i) / d_i and
// (hi_i - o_i) / d_i; in the box from the last entry to the first exit. A zero component of d divides by nothing: the
// line stays at o_i. Rounding decides where entry and exit nearly meet, which is at edges and corners: there the
// quotients are compared by cross-multiplication. Source: Kay, Kajiya, Ray tracing complex scenes, SIGGRAPH (1986).

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/parts/slabs.h>

namespace isect {

namespace ray_aabb {

/// The stretch of the range in all slabs, rounded. Meets 1: it is not empty; -1: it is; 0: rounding may decide.
struct Estimate {
  double in, out;
  int meets;
};
using Event = std::variant<Estimate, slabs::Outside, slabs::Stretch, Fallback>;

/// A ray with the reciprocals of its direction, to be tested against many boxes. A reciprocal too large or too small to
/// be accurate is NaN, and its slab is left out. A ray with NaN or an infinite coordinate has an empty range.
template <class S, int N>
struct Prepared {
  Point<S, N> origin;
  Vector<S, N> inverse;
  std::array<bool, N> backwards;  ///< d_i < 0, or -0
  Interval<S> range;
};

/// Prepares a ray, for may_intersect against many boxes.
template <class S, int N>
Prepared<S, N> prepare(const Ray<S, N>& ray) {
  using Limits = std::numeric_limits<S>;
  Prepared<S, N> result = {ray.origin, ray.direction, {}, ray.range};
  for (int i = 0; i < N; ++i) {
    const S size = std::abs(ray.direction[i]);
    const bool accurate = size == 0 || (Limits::min() <= size && size <= 1 / Limits::min());
    result.backwards[i] = std::signbit(ray.direction[i]);
    result.inverse[i] = accurate ? 1 / ray.direction[i] : Limits::quiet_NaN();
  }
  if (!finite(ray)) result.range = {Limits::infinity(), -Limits::infinity()};
  return result;
}

namespace detail {

/// The slabs of a box, as lo <= d_i t <= hi.
template <int N>
struct Slabs {
  const Ray<double, N>& ray;
  const Aabb<double, N>& box;

  // clang-format off
  template <PolynomialScalar W> W rate(int i) const { return W(ray.direction[i]); }
  template <PolynomialScalar W> W lo(int i) const { return difference<W>(box.lo[i], ray.origin[i]); }
  template <PolynomialScalar W> W hi(int i) const { return difference<W>(box.hi[i], ray.origin[i]); }
  // clang-format on
};

/// The slabs' method in double, and whether rounding may have decided. Any input: numbers that are not finite, or
/// would overflow, make that unknown.
///
/// Bound. A difference, a reciprocal and a product err by at most g(3) = 3 u / (1 - 3 u) of each t, the product by
/// 2^-1075 more where it underflows; so do the greatest entry and the least exit. Differences that overflow make
/// `reach` infinite, reciprocals stay within 2^+-1000; a product may overflow, where t is beyond any end.
template <int N>
Estimate estimate(const Ray<double, N>& ray, const Aabb<double, N>& box) {
  double in = ray.range.lo, out = ray.range.hi, reach = 0;
  bool ordered = true;
  for (int i = 0; i < N; ++i) {
    const double d = ray.direction[i], to_lo = box.lo[i] - ray.origin[i], to_hi = box.hi[i] - ray.origin[i];
    reach += std::abs(to_lo) + std::abs(to_hi);
    ordered &= box.lo[i] <= box.hi[i];
    if (d == 0) {
      if (to_lo > 0 || to_hi < 0) return {in, out, -1};
      continue;
    }
    if (!(0x1p-1000 <= std::abs(d) && std::abs(d) <= 0x1p1000)) return {in, out, 0};
    const double inverse = 1 / d;
    const double t1 = to_lo * inverse, t2 = to_hi * inverse;
    in = std::max(in, std::min(t1, t2));
    out = std::min(out, std::max(t1, t2));
  }
  const double gap = out - in;
  const double slack = 8 * unit<double> * (std::abs(in) + std::abs(out)) + 0x1p-1000;
  if (!ordered || !(reach <= std::numeric_limits<double>::max())) return {in, out, 0};
  return {in, out, (gap > slack) - (-gap > slack)};
}

/// Decides may_intersect for infinite t: they come from a zero component, beside whose slab the ray may run, or from a
/// difference that overflowed and tells nothing.
template <class S, int N>
[[gnu::noinline, gnu::cold]] bool may_at_infinity(const Prepared<S, N>& ray, const Aabb<S, N>& box) {
  for (int i = 0; i < N; ++i)
    if (std::isinf(ray.inverse[i]) && (ray.origin[i] < box.lo[i] || box.hi[i] < ray.origin[i])) return false;
  return ray.range.lo <= ray.range.hi;
}

}  // namespace detail

}  // namespace ray_aabb

/// Whether the ray may meet the box: never no for one that does, and yes only for few that pass it by, within rounding.
/// For bounding volume hierarchies, in S itself. An empty or NaN box, an empty or NaN ray: no.
///
/// Bound. As in estimate, |error of t| <= g(3) |t| and half the least subnormal. For a true entry <= a true exit the
/// computed ones differ by at most 2 g(3) |exit| the wrong way round, which the exit is given in advance. NaN, from
/// 0 / 0 on a slab's plane, fails both comparisons, which leaves that plane out.
/// Source: Ize, Robust BVH ray traversal, J. Computer Graphics Techniques 2 (2013).
template <class S, int N>
bool may_intersect(const ray_aabb::Prepared<S, N>& ray, const Aabb<S, N>& box) {
  if (empty(box)) return false;
  S in = ray.range.lo, out = ray.range.hi;
  for (int i = 0; i < N; ++i) {
    const S t[2] = {(box.lo[i] - ray.origin[i]) * ray.inverse[i], (box.hi[i] - ray.origin[i]) * ray.inverse[i]};
    const S entry = t[ray.backwards[i]],
            exit = t[!ray.backwards[i]];  // an index, as a condition would be a branch
    in = entry > in ? entry : in;
    out = exit < out ? exit : out;
  }
  using Limits = std::numeric_limits<S>;
  if (in <= out + (4 * Limits::epsilon() * std::abs(out) + 4 * Limits::denorm_min()))
    return ray.range.lo <= ray.range.hi;
  if (std::isfinite(in) && std::isfinite(out)) return false;
  return ray_aabb::detail::may_at_infinity(ray, box);
}
template <class S, int N>
bool may_intersect(const Ray<S, N>& ray, const Aabb<S, N>& box) {
  return may_intersect(ray_aabb::prepare(ray), box);
}

/// The part of the ray's range inside the closed box, in units of |direction|.
///
/// Whether there is one is true for all finite input of any magnitude; a ray that grazes a face, an edge or a corner
/// meets the box. The ends lie within 4 ulp of S of the true ones, in the range, in order. A zero direction makes the
/// ray a point: the whole range if it lies in the box. A box without thickness is a rectangle, a segment or a point.
/// An empty box or range, NaN or an infinite coordinate: nothing.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  const Ray<double, N> wide = cast<double>(ray);
  const Aabb<double, N> bounds = cast<double>(box);

  const ray_aabb::Estimate t = ray_aabb::detail::estimate(wide, bounds);
  trace(t);
  if (t.meets < 0) return {};
  if (t.meets > 0) return Interval<S>{static_cast<S>(t.in), static_cast<S>(t.out)};

  if (empty(box) || !finite(ray) || !finite(box)) return {};
  return slabs::detail::clip<S, N>(ray.range, ray_aabb::detail::Slabs<N>{wide, bounds}, trace);
}

/// Whether ray and box have a common point; see intersect.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  return intersect(ray, box, trace).has_value();
}

/// The least t of the range at which the ray is in the box.
template <class S, int N>
std::optional<S> first_hit(const Ray<S, N>& ray, const Aabb<S, N>& box) {
  const std::optional<Interval<S>> part = intersect(ray, box);
  return part ? std::optional<S>(part->lo) : std::nullopt;
}

}  // namespace isect
