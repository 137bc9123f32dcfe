#pragma once
// Capsule against capsule.
//
// They meet iff their segments come within r + s of each other. In the plane segments that cross have the distance 0.
// In space let n = u x v be the normal of both directions and w lead from one start to the other: the lines come
// nearest at (w x v).n / n.n of the first and (w x u).n / n.n of the second. Where both lie strictly between 0 and 1,
// that is the segments' distance, |w.n| / |n|; else an end of one segment is nearest. All is compared multiplied out:
// no division, no square root.
//
// One capsule lies inside the other iff the balls around its ends do, as the outer one is convex.
//
// Source: Ericson, Real-Time Collision Detection (2005), 4.5.1 and 5.1.9.

#include <algorithm>
#include <array>
#include <functional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/orient.h>
#include <isect/parts/point_segment.h>
#include <isect/parts/unit_of_length.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace capsule_capsule {

using point_segment::Nearest;

/// Whether both lines are nearest to each other strictly between the ends; and if so, the sign of that distance
/// compared with r + s.
struct Between {
  bool holds;
  int sign;
};
/// An end of one segment (0: p of a, 1: q of a, 2: p of b, 3: q of b) and the other segment's point nearest to it; the
/// sign of their distance compared with r + s.
struct End {
  int end;
  Nearest nearest;
  int sign;
};
/// relate: whether a lies in b, b in a.
struct Contained {
  bool a, b;
};
using Event = std::variant<Between, End, Contained, Fallback>;

namespace detail {
/// Whether the segments cross, strictly between their ends.
template <class Trace>
Between between_ends(const Capsule<double, 2>& a, const Capsule<double, 2>& b, Trace&& trace) {
  const auto parted = [&](const Capsule<double, 2>& x, const Capsule<double, 2>& y) {
    return orient2d(x.p, x.q, y.p, trace) * orient2d(x.p, x.q, y.q, trace) < 0;
  };
  if (!parted(a, b) || !parted(b, a)) return {};
  return {true, a.radius > 0 || b.radius > 0 ? -1 : 0};
}

template <class Trace>
Between between_ends(const Capsule<double, 3>& a, const Capsule<double, 3>& b, Trace&& trace) {
  // The place of the nearest point on one line, times n.n, or what is left to the line's end
  const auto place = [&]<class W>(bool on_a, bool left) -> W {
    const Components<W, 3> u = difference<W, 3>(a.q, a.p), v = difference<W, 3>(b.q, b.p);
    const Components<W, 3> w = difference<W, 3>(b.p, a.p), n = cross(u, v);
    const W numerator = dot(cross(w, on_a ? v : u), n);
    return left ? dot(n, n) - numerator : numerator;
  };
  for (const bool on_a : {true, false})
    for (const bool left : {false, true})
      if (sign_of([&]<class W>() -> W { return place.template operator()<W>(on_a, left); }, trace) <= 0) return {};
  const auto excess = [&]<class W>() -> W {
    const Components<W, 3> n = cross(difference<W, 3>(a.q, a.p), difference<W, 3>(b.q, b.p));
    const W height = dot(difference<W, 3>(b.p, a.p), n), reach = W(a.radius) + W(b.radius);
    return height * height - reach * reach * dot(n, n);
  };
  return {true, sign_of(excess, trace)};
}

/// The sign of the segments' distance compared with r + s. Finite, not empty.
template <int N, class Trace>
int compare(const Capsule<double, N>& a, const Capsule<double, N>& b, Trace&& trace) {
  const Between inner = between_ends(a, b, trace);
  trace(inner);
  if (inner.holds) return inner.sign;

  int least = 1;
  const Point<double, N>* const ends[] = {&a.p, &a.q, &b.p, &b.q};
  for (int i = 0; i < 4 && least >= 0; ++i) {
    const Capsule<double, N>& other = i < 2 ? b : a;
    const Nearest nearest = point_segment::detail::nearest<N>(*ends[i], other.p, other.q, trace);
    const int sign = point_segment::detail::compare<N>(*ends[i], other.p, other.q, nearest, a.radius, b.radius,
                                                       std::plus<>(), trace);
    trace(End{i, nearest, sign});
    least = std::min(least, sign);
  }
  return least;
}

/// Whether some point is interior to both of two segments that have a common point and neither of which contains the
/// other: whether they cross between their ends, or an end of each lies on the other and these ends are two points.
template <int N, class Trace>
bool segments_overlap(const Capsule<double, N>& a, const Capsule<double, N>& b, Trace&& trace) {
  if (between_ends(a, b, trace).holds) return true;
  const auto on = [&](const Point<double, N>& end, const Capsule<double, N>& other) {
    const Nearest nearest = point_segment::detail::nearest<N>(end, other.p, other.q, trace);
    return point_segment::detail::compare<N>(end, other.p, other.q, nearest, 0.0, 0.0, std::plus<>(), trace) == 0;
  };
  for (const Point<double, N>* const of_a : {&a.p, &a.q})
    for (const Point<double, N>* const of_b : {&b.p, &b.q})
      if (*of_a != *of_b && on(*of_a, b) && on(*of_b, a)) return true;
  return false;
}

/// Whether a lies in b.
template <int N, class Trace>
bool inside(const Capsule<double, N>& a, const Capsule<double, N>& b, Trace&& trace) {
  if (a.radius > b.radius) return false;
  for (const Point<double, N>* const end : {&a.p, &a.q}) {
    const Nearest nearest = point_segment::detail::nearest<N>(*end, b.p, b.q, trace);
    if (point_segment::detail::compare<N>(*end, b.p, b.q, nearest, b.radius, a.radius, std::minus<>(), trace) > 0)
      return false;
  }
  return true;
}
}  // namespace detail

}  // namespace capsule_capsule

/// Whether the capsules have a common point. Exact; an empty one, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Capsule<S, N>& a, const Capsule<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b)) return false;
  return in_doubles_first(
      [&](auto& listener) {
        return settled_in_own_unit<decltype(listener)>(
            in_doubles(a), in_doubles(b), [&](const Capsule<double, N>& x, const Capsule<double, N>& y) {
              return capsule_capsule::detail::compare<N>(x, y, listener) <= 0;
            });
      },
      trace);
}

/// How the capsules lie. Exact. Equal means the same set: the ends may be swapped. A capsule of radius 0 is a segment:
/// two of them overlap where they cross between their ends or share a stretch. An empty one, NaN or an infinite
/// coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Capsule<S, N>& a, const Capsule<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b)) return Relation::disjoint;
  return in_doubles_first(
      [&](auto& listener) {
        const Capsule<double, N> wide_a = cast<double>(a), wide_b = cast<double>(b);
        const int reach = capsule_capsule::detail::compare<N>(wide_a, wide_b, listener);
        if (reach > 0) return Relation::disjoint;

        const capsule_capsule::Contained inside = {capsule_capsule::detail::inside<N>(wide_a, wide_b, listener),
                                                   capsule_capsule::detail::inside<N>(wide_b, wide_a, listener)};
        listener(inside);
        if (inside.a) return inside.b ? Relation::equal : Relation::a_inside_b;
        if (inside.b) return Relation::b_inside_a;
        const bool segments = a.radius == 0 && b.radius == 0;
        const bool overlap =
            segments ? capsule_capsule::detail::segments_overlap<N>(wide_a, wide_b, listener) : reach < 0;
        return overlap ? Relation::overlapping : Relation::touching;
      },
      trace);
}

}  // namespace isect
