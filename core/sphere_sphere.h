#pragma once
// Sphere against sphere.
//
// The balls |x - a| <= r and |x - b| <= s have a common point iff |a - b|^2 <= (r + s)^2, and the larger contains the
// smaller iff |a - b|^2 <= (r - s)^2: no square root. Source: the note, N14, where touching counts as disjoint.

#include <variant>

#include "core/predicate.h"
#include "core/shapes.h"
#include "core/trace.h"

namespace isect {

namespace sphere_sphere {

/// The signs of |a - b|^2 - (r + s)^2 and |a - b|^2 - (r - s)^2: -1 nearer, 0 at that very distance, 1 farther.
struct Decision {
  int outer, inner;
};
using Event = std::variant<Decision, Fallback>;

/// The note's method, its rounded numbers.
template <class S>
struct Compared {
  S distance2, sum2;
};

/// |a - b|^2 - (r +- s)^2
template <Filtered W, int N, class Radii>
W gap(const Sphere<double, N>& a, const Sphere<double, N>& b, const Radii& radii) {
  const Components<W, N> f = difference<W>(a.center, b.center);
  const W reach = radii(W(a.radius), W(b.radius));
  return dot(f, f) - reach * reach;
}

template <int N, class Trace>
int outer(const Sphere<double, N>& a, const Sphere<double, N>& b, Trace&& trace) {
  return sign_of([&]<class W>() -> W { return gap<W>(a, b, [](const W& r, const W& s) -> W { return r + s; }); },
                 trace);
}
template <int N, class Trace>
int inner(const Sphere<double, N>& a, const Sphere<double, N>& b, Trace&& trace) {
  return sign_of([&]<class W>() -> W { return gap<W>(a, b, [](const W& r, const W& s) -> W { return r - s; }); },
                 trace);
}

/// Whether the spheres come nearer than touching, as the note prints it. Naive: rounding may decide.
template <class S, int N, class Trace = NoTrace>
bool squared_distance(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  const S distance2 = l.dot(l);
  const S sum = a.radius + b.radius;
  trace(Compared<S>{distance2, sum * sum});

  return distance2 < sum * sum;
}

}  // namespace sphere_sphere

/// Whether the balls have a common point. Exact; an empty ball, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b)) return false;
  return sphere_sphere::outer(cast<double>(a), cast<double>(b), trace) <= 0;
}

/// How the balls lie. Exact. A ball of radius 0 is a point: it lies inside a ball whose surface it is on.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b)) return Relation::disjoint;
  const Sphere<double, N> wide_a = cast<double>(a), wide_b = cast<double>(b);

  const int outer = sphere_sphere::outer(wide_a, wide_b, trace);
  const int inner = outer > 0 ? 1 : sphere_sphere::inner(wide_a, wide_b, trace);
  trace(sphere_sphere::Decision{outer, inner});

  if (outer > 0) return Relation::disjoint;
  if (inner <= 0 && a.radius == b.radius) return Relation::equal;
  if (inner <= 0) return a.radius < b.radius ? Relation::a_inside_b : Relation::b_inside_a;
  return outer == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
