#pragma once
// Ray against sphere by quadratics that cancel less: what numerical texts recommend in place of the note's formulas.
// They are for comparison; `intersect` in isect/ray_sphere.h is right where these are still wrong.
//
// Each returns what the methods of isect/methods/ray_sphere.h return, with the same events, under the same limits:
// rounding may decide wrongly near tangency, and squares overflow or vanish beyond 1e+-150 in double.

#include <cmath>
#include <optional>

#include <isect/methods/ray_sphere.h>

namespace isect::ray_sphere {

namespace detail {

/// The two roots from half of B and the root of the discriminant: first the one whose two terms have equal signs, then
/// the other from the product of the roots, C / A. Only B and the root itself no longer cancel; B and C still do.
template <class S, class Trace>
std::optional<S> stable_quotients(const S& a, const S& b, const S& c, const S& discriminant, const Interval<S>& range,
                                  Trace&& trace) {
  using std::sqrt;
  const S root = sqrt(discriminant);
  const S q = b > S(0) ? -b - root : -b + root;
  const S far = q / a, near = q == S(0) ? far : c / q;

  const S t1 = b > S(0) ? far : near;
  trace(Root<S>{0, t1});

  const S t2 = b > S(0) ? near : far;
  trace(Root<S>{1, t2});

  return first_in_range(t1, t2, range, trace);
}

}  // namespace detail

/// Works as half_b, with stable roots. Source: Press et al., Numerical Recipes, 3rd ed. (2007), 5.6.
template <class S, int N, class Trace = NoTrace>
std::optional<S> stable_roots(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  const Vector<S, N> f = ray.origin - sphere.center;
  trace(FromCenter<S, N>{f});

  const S a = ray.direction.dot(ray.direction);
  trace(CoefficientA<S>{a});

  const S b = f.dot(ray.direction);
  trace(CoefficientB<S>{b});

  const S c = f.dot(f) - sphere.radius * sphere.radius;
  trace(CoefficientC<S>{c});

  const S discriminant = b * b - a * c;
  trace(Discriminant<S>{discriminant});

  const bool misses = !(discriminant >= S(0));  // NaN misses
  trace(LineMisses<S>{discriminant, misses});
  if (misses) {
    trace(Miss{});
    return {};
  }

  return detail::stable_quotients(a, b, c, discriminant, ray.range, trace);
}

/// The discriminant from the vector that leads from the center to the line's nearest point, so that large squares never
/// meet, then stable roots. C still loses digits when the origin is near the surface of a large sphere.
/// Source: Haines, Guenther, Akenine-Moeller, Precision improvements for ray/sphere intersection, in Ray Tracing Gems
/// (2019), ch. 7.
template <class S, int N, class Trace = NoTrace>
std::optional<S> robust(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  const Vector<S, N> f = ray.origin - sphere.center;
  trace(FromCenter<S, N>{f});

  const S a = ray.direction.dot(ray.direction);
  trace(CoefficientA<S>{a});

  const S b = f.dot(ray.direction);
  trace(CoefficientB<S>{b});

  const S r2 = sphere.radius * sphere.radius;
  const S c = f.dot(f) - r2;
  trace(CoefficientC<S>{c});

  const Vector<S, N> foot = f - (b / a) * ray.direction;
  const S discriminant = a * (r2 - foot.dot(foot));
  trace(Discriminant<S>{discriminant});

  const bool misses = !(discriminant >= S(0));  // NaN misses
  trace(LineMisses<S>{discriminant, misses});
  if (misses) {
    trace(Miss{});
    return {};
  }

  return detail::stable_quotients(a, b, c, discriminant, ray.range, trace);
}

}  // namespace isect::ray_sphere
