#pragma once
// Sphere against capsule as it is written in practice: for lessons and comparison. `intersects` in
// isect/sphere_capsule.h is right for all input.
//
// Both count touching as an intersection, but rounding may decide there; squares overflow or vanish beyond 1e+-154 in
// double, 1e+-19 in float; a radius below 0 is taken as it is, unless the sum of both is below 0.

#include <variant>

#include <isect/methods/nearest_features.h>
#include <isect/sphere_capsule.h>

namespace isect::sphere_capsule {

/// The segment's point nearest to the center, p + t (q - p).
template <class S, int N>
struct Foot {
  S t;
  Point<S, N> at;
};
/// The center's square distance from the segment, and (r + s)^2.
template <class S>
struct Compared {
  S distance2, reach2;
};
template <class S, int N>
using MethodEvent = std::variant<Foot<S, N>, Compared<S>>;

namespace detail {
template <class S, class Trace>
bool within(const S& distance2, const S& reach, Trace&& trace) {
  const S reach2 = reach * reach;
  trace(Compared<S>{distance2, reach2});
  return distance2 <= reach2;
}
}  // namespace detail

/// Finds the nearest point by clamping t to the segment. NaN: no. Source: Ericson, Real-Time Collision Detection
/// (2005), 5.1.2, ClosestPtPointSegment.
template <class S, int N, class Trace = NoTrace>
bool clamped(const Sphere<S, N>& sphere, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  const auto foot = [&](const auto& event) {
    if constexpr (requires { event.at; }) trace(Foot<S, N>{event.t, event.at});
  };
  const S distance2 = nearest_features::distance2<S, N>(sphere.center, Segment<S, N>{capsule.p, capsule.q}, foot);
  return detail::within<S>(distance2, sphere.radius + capsule.radius, trace);
}

/// Finds the square distance alone, by Pythagoras: between the ends two squares nearly cancel where the center lies far
/// from p and near the segment. Source: Ericson, Real-Time Collision Detection (2005), 5.1.2.1, SqDistPointSegment, as
/// TestSphereCapsule (4.5.1) calls it.
template <class S, int N, class Trace = NoTrace>
bool by_pythagoras(const Sphere<S, N>& sphere, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  const Vector<S, N> d = capsule.q - capsule.p, w = sphere.center - capsule.p;
  const S along = w.dot(d), reach = sphere.radius + capsule.radius;
  if (along <= S(0)) return detail::within<S>(w.dot(w), reach, trace);

  const S length2 = d.dot(d);
  if (along >= length2) {
    const Vector<S, N> beyond = sphere.center - capsule.q;
    return detail::within<S>(beyond.dot(beyond), reach, trace);
  }
  return detail::within<S>(w.dot(w) - along * along / length2, reach, trace);
}

}  // namespace isect::sphere_capsule
