#pragma once
// Ray against plane.
//
// The line o + t d meets the plane n.x + D = 0 where n.o + D + t n.d = 0,
//
//   t = -(n.o + D) / (n.d),
//
// unless n.d = 0: then it is parallel, and lies in the plane iff n.o + D = 0. The numerator and the denominator tell
// whether t lies in the range. Source: the note, N16 and N20.

#include <optional>
#include <variant>

#include <isect/parts/ray_range.h>

namespace isect {

/// What a ray and a plane have in common. All t in units of |direction|.
template <class S>
struct RayPlane {
  bool parallel = false;  ///< n.d = 0: the line lies beside the plane, or in it
  bool coplanar = false;  ///< the line lies in the plane, so that every t of the range meets it
  std::optional<S> line;  ///< t on the whole line; none when parallel
  std::optional<S> t;     ///< the same when it lies in the range; none when coplanar
  bool meets = false;     ///< whether ray and plane have a common point

  explicit operator bool() const { return meets; }
};

namespace ray_plane {

/// The signs of n.d and n.o + D: how the ray heads, and on which side its origin lies.
struct Decision {
  int heading, side;
};
template <class S>
struct Hit {
  S t;
  bool in_range;
};
template <class S>
using Event = std::variant<Decision, Hit<S>, Fallback>;

namespace detail {

/// t on the whole line, as the numerator and the denominator.
template <PolynomialScalar W, int N>
ISECT_INLINE Ratio<W> parameter(const Ray<double, N>& ray, const Plane<double, N>& plane) {
  Ratio<W> t = ratio_of_dots<W, N>(plane.normal, ray.origin, ray.direction);
  t.num = -(t.num + W(plane.d));
  return t;
}

template <class S, int N, class Trace>
RayPlane<S> meet(const Ray<S, N>& ray, const Plane<S, N>& plane, Trace& trace) {
  RayPlane<S> result;
  if constexpr (!doubles_only<Trace>)
    if (!finite(ray) || !finite(plane) || plane.normal == Vector<S, N>::Zero()) return result;
  const Ray<double, N>& wide = in_doubles(ray);
  const Plane<double, N>& wall = in_doubles(plane);
  const auto t = [&]<class W>() __attribute__((always_inline))->Ratio<W> {
    return ray_plane::detail::parameter<W>(wide, wall);
  };

  const auto [ahead, heading, value] = signs_of<S>(t, trace);
  const int side = -ahead;
  trace(ray_plane::Decision{heading, side});

  result.parallel = heading == 0;
  result.coplanar = result.parallel && side == 0;
  if (result.parallel) {
    result.meets = result.coplanar && ray_range::has_points(ray.range);
    return result;
  }

  result.line = value ? *value : value_of<S>(t, trace);
  result.meets = ray_range::holds_value(wide.range, t, heading, *result.line, trace);
  trace(ray_plane::Hit<S>{*result.line, result.meets});
  if (result.meets) result.t = ray_range::clamped(*result.line, ray.range);
  return result;
}

}  // namespace detail

}  // namespace ray_plane

/// Where a ray, segment or line meets a plane.
///
/// Every verdict (parallel, coplanar, whether line and t have a value, meets) is the true one for all finite input of
/// any magnitude. Both t lie within 2 ulp of S of the true value, that of the range in the range; one too large for S
/// is infinite. `line` is given even outside the range. A zero direction makes the ray a point: parallel, and
/// coplanar iff it lies on the plane. A zero normal makes no plane, an empty range no ray; NaN or an infinite
/// coordinate: no hit.
template <class S, int N, class Trace = NoTrace>
RayPlane<S> intersect(const Ray<S, N>& ray, const Plane<S, N>& plane, Trace&& trace = {}) {
  return in_doubles_first<S>([&](auto& pass) { return ray_plane::detail::meet(ray, plane, pass); }, trace);
}

/// Whether ray and plane have a common point: what `intersect` says, by the signs of a height and a heading, and at an
/// end of the range. Nothing is divided.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Ray<S, N>& ray, const Plane<S, N>& plane, Trace&& trace = {}) {
  if (!finite(ray) || !finite(plane) || plane.normal.isZero(0) || !ray_range::has_points(ray.range)) return false;
  const Ray<double, N>& wide = in_doubles(ray);
  const Plane<double, N>& wall = in_doubles(plane);
  return in_doubles_first(
      [&](auto& pass) {
        const auto t = [&]<class W>() -> Ratio<W> { return ray_plane::detail::parameter<W>(wide, wall); };
        const int heading = sign_of([&]<class W>() -> W { return t.template operator()<W>().den; }, pass);
        if (heading == 0) return sign_of([&]<class W>() -> W { return t.template operator()<W>().num; }, pass) == 0;
        return ray_range::holds(wide.range, t, heading, pass);
      },
      trace);
}

/// The least t of the ray's range at which it meets the plane: its lower end where it lies in there.
template <class S, int N>
std::optional<S> first_hit(const Ray<S, N>& ray, const Plane<S, N>& plane) {
  const RayPlane<S> answer = intersect(ray, plane);
  return answer.coplanar && answer.meets ? ray.range.lo : answer.t;
}

}  // namespace isect
