#pragma once
// Segment against segment in the plane.
//
// Let a = pq and b = rs. They meet in one point iff p and q do not lie on the same side of the line rs, nor r and s
// on the same side of the line pq: four signs of orient2d. A sign of 0 names the end point that is the common one.
// All four are 0 for segments of one line, where points are ordered as their coordinates are, x first: the shared
// stretch runs from the greater lower end to the lesser upper end. Points are segments too, of any line through them.
//
// Where they cross, with P and Q the areas of r s p and r s q, of opposite signs,
//
//   x = (p Q - q P) / (Q - P).
//
// Source: de Berg et al., Computational Geometry (2008), ch. 2, for the cases; Cormen et al., Introduction to
// Algorithms, ch. 33, for the four orientations.

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/orient.h>
#include <isect/parts/ray_range.h>
#include <isect/parts/sort_points.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace segment_segment {

/// What two segments have in common.
enum class Meeting {
  disjoint,  ///< nothing
  touch,     ///< one point, which is an end point of at least one of them
  cross,     ///< one point, in the interior of both
  overlap    ///< a stretch of positive length
};

}  // namespace segment_segment

template <class S>
struct SegmentSegment {
  segment_segment::Meeting relation = segment_segment::Meeting::disjoint;
  std::optional<Point<S, 2>> point;     ///< the only common point: touch and cross
  std::optional<Segment<S, 2>> shared;  ///< the common stretch: overlap; its ends are end points, the lower x first

  explicit operator bool() const { return relation != segment_segment::Meeting::disjoint; }
};

namespace segment_segment {

/// The bounding boxes are disjoint.
struct Apart {};
/// The sides of r and s beside a = pq, of p and q beside b = rs, as orient2d gives them. Those of p and q are not asked
/// where r and s lie on one side of a.
struct Sides {
  int r, s;
  std::optional<int> p = {}, q = {};
};
using Event = std::variant<Apart, Sides, Fallback>;

namespace detail {

/// Returns the segment from left to right.
template <class S>
Segment<S, 2> ordered(const Segment<S, 2>& a) {
  return before(a.q, a.p) ? Segment<S, 2>{a.q, a.p} : a;
}

template <class S>
bool boxes_apart(const Segment<S, 2>& a, const Segment<S, 2>& b) {
  return (a.p.cwiseMax(a.q).array() < b.p.cwiseMin(b.q).array()).any() ||
         (b.p.cwiseMax(b.q).array() < a.p.cwiseMin(a.q).array()).any();
}

template <class Trace>
Sides sides(const Segment<double, 2>& a, const Segment<double, 2>& b, Trace&& trace) {
  Sides s = {orient2d(a.p, a.q, b.p, trace), orient2d(a.p, a.q, b.q, trace)};
  if (s.r * s.s <= 0) s.p = orient2d(b.p, b.q, a.p, trace), s.q = orient2d(b.p, b.q, a.q, trace);
  return s;
}

/// Coordinate i of the point where two segments cross, within 2 ulp of S and within both boxes.
template <class S, class Trace>
S crossing(const Segment<S, 2>& a, const Segment<S, 2>& b, int i, Trace&& trace) {
  const Segment<double, 2> wide_a = cast<double>(a), wide_b = cast<double>(b);
  const auto x = [&]<class W>() -> Ratio<W> {
    const W p = orient::detail::area2<W>(wide_b.p, wide_b.q, wide_a.p),
            q = orient::detail::area2<W>(wide_b.p, wide_b.q, wide_a.q);
    return {W(wide_a.p[i]) * q - W(wide_a.q[i]) * p, q - p};
  };
  const Interval<S> of_a = {std::min(a.p[i], a.q[i]), std::max(a.p[i], a.q[i])};
  const Interval<S> of_b = {std::min(b.p[i], b.q[i]), std::max(b.p[i], b.q[i])};
  return ray_range::clamped(ray_range::clamped(value_of<S>(x, trace), of_a), of_b);
}

/// What two segments on one line have in common.
template <class S>
SegmentSegment<S> collinear(const Segment<S, 2>& a, const Segment<S, 2>& b) {
  const Segment<S, 2> first = ordered(a), second = ordered(b);
  const Point<S, 2> lo = before(first.p, second.p) ? second.p : first.p;
  const Point<S, 2> hi = before(first.q, second.q) ? first.q : second.q;
  if (before(hi, lo)) return {};
  if (before(lo, hi)) return {Meeting::overlap, {}, Segment<S, 2>{lo, hi}};
  return {Meeting::touch, lo, {}};
}

}  // namespace detail

}  // namespace segment_segment

/// What two closed segments have in common, with their end points as given.
///
/// The relation is true for all finite input of any magnitude. A touch's point and an overlap's ends are end points
/// of the input, exactly; each coordinate of a crossing lies within 2 ulp of S of the true one, and within both
/// bounding boxes. A segment whose ends coincide is a point: it touches or is disjoint. NaN or an infinite
/// coordinate: disjoint.
template <class S, class Trace = NoTrace>
SegmentSegment<S> intersect(const Segment<S, 2>& a, const Segment<S, 2>& b, Trace&& trace = {}) {
  using segment_segment::Meeting;
  if (!finite(a) || !finite(b)) return {};
  if (segment_segment::detail::boxes_apart(a, b)) {
    trace(segment_segment::Apart{});
    return {};
  }

  const segment_segment::Sides side = segment_segment::detail::sides(cast<double>(a), cast<double>(b), trace);
  trace(side);
  if (!side.p || *side.p * *side.q > 0) return {};
  if (side.r == 0 && side.s == 0 && side.p == 0 && side.q == 0) return segment_segment::detail::collinear(a, b);

  if (side.p == 0) return {Meeting::touch, a.p, {}};
  if (side.q == 0) return {Meeting::touch, a.q, {}};
  if (side.r == 0) return {Meeting::touch, b.p, {}};
  if (side.s == 0) return {Meeting::touch, b.q, {}};
  const S x = segment_segment::detail::crossing(a, b, 0, trace), y = segment_segment::detail::crossing(a, b, 1, trace);
  return {Meeting::cross, Point<S, 2>(x, y), {}};
}

/// Whether two closed segments have a common point. Exact; see intersect.
template <class S, class Trace = NoTrace>
bool intersects(const Segment<S, 2>& a, const Segment<S, 2>& b, Trace&& trace = {}) {
  if (!finite(a) || !finite(b)) return false;
  if (segment_segment::detail::boxes_apart(a, b)) {
    trace(segment_segment::Apart{});
    return false;
  }
  const segment_segment::Sides side = segment_segment::detail::sides(cast<double>(a), cast<double>(b), trace);
  trace(side);
  return side.p && *side.p * *side.q <= 0;  // collinear ones with common boxes meet
}

}  // namespace isect
