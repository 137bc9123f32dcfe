#pragma once
// Plane against cone as it is written in practice: for comparison. `relate` in isect/plane_cone.h is right for all
// input.

#include <Eigen/Geometry>
#include <algorithm>
#include <variant>

#include <isect/plane_cone.h>

namespace isect::plane_cone {

/// The heights of both ends of the axis, and how far a disc across it rises and falls; times the normal's length.
template <class S>
struct Heights {
  S start, end, reach;
};
template <class S>
using HeightsEvent = std::variant<Heights<S>>;

/// Whether the lowest point of the cone is not above the plane, and the highest not below it. Rounding may decide
/// there; squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float. NaN, as without an axis: no. Source:
/// Ericson, Real-Time Collision Detection (2005), 5.2.4.
template <class S, class Trace = NoTrace>
bool by_heights(const Plane<S, 3>& plane, const Cone<S>& cone, Trace&& trace = {}) {
  const Vector<S, 3> d = cone.base - cone.apex;
  const S apex = plane.normal.dot(cone.apex) + plane.d, base = plane.normal.dot(cone.base) + plane.d;
  const S reach = cone.radius * plane.normal.cross(d).norm() / d.norm();
  trace(Heights<S>{apex, base, reach});
  return std::min(apex, base - reach) <= S(0) && std::max(apex, base + reach) >= S(0);
}

}  // namespace isect::plane_cone
