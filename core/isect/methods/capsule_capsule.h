#pragma once
// Capsule against capsule as it is written in practice: for lessons and comparison. `intersects` in
// isect/capsule_capsule.h is right for all input.
//
// Both find a nearest point on each segment, p + s (q - p) and p + t (q - p), and compare their square distance. Both
// count touching as an intersection, but rounding may decide there, and far more of it where the segments are nearly
// parallel: then the determinant of their lines, |u|^2 |v|^2 - (u.v)^2, cancels. Squares overflow or vanish beyond
// 1e+-154 in double, 1e+-19 in float, the determinant beyond the roots of these; a radius below 0 is taken as it is,
// unless the sum of both is below 0.

#include <variant>

#include <isect/capsule_capsule.h>
#include <isect/methods/nearest_features.h>

namespace isect::capsule_capsule {

/// The determinant of both lines, and whether the method takes them for parallel.
template <class S>
struct Lines {
  S determinant;
  bool parallel;
};
/// The nearest points that were found.
template <class S, int N>
struct Closest {
  S s, t;
  Point<S, N> on_a, on_b;
};
/// Their square distance, and (r + s)^2.
template <class S>
struct Compared {
  S distance2, reach2;
};
template <class S, int N>
using MethodEvent = std::variant<Lines<S>, Closest<S, N>, Compared<S>>;

namespace detail {
template <class S, int N, class Trace>
bool within(const Capsule<S, N>& a, const Capsule<S, N>& b, const S& s, const S& t, Trace&& trace) {
  const Point<S, N> on_a = a.p + s * (a.q - a.p), on_b = b.p + t * (b.q - b.p);
  trace(Closest<S, N>{s, t, on_a, on_b});

  const Vector<S, N> gap = on_a - on_b;
  const S distance2 = gap.dot(gap), reach = a.radius + b.radius, reach2 = reach * reach;
  trace(Compared<S>{distance2, reach2});
  return distance2 <= reach2;
}
}  // namespace detail

/// Finds s where the lines come nearest, clamped; then the t nearest to that; if that is clamped, too, s anew. NaN: no.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.9, ClosestPtSegmentSegment, with 0 in place of its
/// epsilon.
template <class S, int N, class Trace = NoTrace>
bool clamped(const Capsule<S, N>& a, const Capsule<S, N>& b, Trace&& trace = {}) {
  const auto lines = [&](const auto& event) {
    if constexpr (requires { event.determinant; }) trace(Lines<S>{event.determinant, event.parallel});
  };
  const auto [s, t] = nearest_features::places<S, N>(Segment<S, N>{a.p, a.q}, Segment<S, N>{b.p, b.q}, lines);
  return detail::within<S, N>(a, b, s, t, trace);
}

/// Finds the nearest points by numerators and denominators. Lines count as parallel where the determinant is below
/// `small`; that is absolute, so that small capsules and slender angles fail; segments that are points are not handled.
/// NaN: no. Source: Sunday, Distance between 3D lines and segments (softSurfer, 2001), with 1e-8.
template <class S, int N, class Trace = NoTrace>
bool sunday(const Capsule<S, N>& a, const Capsule<S, N>& b, const S& small, Trace&& trace = {}) {
  const Vector<S, N> u = a.q - a.p, v = b.q - b.p, w = a.p - b.p;
  const S uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const S determinant = uu * vv - uv * uv;
  const bool parallel = determinant < small;
  trace(Lines<S>{determinant, parallel});

  S s_num = S(0), s_den = S(1), t_num = vw, t_den = vv;
  if (!parallel) {
    s_num = uv * vw - vv * uw, s_den = determinant;
    t_num = uu * vw - uv * uw, t_den = determinant;
    if (s_num < S(0))
      s_num = S(0), t_num = vw, t_den = vv;
    else if (s_num > s_den)
      s_num = s_den, t_num = vw + uv, t_den = vv;
  }
  const auto nearest_on_a = [&](const S& along) {
    if (along < S(0))
      s_num = S(0);
    else if (along > uu)
      s_num = s_den;
    else
      s_num = along, s_den = uu;
  };
  if (t_num < S(0))
    t_num = S(0), nearest_on_a(-uw);
  else if (t_num > t_den)
    t_num = t_den, nearest_on_a(uv - uw);

  const auto quotient = [&](const S& num, const S& den) -> S {
    return (num < S(0) ? -num : num) < small ? S(0) : num / den;
  };
  return detail::within<S, N>(a, b, quotient(s_num, s_den), quotient(t_num, t_den), trace);
}

}  // namespace isect::capsule_capsule
