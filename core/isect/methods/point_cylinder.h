#pragma once
// Point against cylinder as it is written in practice: for comparison. `locate` in isect/point_cylinder.h is right for
// all input.

#include <variant>

#include <isect/point_cylinder.h>

namespace isect::point_cylinder {

/// The point's projection onto the axis, p + t (q - p), and its square distance from there.
template <class S>
struct Projected {
  S t, distance2;
};
template <class S>
using ProjectedEvent = std::variant<Projected<S>>;

/// Whether 0 <= t <= 1 and the point lies at most r from its projection. Rounding may decide there; squares overflow or
/// vanish beyond 1e+-154 in double, 1e+-19 in float; a radius below 0 is taken as it is. NaN, as without an axis: no.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.2 and 5.3.7.
template <class S, class Trace = NoTrace>
bool projected(const Point<S, 3>& point, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  const Vector<S, 3> d = cylinder.q - cylinder.p, f = point - cylinder.p;
  const S t = f.dot(d) / d.dot(d);
  const Vector<S, 3> off = f - t * d;
  const S distance2 = off.dot(off);
  trace(Projected<S>{t, distance2});
  return t >= S(0) && t <= S(1) && distance2 <= cylinder.radius * cylinder.radius;
}

}  // namespace isect::point_cylinder
