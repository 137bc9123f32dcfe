#pragma once
// Sphere against sphere as the note prints it and as it is written in practice: for lessons and comparison.
// `intersects` in isect/sphere_sphere.h is right for all input.
//
// All but the note's count touching as an intersection, but rounding may decide there. A root helps nothing: the sum of
// squares under it has been rounded before. Squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float; only
// std::hypot is free of that. Negative radii are taken as they are, so that empty balls may meet.

#include <algorithm>
#include <cmath>
#include <variant>

#include <isect/sphere_sphere.h>

namespace isect::sphere_sphere {

/// The rounded numbers of the note's method.
template <class S>
struct Compared {
  S distance2, sum2;
};

/// The distance of the centers against r + s, as rounded.
template <class S>
struct Lengths {
  S distance, sum;
};
template <class S>
using MethodEvent = std::variant<Compared<S>, Lengths<S>>;

/// Whether the spheres come nearer than touching, as the note prints it. Naive: rounding may decide.
template <class S, int N, class Trace = NoTrace>
bool squared_distance_naive(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  const S distance2 = l.dot(l);
  const S sum = a.radius + b.radius, sum2 = sum * sum;
  trace(Compared<S>{distance2, sum2});

  return distance2 < sum2;
}

/// Compares the note's squares with <=. Source: Ericson, Real-Time Collision Detection (2005), 4.3.1.
template <class S, int N, class Trace = NoTrace>
bool closed_squared_distance(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  const S distance2 = l.dot(l);
  const S sum = a.radius + b.radius, sum2 = sum * sum;
  trace(Compared<S>{distance2, sum2});

  return distance2 <= sum2;
}

/// Compares the distance itself: one square root more.
template <class S, int N, class Trace = NoTrace>
bool by_distance(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  using std::sqrt;
  const S distance = sqrt(l.dot(l));
  const S sum = a.radius + b.radius;
  trace(Lengths<S>{distance, sum});

  return distance <= sum;
}

namespace detail {

/// std::hypot of three, as libstdc++ has it: that of other libraries squares without scaling.
template <class S>
S hypot(S x, S y, S z) {
  const S largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (largest == S(0)) return largest;
  const S u = x / largest, v = y / largest, w = z / largest;
  return largest * std::sqrt(u * u + v * v + w * w);
}

}  // namespace detail

/// Uses std::hypot, whose squares neither overflow nor vanish.
template <class S, int N, class Trace = NoTrace>
bool by_hypot(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  S distance;
  if constexpr (N == 2)
    distance = std::hypot(l[0], l[1]);
  else
    distance = detail::hypot(l[0], l[1], l[2]);
  const S sum = a.radius + b.radius;
  trace(Lengths<S>{distance, sum});

  return distance <= sum;
}

/// Returns which of the six relations holds, by rounded squares.
template <class S, int N, class Trace = NoTrace>
Relation squared_relation(const Sphere<S, N>& a, const Sphere<S, N>& b, Trace&& trace = {}) {
  const Vector<S, N> l = a.center - b.center;
  const S distance2 = l.dot(l);
  const S sum = a.radius + b.radius;
  trace(Compared<S>{distance2, sum * sum});
  if (distance2 > sum * sum) return Relation::disjoint;

  const S rest = a.radius - b.radius;
  trace(Compared<S>{distance2, rest * rest});
  if (distance2 <= rest * rest) {
    if (rest == S(0)) return Relation::equal;
    return rest < S(0) ? Relation::a_inside_b : Relation::b_inside_a;
  }
  return distance2 == sum * sum ? Relation::touching : Relation::overlapping;
}

}  // namespace isect::sphere_sphere
