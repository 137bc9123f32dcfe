#pragma once
// Ray against cylinder as it is written in practice: for comparison. `first_hit` in isect/ray_cylinder.h is right for
// all input.

#include <cmath>
#include <optional>
#include <variant>

#include <isect/ray_cylinder.h>

namespace isect::ray_cylinder {

/// a t^2 + 2 b t + c, whose roots are where the line meets the endless cylinder.
template <class S>
struct Coefficients {
  S a, b, c;
};
/// What is left of the range between the ends, and then within the side.
template <class S>
struct Left {
  S lo, hi;
};
template <class S>
using QuadraticEvent = std::variant<Coefficients<S>, Left<S>>;

/// The first t of the range between the ends and between the roots of the side's quadratic. Rounding may decide what is
/// touched; squares overflow or vanish beyond 1e+-77 in double, 1e+-9 in float, as products of four lengths do. Source:
/// Ericson, Real-Time Collision Detection (2005), 5.3.7, with its ends as slabs (5.3.3).
template <class S, class Trace = NoTrace>
std::optional<S> quadratic(const Ray<S, 3>& ray, const Cylinder<S>& cylinder, Trace&& trace = {}) {
  const Vector<S, 3> d = cylinder.q - cylinder.p, f = ray.origin - cylinder.p, &u = ray.direction;
  const S dd = d.dot(d), along = f.dot(d), rate = u.dot(d);
  S lo = ray.range.lo, hi = ray.range.hi;
  if (rate != S(0)) {
    const S at_p = -along / rate, at_q = (dd - along) / rate;
    lo = std::max(lo, std::min(at_p, at_q)), hi = std::min(hi, std::max(at_p, at_q));
  } else if (!(along >= S(0) && along <= dd)) {
    return {};
  }
  trace(Left<S>{lo, hi});

  const S a = dd * u.dot(u) - rate * rate, b = dd * f.dot(u) - along * rate;
  const S c = dd * (f.dot(f) - cylinder.radius * cylinder.radius) - along * along;
  trace(Coefficients<S>{a, b, c});
  if (a > S(0)) {
    const S discriminant = b * b - a * c;
    if (!(discriminant >= S(0))) return {};
    const S root = std::sqrt(discriminant);
    lo = std::max(lo, (-b - root) / a), hi = std::min(hi, (-b + root) / a);
    trace(Left<S>{lo, hi});
  } else if (!(c <= S(0))) {
    return {};
  }
  return lo <= hi ? std::optional(lo) : std::nullopt;
}

}  // namespace isect::ray_cylinder
