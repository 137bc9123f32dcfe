#pragma once
// How far apart two shapes are, as textbooks find it in floating point: for lessons and comparison. What is exact of
// two segments stands in isect/nearest_features.h.
//
// The distance of two sets is one number, but pairs of points at that distance may be many: of parallel segments a
// whole interval of pairs, of boxes that face each other a rectangle of pairs.
//
// Rounding may decide, and squares overflow or vanish beyond 1e+-154 in double, 1e+-19 in float.

#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace nearest_features {

// clang-format off
/// A point c and a segment: (c - p).d and d.d, with d = q - p.
template <class S> struct Along { S along, length2; };
/// The segment's point p + t d that is nearest to c.
template <class S, int N> struct Foot { S t; Point<S, N> at; S distance2; };

/// Two segments: the determinant of their lines, and whether the method takes them for parallel.
template <class S> struct Lines { S determinant; bool parallel; };
/// A place on a segment, p + t d: where the line of a is nearest to that of b, where the line of b is nearest to the
/// point of a, where the line of a is nearest to the point of b. It is numerator / denominator, then clamped.
enum class Find { on_a, on_b, again_on_a };
template <class S> struct Found { Find what; S numerator, denominator, clamped; };
/// The nearest points found.
template <class S, int N> struct Closest { S s, t; Point<S, N> on_a, on_b; S distance2; };

/// Two boxes, one axis: the intervals, the gap between them, 0 if there is none, and the sum of the squares so far.
template <class S> struct Gap { int axis; Interval<S> a, b; S gap, distance2; };

/// Two capsules: how far apart their segments may be.
template <class S> struct Bound { S bound; };
template <class S> struct Compared { S distance2, bound2; };
// clang-format on
template <class S, int N>
using PointEvent = std::variant<Along<S>, Foot<S, N>>;
template <class S, int N>
using SegmentEvent = std::variant<Lines<S>, Found<S>, Closest<S, N>>;
template <class S, int N>
using CapsuleEvent = std::variant<Bound<S>, Lines<S>, Found<S>, Closest<S, N>, Compared<S>>;
template <class S>
using BoxEvent = std::variant<Gap<S>>;

/// The square of the distance of a point from a segment. NaN: NaN, or the square of the distance from p.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.2, ClosestPtPointSegment.
template <class S, int N, class Trace = NoTrace>
S distance2(const Point<S, N>& c, const Segment<S, N>& segment, Trace&& trace = {}) {
  const Vector<S, N> d = segment.q - segment.p, w = c - segment.p;
  const S along = w.dot(d), length2 = d.dot(d);
  trace(Along<S>{along, length2});

  const S t = !(along > S(0)) ? S(0) : along >= length2 ? S(1) : along / length2;  // no 0 / 0 where p equals q
  const Point<S, N> at = segment.p + t * d;
  const Vector<S, N> f = c - at;
  const S squared = f.dot(f);
  trace(Foot<S, N>{t, at, squared});
  return squared;
}

namespace detail {

/// num / den clamped to [0, 1], den >= 0; 0 if num is 0 or NaN.
template <class S>
S clamped_quotient(const S& num, const S& den) {
  return !(num > S(0)) ? S(0) : num >= den ? S(1) : num / den;
}

template <class S, int N, class Trace>
S squared_distance(const Segment<S, N>& a, const Segment<S, N>& b, const S& s, const S& t, Trace&& trace) {
  const Point<S, N> on_a = a.p + s * (a.q - a.p), on_b = b.p + t * (b.q - b.p);
  const Vector<S, N> gap = on_a - on_b;
  const S squared = gap.dot(gap);
  trace(Closest<S, N>{s, t, on_a, on_b, squared});
  return squared;
}

/// The products that both ways with two segments need: u and v are the directions, w leads from a.p to b.p.
template <class S>
struct Products {
  S uu, uv, vv, uw, vw;
};
template <class S, int N>
Products<S> products(const Segment<S, N>& a, const Segment<S, N>& b) {
  const Vector<S, N> u = a.q - a.p, v = b.q - b.p, w = b.p - a.p;
  return {u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w)};
}

}  // namespace detail

/// Places of nearest points, a.p + s (a.q - a.p) and b.p + t (b.q - b.p).
template <class S>
struct Places {
  S s, t;
};

/// Finds s where the lines come nearest, clamped; then the t nearest to that; if that is clamped, too, s anew.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.9, ClosestPtSegmentSegment, with 0 in place of its
/// epsilon.
template <class S, int N, class Trace = NoTrace>
Places<S> places(const Segment<S, N>& a, const Segment<S, N>& b, Trace&& trace = {}) {
  const auto [uu, uv, vv, uw, vw] = detail::products<S, N>(a, b);
  const S determinant = uu * vv - uv * uv;
  const bool parallel = !(determinant > S(0));
  trace(Lines<S>{determinant, parallel});

  S s = S(0);
  if (!parallel) {
    const S numerator = uw * vv - uv * vw;
    s = detail::clamped_quotient<S>(numerator, determinant);
    trace(Found<S>{Find::on_a, numerator, determinant, s});
  }

  const S along = uv * s - vw;
  const S t = detail::clamped_quotient<S>(along, vv);
  trace(Found<S>{Find::on_b, along, vv, t});

  if (along <= S(0) || along >= vv) {
    const S back = along <= S(0) ? uw : uv + uw;
    s = detail::clamped_quotient<S>(back, uu);
    trace(Found<S>{Find::again_on_a, back, uu, s});
  }
  return {s, t};
}

/// The square of the distance of two segments.
template <class S, int N, class Trace = NoTrace>
S distance2(const Segment<S, N>& a, const Segment<S, N>& b, Trace&& trace = {}) {
  const Places<S> at = places<S, N>(a, b, trace);
  return detail::squared_distance<S, N>(a, b, at.s, at.t, trace);
}

/// Clamps both places each by itself, a usual bug: if one of them is moved, the other one is nearest no
/// more, and the result may be too large. For parallel lines s is 0.
template <class S, int N, class Trace = NoTrace>
S distance2_clamped_once(const Segment<S, N>& a, const Segment<S, N>& b, Trace&& trace = {}) {
  const auto [uu, uv, vv, uw, vw] = detail::products<S, N>(a, b);
  const S determinant = uu * vv - uv * uv;
  const bool parallel = !(determinant > S(0));
  trace(Lines<S>{determinant, parallel});

  const S on_a = parallel ? S(0) : uw * vv - uv * vw, on_b = parallel ? -vw : uv * uw - uu * vw;
  const S under_b = parallel ? vv : determinant;
  const S s = detail::clamped_quotient<S>(on_a, determinant), t = detail::clamped_quotient<S>(on_b, under_b);
  trace(Found<S>{Find::on_a, on_a, determinant, s});
  trace(Found<S>{Find::on_b, on_b, under_b, t});
  return detail::squared_distance<S, N>(a, b, s, t, trace);
}

/// The square of the distance of two boxes: the sum of the squares of their gaps, 0 where they meet. Neither is empty.
template <class S, int N, class Trace = NoTrace>
S distance2(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  S sum = S(0);
  for (int axis = 0; axis < N; ++axis) {
    const Interval<S> x = a.along(axis), y = b.along(axis);
    const S gap = x.hi < y.lo ? y.lo - x.hi : y.hi < x.lo ? x.lo - y.hi : S(0);
    sum = sum + gap * gap;
    trace(Gap<S>{axis, x, y, gap, sum});
  }
  return sum;
}

/// Whether the capsules come within `clearance` of each other: whether their segments are at most r + s + clearance
/// apart. A clearance below 0 asks whether they reach into each other as far as that. If the bound is below 0, no: its
/// square would not show that.
template <class S, int N, class Trace = NoTrace>
bool within(const Capsule<S, N>& a, const Capsule<S, N>& b, const S& clearance, Trace&& trace = {}) {
  const S bound = a.radius + b.radius + clearance;
  trace(Bound<S>{bound});
  if (bound < S(0)) return false;

  const S squared = distance2<S, N>(Segment<S, N>{a.p, a.q}, Segment<S, N>{b.p, b.q}, trace);
  const S bound2 = bound * bound;
  trace(Compared<S>{squared, bound2});
  return squared <= bound2;
}

/// Decides by the squares alone, a usual bug: a bound below 0 is taken for its size.
template <class S, int N, class Trace = NoTrace>
bool within_by_squares(const Capsule<S, N>& a, const Capsule<S, N>& b, const S& clearance, Trace&& trace = {}) {
  const S bound = a.radius + b.radius + clearance;
  const S squared = distance2<S, N>(Segment<S, N>{a.p, a.q}, Segment<S, N>{b.p, b.q}, trace);
  const S bound2 = bound * bound;
  trace(Compared<S>{squared, bound2});
  return squared <= bound2;
}

}  // namespace nearest_features

}  // namespace isect
