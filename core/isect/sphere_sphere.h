#pragma once
// Sphere against sphere.
//
// The balls |x - a| <= r and |x - b| <= s have a common point iff |a - b|^2 <= (r + s)^2, and the larger contains the
// smaller iff |a - b|^2 <= (r - s)^2: no square root. Source: the note, N14, where touching counts as disjoint.

#include <algorithm>
#include <functional>
#include <limits>
#include <type_traits>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/squares.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_sphere {

/// The signs of |a - b|^2 - (r + s)^2 and |a - b|^2 - (r - s)^2: -1 nearer, 0 at that very distance, 1 farther.
struct Decision {
  int outer, inner;
};
using Event = std::variant<Decision, Fallback>;

namespace detail {

/// |a - b|^2 - (r +- s)^2
template <PolynomialScalar W, int N, class Radii>
W gap(const Sphere<double, N>& a, const Sphere<double, N>& b, const Radii& radii) {
  const Components<W, N> f = difference<W>(a.center, b.center);
  const W reach = radii(W(a.radius), W(b.radius));
  return dot(f, f) - reach * reach;
}

/// The sign of |a - b|^2 - (r + s)^2, computed as x - y; 1 for NaN and infinite coordinates, near which nothing lies.
/// Not inlined: the machine code of the rare path stays out of the common one's.
template <class S, int N, class Trace>
[[gnu::noinline]] int sign_of_outer_gap(const Sphere<S, N>& a, const Sphere<S, N>& b, S x, S y, Trace&& trace) {
  if (!(x + y <= std::numeric_limits<S>::max()) && (!finite(a) || !finite(b))) return 1;
  const auto text = [&]<class W>() -> W { return gap<W, N>(in_doubles(a), in_doubles(b), std::plus<W>()); };
  return settled_squares(text, x, y, trace);
}
/// The sign of |a - b|^2 - (r - s)^2, for finite balls.
template <class S, int N, class Trace>
[[gnu::noinline]] int sign_of_inner_gap(const Sphere<S, N>& a, const Sphere<S, N>& b, S x, S y, Trace&& trace) {
  const auto text = [&]<class W>() -> W { return gap<W, N>(in_doubles(a), in_doubles(b), std::minus<W>()); };
  return settled_squares(text, x, y, trace);
}

template <class S, int N>
S distance2(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  return (a.center - b.center).squaredNorm();
}
template <class S>
S squared(S x) {
  return x * x;
}

}  // namespace detail

}  // namespace sphere_sphere

/// Whether the balls have a common point. Exact; an empty ball, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  using namespace sphere_sphere::detail;
  const S d2 = distance2(a, b), sum2 = squared(a.radius + b.radius);
  if (!ordered(d2, sum2)) [[unlikely]]
    return !empty(a) && !empty(b) && sign_of_outer_gap(a, b, d2, sum2, trace) <= 0;
  return (d2 < sum2) & (std::min(a.radius, b.radius) >= 0);  // without a branch on the answer
}

/// How the balls lie. Exact. A ball of radius 0 is a point: it lies inside a ball whose surface it is on.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  using namespace sphere_sphere::detail;
  if (empty(a) || empty(b)) return Relation::disjoint;

  const S d2 = distance2(a, b), sum2 = squared(a.radius + b.radius), rest2 = squared(a.radius - b.radius);
  const int outer = order_of_squares(d2, sum2, [&] { return sign_of_outer_gap(a, b, d2, sum2, trace); });
  const int inner =
      outer > 0 ? 1 : order_of_squares(d2, rest2, [&] { return sign_of_inner_gap(a, b, d2, rest2, trace); });
  if constexpr (heard<Trace>) trace(sphere_sphere::Decision{outer, inner});

  if (outer > 0) return Relation::disjoint;
  if (inner <= 0 && a.radius == b.radius) return Relation::equal;
  if (inner <= 0) return a.radius < b.radius ? Relation::a_inside_b : Relation::b_inside_a;
  return outer == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
