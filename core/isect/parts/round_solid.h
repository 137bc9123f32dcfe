#pragma once
// The form that a cylinder and a cone share: between two planes across their axis they are a solid of revolution, whose
// side is straight. With f leading from where the axis begins to a point, and d to where it ends, the point lies
// between the planes iff 0 <= f.d <= d.d, and it lies beside the axis by |f x d| / |d|. What the side allows there is
// r, or, for a cone, r f.d / d.d. So between the planes it lies in the solid iff
//
//   cylinder   |f x d|^2 - r^2 d.d <= 0,      cone   d.d |f x d|^2 - r^2 (f.d)^2 <= 0.
//
// For the core's own use.

#include <array>

#include <isect/numbers/predicate.h>
#include <isect/parts/point_segment.h>
#include <isect/shapes.h>

namespace isect::round_solid {

/// What the plane at an end of the axis has in common with the solid: the disc across the axis.
struct Disc {
  Point<double, 3> center;
  double radius;
};
/// The discs at both ends, in the order in which the axis runs.
inline std::array<Disc, 2> discs(const Cylinder<double>& c) { return {{{c.p, c.radius}, {c.q, c.radius}}}; }
inline std::array<Disc, 2> discs(const Cone<double>& c) { return {{{c.apex, 0}, {c.base, c.radius}}}; }

inline const Point<double, 3>& start(const Cylinder<double>& c) { return c.p; }
inline const Point<double, 3>& start(const Cone<double>& c) { return c.apex; }

/// d
template <PolynomialScalar W>
Components<W, 3> axis(const Cylinder<double>& c) {
  return difference<W>(c.q, c.p);
}
template <PolynomialScalar W>
Components<W, 3> axis(const Cone<double>& c) {
  return difference<W>(c.base, c.apex);
}

/// The symmetric bilinear form. Its value at f and f begins the side's equation; half of that value's derivative along
/// u is the form at f and u.
template <PolynomialScalar W>
W form(const Cylinder<double>& c, const Components<W, 3>& f, const Components<W, 3>& u) {
  const Components<W, 3> d = axis<W>(c);
  return dot(cross(f, d), cross(u, d));
}
template <PolynomialScalar W>
W form(const Cone<double>& c, const Components<W, 3>& f, const Components<W, 3>& u) {
  const Components<W, 3> d = axis<W>(c);
  return dot(d, d) * dot(cross(f, d), cross(u, d)) - W(c.radius) * W(c.radius) * dot(f, d) * dot(u, d);
}

/// Above 0 outside the side, by the equation above.
template <PolynomialScalar W>
W beside(const Cylinder<double>& c, const Components<W, 3>& f) {
  const Components<W, 3> d = axis<W>(c);
  return form<W>(c, f, f) - W(c.radius) * W(c.radius) * dot(d, d);
}
template <PolynomialScalar W>
W beside(const Cone<double>& c, const Components<W, 3>& f) {
  return form<W>(c, f, f);
}

/// The value of `beside` at f / k, times k^2.
template <PolynomialScalar W>
W beside(const Cylinder<double>& c, const Components<W, 3>& f, const W& k) {
  const Components<W, 3> d = axis<W>(c);
  return form<W>(c, f, f) - W(c.radius) * W(c.radius) * (k * k) * dot(d, d);
}
template <PolynomialScalar W>
W beside(const Cone<double>& c, const Components<W, 3>& f, const W&) {
  return form<W>(c, f, f);
}

/// Where a point lies: the signs of f.d, of (f - d).d, and of what the side's equation says.
struct Signs {
  int first, last, side;
};
template <class Solid, class Trace>
Signs signs(const Point<double, 3>& x, const Solid& solid, Trace&& trace) {
  const std::array<Disc, 2> ends = discs(solid);
  const auto above = [&](const Disc& end) {
    return sign_of([&]<class W>() -> W { return dot(difference<W>(x, end.center), axis<W>(solid)); }, trace);
  };
  const int first = above(ends[0]), last = above(ends[1]);
  return {first, last,
          sign_of([&]<class W>() -> W { return beside<W>(solid, difference<W>(x, start(solid))); }, trace)};
}
inline Location location(const Signs& at) {
  if (at.first < 0 || at.last > 0 || at.side > 0) return Location::out;
  return at.first > 0 && at.last < 0 && at.side < 0 ? Location::in : Location::on;
}

template <class Solid>
bool exists(const Solid& solid) {
  return !empty(solid) && finite(solid);
}

}  // namespace isect::round_solid
