#pragma once
// Segment, with both ends as given, against sphere: as isect/ray_sphere.h for a ray, but the direction q - p need not
// be a vector of floating-point numbers.
//
// With f = p - c and d = q - p, nowhere rounded, the line p + t d meets the sphere at the roots of
//
//   d.d t^2 + 2 f.d t + f.f - r^2,   D = r^2 d.d - |f x d|^2,
//
// and an end x of the segment lies between them where |x - c|^2 < r^2, else before or after them by the sign of
// (x - c).d. Source: as there; isect/ray_capsule.h for the roots' values.

#include <optional>

#include <isect/ray_capsule.h>
#include <isect/ray_sphere.h>

namespace isect {

namespace segment_sphere {

using Event = ray_capsule::Event;

namespace detail {

/// The sign of the distance of x from the center compared with the radius.
template <int N, class Trace>
int beyond(const Point<double, N>& x, const Sphere<double, N>& ball, Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> f = difference<W, N>(x, ball.center);
        return dot(f, f) - W(ball.radius) * W(ball.radius);
      },
      trace);
}

/// Where the point at t, 0 or 1, lies among the roots of a line that has some.
template <int N, class Trace>
ray_sphere::AmongRoots among_roots(const Straight<N, true>& line, int t, const Sphere<double, N>& ball, Trace&& trace) {
  using ray_sphere::AmongRoots;
  const Point<double, N>& end = t == 0 ? line.origin : line.heading;
  const int c = beyond(end, ball, trace);
  if (c < 0) return AmongRoots::between;
  const int b =
      sign_of([&]<class W>() -> W { return dot(difference<W, N>(end, ball.center), line.template along<W>()); }, trace);
  if (c == 0) return b > 0 ? AmongRoots::exit : AmongRoots::entry;
  return b > 0 ? AmongRoots::after : AmongRoots::before;
}

template <class S, int N, class Trace>
RaySphere<S> meet(const Straight<N, true>& line, const Sphere<double, N>& ball, Trace&& trace) {
  const auto quadratic = [&]<class W>() -> Quadratic<W> {
    return ray_capsule::detail::ball<W, N>(line, ball.center, ball.radius);
  };
  const Interval<S> range = {S(0), S(1)};
  if (line.is_point()) {
    RaySphere<S> result;
    const int c = beyond(line.origin, ball, trace);
    result.origin = c < 0 ? Location::in : c == 0 ? Location::on : Location::out;
    if (c == 0) result.surface = S(0);
    if (c <= 0) result.solid = range;
    return result;
  }
  const int crossing = sign_of([&]<class W>() -> W { return quadratic.template operator()<W>().discriminant; }, trace);
  if (crossing < 0) return {};
  const ray_sphere::AmongRoots first = among_roots(line, 0, ball, trace), last = among_roots(line, 1, ball, trace);
  const ray_sphere::Verdict verdict = {crossing + 1, ray_sphere::detail::location(first), first, last};
  const S entry = root_of<S>(quadratic, -1, trace), exit = crossing == 0 ? entry : root_of<S>(quadratic, 1, trace);
  return ray_sphere::detail::report(range, verdict, {static_cast<double>(entry), static_cast<double>(exit)});
}

}  // namespace detail

}  // namespace segment_sphere

/// Where a segment with both ends as given meets a sphere, and which part of it lies in the ball: t = 0 at p, t = 1 at
/// q.
///
/// Every verdict (line_roots, origin, which is that of p, whether surface and solid have a value) is the true one for
/// all finite input of any magnitude. The roots, of the whole line through p and q, lie within 0.6 ulp of S of their
/// true values (and a unit of the least subnormal number where they are subnormal), t of the segment in [0, 1]; a root
/// too large for S is infinite. Touching counts. Where p is q there are no roots: `solid` is [0, 1] if the point lies
/// in the ball, `surface` 0 if it lies on the sphere. Radius 0 is a point, radius < 0 the empty set. NaN or an infinite
/// coordinate: no hit.
template <class S, int N, class Trace = NoTrace>
RaySphere<S> intersect(const Segment<S, N>& segment, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere) || !finite(segment)) return {};
  return in_doubles_first(
      [&](auto& listener) {
        return segment_sphere::detail::meet<S, N>(straight(segment), in_doubles(sphere), listener);
      },
      trace);
}

/// Whether the segment has a point in the ball: by signs alone. Exact.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Segment<S, N>& segment, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  return intersects(segment, Capsule<S, N>{sphere.center, sphere.center, sphere.radius}, trace);
}

/// The least t of [0, 1] at which the segment is in the ball.
template <class S, int N>
std::optional<S> first_hit(const Segment<S, N>& segment, const Sphere<S, N>& sphere) {
  const RaySphere<S> answer = intersect(segment, sphere);
  return answer.solid ? std::optional<S>(answer.solid->lo) : std::nullopt;
}

}  // namespace isect
