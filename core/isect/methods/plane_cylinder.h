#pragma once
// Plane against cylinder as it is written in practice: for comparison. `relate` in isect/plane_cylinder.h is right for
// all input.

#include <Eigen/Geometry>
#include <algorithm>
#include <variant>

#include <isect/plane_cylinder.h>

namespace isect::plane_cylinder {

/// The heights of both ends of the axis, and how far a disc across it rises and falls; times the normal's length.
template <class S>
struct Heights {
  S start, end, reach;
};
template <class S>
using HeightsEvent = std::variant<Heights<S>>;

/// Whether the lowest point of the cylinder is not above the plane, and the highest not below it. Rounding may decide
/// there; squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float. NaN, as without an axis: no. Source:
/// Ericson, Real-Time Collision Detection (2005), 5.2.4.
template <class S, class Trace = NoTrace>
bool by_heights(const Plane<S, 3>& plane, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  const S at_p = plane.normal.dot(cylinder.p) + plane.d, at_q = plane.normal.dot(cylinder.q) + plane.d;
  const S reach =
      cylinder.radius * plane.normal.cross(cylinder.q - cylinder.p).norm() / (cylinder.q - cylinder.p).norm();
  trace(Heights<S>{at_p, at_q, reach});
  return std::min(at_p, at_q) - reach <= S(0) && std::max(at_p, at_q) + reach >= S(0);
}

}  // namespace isect::plane_cylinder
