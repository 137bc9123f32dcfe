#pragma once
// Ray against cone as it is written in practice: for comparison. `first_hit` in isect/ray_cone.h is right for all
// input.

#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include <isect/methods/point_cone.h>
#include <isect/ray_cone.h>

namespace isect::ray_cone {

/// a t^2 + 2 b t + c, whose roots are where the line meets the endless double cone.
template <class S>
struct Coefficients {
  S a, b, c;
};
/// Where the line meets the side or the base, and whether there is a point of the cone and of the range.
template <class S>
struct Candidate {
  S t;
  bool holds;
};
template <class S>
using QuadraticEvent = std::variant<Coefficients<S>, Candidate<S>>;

/// The least t of the range at which the cone begins: where the range does, at a root of the side's quadratic between
/// apex and base, or on the base. Rounding may decide there; squares overflow or vanish beyond 1e+-51 in double, 1e+-6
/// in float, as products of six lengths do. Source: Eberly, Intersection of a Line and a Cone (2000),
/// geometrictools.com.
template <class S, class Trace = NoTrace>
std::optional<S> quadratic(const Ray<S, 3>& ray, const Cone<S>& cone, Trace&& trace = {}) {
  const Vector<S, 3> d = cone.base - cone.apex, f = ray.origin - cone.apex, &u = ray.direction;
  const S dd = d.dot(d), along = f.dot(d), rate = u.dot(d), rr = cone.radius * cone.radius;
  const S a = dd * (dd * u.dot(u) - rate * rate) - rr * rate * rate;
  const S b = dd * (dd * f.dot(u) - along * rate) - rr * along * rate;
  const S c = dd * (dd * f.dot(f) - along * along) - rr * along * along;
  trace(Coefficients<S>{a, b, c});

  S first = std::numeric_limits<S>::infinity();
  const auto candidate = [&](const S& t, bool on_cone) {
    const bool holds = on_cone && ray.range.contains(t);
    trace(Candidate<S>{t, holds});
    if (holds) first = std::min(first, t);
  };
  if (std::isfinite(ray.range.lo))
    candidate(ray.range.lo, point_cone::by_height(Point<S, 3>(ray.at(ray.range.lo)), cone));
  const auto on_side = [&](const S& t) {
    const S height = along + t * rate;
    return height >= S(0) && height <= dd;
  };
  const S discriminant = b * b - a * c;
  if (a != S(0) && discriminant >= S(0)) {
    const S root = std::sqrt(discriminant), t0 = (-b - root) / a, t1 = (-b + root) / a;
    candidate(t0, on_side(t0));
    candidate(t1, on_side(t1));
  } else if (a == S(0) && b != S(0)) {
    const S t = -c / (2 * b);
    candidate(t, on_side(t));
  }
  if (rate != S(0)) {
    const S t = (dd - along) / rate;
    candidate(t, (f + t * u - d).squaredNorm() <= rr);
  }
  return first < std::numeric_limits<S>::infinity() ? std::optional(first) : std::nullopt;
}

}  // namespace isect::ray_cone
