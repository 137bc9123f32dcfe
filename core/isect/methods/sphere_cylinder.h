#pragma once
// Sphere against cylinder as it is written in practice: for comparison. `intersects` in isect/sphere_cylinder.h is
// right for all input.

#include <algorithm>
#include <variant>

#include <isect/sphere_cylinder.h>

namespace isect::sphere_cylinder {

/// How far beyond an end and beside the cylinder the ball's center lies; 0 where it does not.
template <class S>
struct Gaps {
  S beyond, beside;
};
template <class S>
using GapsEvent = std::variant<Gaps<S>>;

/// Whether the point that is nearest by both coordinates, along the axis and across it, lies at most s away. Rounding
/// may decide there; squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float; a radius below 0 is taken as
/// it is. NaN, as without an axis: no. Source: Ericson, Real-Time Collision Detection (2005), 5.1.3, with a disc for a
/// rectangle.
template <class S, class Trace = NoTrace>
bool clamped(const Sphere<S, 3>& sphere, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  const Vector<S, 3> d = cylinder.q - cylinder.p, f = sphere.center - cylinder.p;
  const S length = d.norm(), along = f.dot(d) / length;
  const S across = (f - (along / length) * d).norm();
  const S beyond = std::max(S(0), std::max(-along, along - length)), beside = std::max(S(0), across - cylinder.radius);
  trace(Gaps<S>{beyond, beside});
  return length > S(0) && beyond * beyond + beside * beside <= sphere.radius * sphere.radius;
}

}  // namespace isect::sphere_cylinder
