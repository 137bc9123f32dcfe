#pragma once
// Sphere against cone as it is written in practice: for comparison. `intersects` in isect/sphere_cone.h is right for
// all input.

#include <algorithm>
#include <cmath>
#include <variant>

#include <isect/sphere_cone.h>

namespace isect::sphere_cone {

/// The ball's center along the axis and beside it, and its distance from the triangle that the cone is there.
template <class S>
struct InProfile {
  S along, beside, distance;
};
template <class S>
using ProfileEvent = std::variant<InProfile<S>>;

/// Uses the distance from half a triangle in the plane through the axis and the center. Rounding may decide there;
/// squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float; a radius below 0 is taken as it is. NaN, as
/// without an axis: no. Source: Ericson, Real-Time Collision Detection (2005), 5.1.5, in the plane.
template <class S, class Trace = NoTrace>
bool by_profile(const Sphere<S, 3>& sphere, const Cone<S>& cone, Trace&& trace = {}) {
  const Vector<S, 3> d = cone.base - cone.apex, f = sphere.center - cone.apex;
  const S length = d.norm(), along = f.dot(d) / length, r = cone.radius;
  const S beside = (f - (along / length) * d).norm();
  const auto distance_from = [&](const S& x, const S& y, const S& u, const S& v) {  // x, y and u, v farther
    const S t = std::clamp(((along - x) * u + (beside - y) * v) / (u * u + v * v), S(0), S(1));
    const S dx = along - (x + t * u), dy = beside - (y + t * v);
    return std::sqrt(dx * dx + dy * dy);
  };
  S distance = 0;
  if (!(along >= S(0) && along <= length && beside * length <= r * along)) {
    distance = distance_from(S(0), S(0), length, r);
    if (r > S(0)) distance = std::min(distance, distance_from(length, S(0), S(0), r));
  }
  trace(InProfile<S>{along, beside, distance});
  return length > S(0) && distance <= sphere.radius;
}

}  // namespace isect::sphere_cone
