#pragma once
// Point against cone as it is written in practice: for comparison. `locate` in isect/point_cone.h is right for all
// input.

#include <variant>

#include <isect/point_cone.h>

namespace isect::point_cone {

/// How far up the axis the point lies, 0 at the apex and 1 at the base, and its distance from there.
template <class S>
struct Height {
  S t, distance;
};
template <class S>
using HeightEvent = std::variant<Height<S>>;

/// Whether 0 <= t <= 1 and the point lies at most t r from its projection. Rounding may decide there; squares overflow
/// or vanish beyond 1e+-154 in double, 1e+-19 in float. NaN, as without an axis: no. Source: Eberly, Intersection of a
/// Line and a Cone (2000), geometrictools.com, without its angle.
template <class S, class Trace = NoTrace>
bool by_height(const Point<S, 3>& point, const Cone<S>& cone, Trace&& trace = {}) {
  const Vector<S, 3> d = cone.base - cone.apex, f = point - cone.apex;
  const S t = f.dot(d) / d.dot(d);
  const S distance = (f - t * d).norm();
  trace(Height<S>{t, distance});
  return t >= S(0) && t <= S(1) && distance <= t * cone.radius;
}

}  // namespace isect::point_cone
