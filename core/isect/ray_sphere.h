#pragma once
// Ray against sphere, exactly right. The note's own three methods stand in isect/methods/ray_sphere.h.
//
// With f = o - c, the line o + t d meets the sphere |x - c| = r where
//
//   A t^2 + 2 B t + C = 0,    A = d.d,    B = f.d,    C = f.f - r^2,
//   t = (-B -+ sqrt D) / A,   D = B^2 - A C = A r^2 - |f x d|^2              (Lagrange's identity).
//
// Real roots mean that the *line* meets the sphere. The ends of the ray's range tell which of them the ray has:
// an end e lies between the roots where C(e) = |f + e d|^2 - r^2 < 0, and otherwise before or after them by the
// sign of B(e) = (f + e d).d. So every verdict is the sign of a polynomial, without a root and without a
// division.
//
// decide<W> in isect/parts/ray_sphere_roots.h is that text. It runs in double; where a sign is within its error bound,
// again in one finer arithmetic after the other, as in isect/parts/ray_sphere_settle.h, and at last in Exact, where
// every sign is certain. The values of t come from doubles and, for a double, a step of Newton's, ordinary_roots there;
// else from one of those.
//
// Source: the note, N16-N19; Haines, Gunther, Akenine-Moller, Precision improvements for ray/sphere
// intersection, Ray Tracing Gems (2019), ch. 7, for what goes wrong in the textbook forms. Bounds: derived
// there, tested in tests/core/ray_sphere_families_test.cpp and ray_sphere_properties_test.cpp against rationals and
// 400-digit roots.

#include <optional>
#include <type_traits>

#include <isect/parts/ray_sphere_meeting.h>
#include <isect/parts/ray_sphere_settle.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// What a ray and a sphere have in common. All t in units of |direction|.
template <class S>
struct RaySphere {
  int line_roots = 0;                ///< distinct roots of the whole line: 0, 1 (tangent) or 2
  Interval<S> roots = {S(1), S(0)};  ///< t0 <= t1 of the whole line; empty when it misses
  Location origin = Location::out;   ///< where the origin lies with respect to the ball
  std::optional<S> surface;          ///< the smallest root in the ray's range
  std::optional<Interval<S>> solid;  ///< the part of the range inside the closed ball

  /// Whether ray and ball have a common point.
  explicit operator bool() const { return solid.has_value(); }
};

/// Where a ray, segment or line meets a sphere, and which part of it lies in the ball.
///
/// Every verdict (line_roots, origin, whether surface and solid have a value) is the true one for all finite
/// input of any magnitude. Every t lies within 2.5 ulp of S of its true value, t of the range in the range; a
/// t too large for S is infinite. Touching counts: a tangent ray hits once, an origin on the surface hits at
/// t = 0 whatever its heading. A zero direction makes the ray a point: no roots, `solid` is the whole range
/// if the point lies in the ball, `surface` its lower end if it lies on the sphere. Radius 0 is a point,
/// radius < 0 the empty set. NaN or an infinite coordinate: no hit.
template <class S, int N, class Trace = NoTrace>
ISECT_INLINE RaySphere<S> intersect(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  using namespace ray_sphere::detail;
  if (!(sphere.radius >= 0)) return {};  // empty, or NaN
  const Ray<double, N>& wide = in_doubles(ray);
  const Sphere<double, N>& ball = in_doubles(sphere);
  if constexpr (!small_code && !heard<Trace>) {
    RaySphere<S> answer;
    if (!quick_answer(wide, ball, ray.range, answer)) [[unlikely]]
      answer = step_by_step_cold(wide, ball, ray.range, trace);
    return answer;
  } else {
    return step_by_step(wide, ball, ray.range, trace);
  }
}

/// Whether a point of the ray's range lies in the ball: what `intersect` says, by signs alone. No root is found, and
/// nothing is divided.
template <class S, int N, class Trace = NoTrace>
ISECT_INLINE bool intersects(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  using namespace ray_sphere::detail;
  if constexpr (!small_code && !heard<Trace>)
    if (from_zero_on(ray.range)) [[likely]]
      return quick_meeting(ray, sphere);
  return settled_meeting(ray, sphere, trace);
}

/// The least t of the ray's range at which it meets the ball: its lower end where it begins in there. It is that of
/// `solid` in `intersect`'s answer, and takes as long: both roots are found side by side.
template <class S, int N>
ISECT_INLINE std::optional<S> first_hit(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  const RaySphere<S> answer = intersect(ray, sphere);
  return answer.solid ? std::optional<S>(answer.solid->lo) : std::nullopt;
}

}  // namespace isect
