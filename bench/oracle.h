#pragma once
// The truth about a ray and a sphere, from big integers and 400-digit roots.
//
// It shares the shapes with core and nothing else: the verdicts compare a root with an end of the range by
// squaring, where core asks for the sign of the sphere's equation at that end; the values come from the
// textbook quadratic, in so many digits that its cancellation does no harm. GMP and MPFR stay inside
// oracle.cpp.

#include <optional>

#include <isect/shapes.h>

namespace isect::oracle {

/// A real number: the nearest double (infinite beyond the largest), and what it leaves, rounded.
struct Real {
  double nearest = 0, rest = 0;
};

/// What a ray and a sphere truly have in common; the members mean what those of isect::RaySphere mean.
struct RaySphere {
  int line_roots = 0;
  Real t0, t1;  ///< of the whole line; meaningless when it misses
  Location origin = Location::out;
  std::optional<Real> surface;
  std::optional<Real> enter, leave;  ///< the ends of the part inside the closed ball
};

/// Coordinates must be finite; the range may be infinite. With other coordinates or a radius < 0 they share no point.
template <int N>
RaySphere ray_sphere(const Ray<double, N>& ray, const Sphere<double, N>& sphere);

/// The truth for the real numbers that float arguments denote.
template <int N>
RaySphere ray_sphere(const Ray<float, N>& ray, const Sphere<float, N>& sphere) {
  return ray_sphere<N>(
      Ray<double, N>{
          ray.origin.template cast<double>(), ray.direction.template cast<double>(), {ray.range.lo, ray.range.hi}},
      Sphere<double, N>{sphere.center.template cast<double>(), sphere.radius});
}

/// How far x lies from the true value, in units in the last place of S at the truth. An infinite x is right
/// where the truth rounds to infinity; NaN is infinitely wrong.
template <class S>
double ulps(S x, const Real& truth);

}  // namespace isect::oracle
