#pragma once
// Clipping a ray, a line or a segment: which t are kept.
//
// A box keeps the stretch between the last entry and the first exit: isect/ray_aabb.h. A half-space n.x + D >= 0 keeps
// the t on one side of the crossing with its plane, t = -(n.o + D) / (n.d): beyond it where the ray heads up (n.d > 0),
// before it where it heads down; of a parallel ray it keeps all or nothing, by the side of its origin. Source: the
// note, N01; Cyrus, Beck, Computers & Graphics 3 (1978), for the parameters; Newman, Sproull, Principles of Interactive
// Computer Graphics (1973), for Cohen and Sutherland's outcodes.

#include <optional>
#include <variant>

#include <isect/ray_aabb.h>
#include <isect/ray_plane.h>

namespace isect {

namespace clip_segment {

namespace detail {

/// The slabs of a box on the line through both ends of a segment as given.
template <int N>
struct Slabs {
  const Segment<double, N>& segment;
  const Aabb<double, N>& box;

  // clang-format off
  template <PolynomialScalar W> W rate(int i) const { return difference<W>(segment.q[i], segment.p[i]); }
  template <PolynomialScalar W> W lo(int i) const { return difference<W>(box.lo[i], segment.p[i]); }
  template <PolynomialScalar W> W hi(int i) const { return difference<W>(box.hi[i], segment.p[i]); }
  // clang-format on
};

/// Where the plane lies on that line.
template <PolynomialScalar W, int N>
Ratio<W> parameter(const Segment<double, N>& segment, const Plane<double, N>& plane) {
  const Components<W, N> n = exactly<W>(plane.normal);
  return {-(dot(n, exactly<W>(segment.p)) + W(plane.d)), dot(n, difference<W>(segment.q, segment.p))};
}

/// The t of the range at which the height over the plane, den t - num, is not negative.
template <class S, class Text, class Trace>
std::optional<Interval<S>> keep_above(const Interval<S>& range, const Text& t, Trace&& trace) {
  if (!ray_range::has_points(range)) return {};
  const int heading = sign_of([&]<class W>() -> W { return t.template operator()<W>().den; }, trace);
  const int side = -sign_of([&]<class W>() -> W { return t.template operator()<W>().num; }, trace);
  trace(ray_plane::Decision{heading, side});
  if (heading == 0 && side < 0) return {};
  if (heading == 0) return range;

  const int lo = ray_range::compare(t, heading, range.lo, trace), hi = ray_range::compare(t, heading, range.hi, trace);
  if (heading > 0 ? hi > 0 : lo < 0) return {};       // all of the range lies below
  if (heading > 0 ? lo <= 0 : hi >= 0) return range;  // all of it above
  const S cut = ray_range::clamped(value_of<S>(t, trace), range);
  return heading > 0 ? Interval<S>{cut, range.hi} : Interval<S>{range.lo, cut};
}

}  // namespace detail

using Event = std::variant<ray_plane::Decision, Fallback>;

/// The sides of the box that a point lies beyond: bit 2i the lower one on axis i, bit 2i + 1 the upper one. 0: none,
/// the point is in the box. Comparisons only: exact.
template <class S, int N>
int outcode(const Point<S, N>& point, const Aabb<S, N>& box) {
  int code = 0;
  for (int i = 0; i < N; ++i) {
    if (point[i] < box.lo[i]) code |= 1 << 2 * i;
    if (point[i] > box.hi[i]) code |= 2 << 2 * i;
  }
  return code;
}

}  // namespace clip_segment

/// The t of the ray's range inside the closed box: intersect by its other name. See isect/ray_aabb.h.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> clip(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  return intersect(ray, box, trace);
}

/// The t of [0, 1] at which p + t (q - p) lies inside the closed box, both end points taken as given.
///
/// Whether there is one is true for all finite input of any magnitude. The ends lie within 2 ulp of S of the true
/// ones, in [0, 1], in order. An empty box, NaN or an infinite coordinate: nothing.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> clip(const Segment<S, N>& segment, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (empty(box) || !finite(segment) || !finite(box)) return {};
  const Segment<double, N> wide = cast<double>(segment);
  const Aabb<double, N> bounds = cast<double>(box);
  return slabs::detail::clip<S, N>({S(0), S(1)}, clip_segment::detail::Slabs<N>{wide, bounds}, trace);
}

/// The t of the ray's range on the plane or on the side that its normal points to, normal.x + d >= 0.
///
/// Whether there is one is true for all finite input of any magnitude; a ray that touches the plane with one end keeps
/// that t. The new end lies within 2 ulp of S of the true one, in the range. A zero direction makes the ray a point:
/// all or nothing. Nothing is kept for a zero normal, which makes no half-space, an empty range, NaN or an infinite
/// coordinate.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> clip(const Ray<S, N>& ray, const Plane<S, N>& half_space, Trace&& trace = {}) {
  if (!finite(ray) || !finite(half_space) || half_space.normal == Vector<S, N>::Zero()) return {};
  const Ray<double, N> wide = cast<double>(ray);
  const Plane<double, N> plane = cast<double>(half_space);
  const auto t = [&]<class W>() -> Ratio<W> { return ray_plane::detail::parameter<W>(wide, plane); };
  return clip_segment::detail::keep_above(ray.range, t, trace);
}

/// The t of [0, 1] at which p + t (q - p) lies in the half-space, both end points as given; otherwise as for a ray.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> clip(const Segment<S, N>& segment, const Plane<S, N>& half_space, Trace&& trace = {}) {
  if (!finite(segment) || !finite(half_space) || half_space.normal == Vector<S, N>::Zero()) return {};
  const Segment<double, N> wide = cast<double>(segment);
  const Plane<double, N> plane = cast<double>(half_space);
  const auto t = [&]<class W>() -> Ratio<W> { return clip_segment::detail::parameter<W>(wide, plane); };
  return clip_segment::detail::keep_above(Interval<S>{S(0), S(1)}, t, trace);
}

}  // namespace isect
