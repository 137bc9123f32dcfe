#pragma once
// Segment, with both ends as given, against plane: as isect/ray_plane.h for a ray, but the direction q - p need not be
// a vector of floating-point numbers.
//
// With the heights h(x) = n.x + D the segment meets the plane iff those of its ends have no common sign but 0; its line
// meets it at t = h(p) / n.(p - q), unless the denominator is 0. Source: as there.

#include <optional>
#include <variant>

#include <isect/point_plane.h>
#include <isect/ray_plane.h>

namespace isect {

namespace segment_plane {

/// The signs of n.(q - p), of h(p) and of h(q).
struct Decision {
  int heading, p, q;
};
using Event = std::variant<Decision, Fallback>;

namespace detail {

template <class S, int N, class Trace>
RayPlane<S> meet(const Segment<double, N>& segment, const Plane<double, N>& plane, Trace& trace) {
  const auto height = [&](const Point<double, N>& x) {
    return sign_of([&]<class W>() -> W { return plane_sphere::detail::height<W, N>(plane, x); }, trace);
  };
  const auto t = [&]<class W>() -> Ratio<W> {
    return {plane_sphere::detail::height<W, N>(plane, segment.p),
            dot(exactly<W, N>(plane.normal), difference<W, N>(segment.p, segment.q))};
  };
  const int fall = sign_of([&]<class W>() -> W { return t.template operator()<W>().den; }, trace);
  const int p = height(segment.p), q = height(segment.q);
  trace(Decision{-fall, p, q});

  RayPlane<S> result;
  result.parallel = fall == 0;
  result.coplanar = fall == 0 && p == 0;
  result.meets = p * q <= 0;
  if (fall == 0) return result;
  result.line = value_of<S>(t, trace);
  if (result.meets) result.t = ray_range::clamped(*result.line, Interval<S>{S(0), S(1)});
  return result;
}

}  // namespace detail

}  // namespace segment_plane

/// Where a segment with both ends as given meets a plane: t = 0 at p, t = 1 at q.
///
/// Every verdict (parallel, coplanar, whether line and t have a value, meets) is the true one for all finite input of
/// any magnitude. Both t lie within 2 ulp of S of the true value, that of the segment in [0, 1]; one too large for S is
/// infinite. Where p is q, it is parallel, and coplanar iff it lies on the plane. A zero normal, which makes no plane,
/// NaN or an infinite coordinate: no hit.
template <class S, int N, class Trace = NoTrace>
RayPlane<S> intersect(const Segment<S, N>& segment, const Plane<S, N>& plane, Trace&& trace = {}) {
  if (!finite(segment) || !finite(plane) || plane.normal.isZero(0)) return {};
  return in_doubles_first<S>(
      [&](auto& pass) { return segment_plane::detail::meet<S, N>(in_doubles(segment), in_doubles(plane), pass); },
      trace);
}

/// Whether the segment has a point in the plane: by the signs of its ends' heights alone.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Segment<S, N>& segment, const Plane<S, N>& plane, Trace&& trace = {}) {
  if (!finite(segment) || !finite(plane) || plane.normal.isZero(0)) return false;
  const Plane<double, N>& wall = in_doubles(plane);
  const auto height = [&](const Point<S, N>& x) {
    return sign_of([&]<class W>() -> W { return plane_sphere::detail::height<W, N>(wall, x.template cast<double>()); },
                   trace);
  };
  return height(segment.p) * height(segment.q) <= 0;
}

/// The least t of [0, 1] at which the segment is in the plane: 0 where it lies in there.
template <class S, int N>
std::optional<S> first_hit(const Segment<S, N>& segment, const Plane<S, N>& plane) {
  const RayPlane<S> answer = intersect(segment, plane);
  return answer.coplanar ? S(0) : answer.t;
}

}  // namespace isect
