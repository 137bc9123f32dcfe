#pragma once
// Ray, segment or line against capsule: whether they meet, and which part of the one lies in the other.
//
// They meet iff the ray comes within r of the capsule's axis. The nearest points of both are an end of the axis and the
// ray's point nearest to it, or an end of the ray and the axis' point nearest to it, or lie between the ends of both.
// With w leading from the ray's origin o to the axis p q, v = q - p and n = d x v, the lines come nearest at
// t = (w x v).n / n.n of the ray and (w x d).n / n.n of the axis, |w.n| / |n| apart. In the plane lines that cross have
// the distance 0. All is compared multiplied out: no division, no square root.
//
// Where the whole line enters the capsule. The capsule is the balls around p and q and the part of the cylinder around
// the axis between its ends; all of it lies in the endless cylinder. Let the line enter that one at t*. If t* is beside
// the axis, the line enters the capsule there. If it lies before p, seen along v, the ball around p is entered: until
// the line is beside the axis it is only there that the capsule is, and it comes beside it, if at all, on the disc
// across p, which is that ball's. Beyond q likewise, and where the line leaves. Along v, t* lies at
//
//   v.v (w x d).n / n.n  -+  d.v sqrt(v.v (r^2 n.n - (w.n)^2)) / n.n   from p.
//
// So it is before p if neither term is positive; and where the terms have opposite signs, the first one decides iff the
// line crosses the plane across p outside the disc, |d.v (o - p) - (o - p).v d| > r |d.v|: that is the sign of the
// difference of their squares. About q the same. Then t is a root of one quadratic, of a ball or of the cylinder:
//
//   d.d t^2 + 2 f.d t + f.f - r^2,   D = r^2 d.d - |f x d|^2,                        f = o - p, or o - q;
//   n.n t^2 + 2 n.(f x v) t + |f x v|^2 - r^2 v.v,   D = v.v (r^2 n.n - (f.n)^2),    f = o - p.
//
// Source: Ericson, Real-Time Collision Detection (2005), 5.1.8, 5.1.9 and 5.3.7.

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/numbers/root.h>
#include <isect/parts/point_segment.h>
#include <isect/parts/ray_range.h>
#include <isect/parts/straight.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace ray_capsule {

/// Whether both lines are nearest to each other strictly between the ends; and if so, the sign of that distance
/// compared with r.
struct Between {
  bool holds;
  int sign;
};
/// An end (0: p, 1: q of the axis, 2: the first, 3: the last point of the ray), and the sign of its distance from the
/// other one compared with r.
struct End {
  int end;
  int sign;
};
/// The part of the surface that the line passes: the ball around an end, or the side between them.
enum class Piece { p, q, side };
/// Where the whole line enters the capsule, or leaves it.
struct Passage {
  bool leaves;
  Piece through;
};
using Event = std::variant<Between, End, Passage, Fallback>;

namespace detail {

// The compiler reads a text once for each arithmetic that may settle it, which takes most of its time here. So an end
// is told to a text as a number or a point, and one text serves all ends.

/// The sign of the distance of the line's point at t from c compared with r.
template <int N, bool ends, class Trace>
int beyond(const Point<double, N>& c, const Straight<N, ends>& line, double t, double r, Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> x = seen_from<W, N>(c, line, t);
        return dot(x, x) - W(r) * W(r);
      },
      trace);
}

/// The sign of the distance of c from the line's range compared with r. The direction is not 0.
template <int N, bool ends, class Trace>
int compare(const Point<double, N>& c, const Straight<N, ends>& line, double r, Trace&& trace) {
  const auto onwards = [&](double t) {  // the sign of what is left from the line's point at t to the nearest one
    return -sign_of([&]<class W>() -> W { return dot(seen_from<W, N>(c, line, t), line.template along<W>()); }, trace);
  };
  if (std::isfinite(line.range.lo) && onwards(line.range.lo) <= 0) return beyond<N>(c, line, line.range.lo, r, trace);
  if (std::isfinite(line.range.hi) && onwards(line.range.hi) >= 0) return beyond<N>(c, line, line.range.hi, r, trace);
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> d = line.template along<W>();
        return point_segment::detail::cross_squared(seen_from<W, N>(c, line, 0), d) - W(r) * W(r) * dot(d, d);
      },
      trace);
}

/// The sign of the distance of the line's point at t from the axis compared with r.
template <int N, bool ends, class Trace>
int compare(const Straight<N, ends>& line, double t, const Capsule<double, N>& capsule, Trace&& trace) {
  const auto along = [&](const Point<double, N>& end) {
    return sign_of(
        [&]<class W>() -> W { return dot(seen_from<W, N>(end, line, t), difference<W, N>(capsule.q, capsule.p)); },
        trace);
  };
  if (along(capsule.p) <= 0) return beyond<N>(capsule.p, line, t, capsule.radius, trace);
  if (along(capsule.q) >= 0) return beyond<N>(capsule.q, line, t, capsule.radius, trace);
  return sign_of(
      [&]<class W>() -> W {
        const Components<W, N> v = difference<W, N>(capsule.q, capsule.p);
        return point_segment::detail::cross_squared(seen_from<W, N>(capsule.p, line, t), v) -
               W(capsule.radius) * W(capsule.radius) * dot(v, v);
      },
      trace);
}

template <PolynomialScalar W>
W cross(const Components<W, 2>& x, const Components<W, 2>& y) {
  return x[0] * y[1] - x[1] * y[0];
}

/// Where the lines come nearest, on the ray and on the axis: quotients of polynomials, with one denominator.
template <PolynomialScalar W, int N>
struct Places {
  W ray, axis, all;
};
template <PolynomialScalar W, int N, bool ends>
Places<W, N> places(const Straight<N, ends>& line, const Capsule<double, N>& capsule) {
  const Components<W, N> d = line.template along<W>(), v = difference<W, N>(capsule.q, capsule.p),
                         w = difference<W, N>(capsule.p, line.origin);
  if constexpr (N == 2) {
    return {cross(w, v), cross(w, d), cross(d, v)};
  } else {
    const Components<W, 3> n = isect::cross(d, v);
    return {dot(isect::cross(w, v), n), dot(isect::cross(w, d), n), dot(n, n)};
  }
}
/// The sign of their denominator, in space at least 0; 0 if the lines are parallel, or one of them is a point.
template <int N, bool ends, class Trace>
int crossing(const Straight<N, ends>& line, const Capsule<double, N>& capsule, Trace&& trace) {
  return sign_of([&]<class W>() -> W { return places<W, N>(line, capsule).all; }, trace);
}

/// The sign of how far from an end (0: p, 1: q of the axis, 2: the first, 3: the last point of the ray) towards the
/// other one the lines come nearest, times their denominator.
template <int N, bool ends, class Trace>
int past(int end, const Straight<N, ends>& line, const Capsule<double, N>& capsule, Trace&& trace) {
  return sign_of(
      [&]<class W>() -> W {
        const Places<W, N> at = places<W, N>(line, capsule);
        if (end == 0) return at.axis;
        if (end == 1) return at.all - at.axis;
        return end == 2 ? at.ray - W(line.range.lo) * at.all : W(line.range.hi) * at.all - at.ray;
      },
      trace);
}

/// In space r^2 n.n - (w.n)^2; in the plane r^2 n.n, as w.n is 0.
template <PolynomialScalar W, int N, bool ends>
W room(const Straight<N, ends>& line, const Capsule<double, N>& capsule) {
  const Components<W, N> d = line.template along<W>(), v = difference<W, N>(capsule.q, capsule.p);
  const W rr = W(capsule.radius) * W(capsule.radius);
  if constexpr (N == 2) {
    return rr * point_segment::detail::cross_squared(d, v);
  } else {
    const Components<W, 3> n = isect::cross(d, v);
    const W height = dot(difference<W, 3>(capsule.p, line.origin), n);
    return rr * dot(n, n) - height * height;
  }
}

template <int N, bool ends, class Trace>
Between between_ends(const Straight<N, ends>& line, const Capsule<double, N>& capsule, Trace&& trace) {
  const int all = crossing(line, capsule, trace);
  if (all == 0) return {};
  const auto before = [&](int end) { return all * past(end, line, capsule, trace) > 0; };
  if (!before(0) || !before(1)) return {};
  if (std::isfinite(line.range.lo) && !before(2)) return {};
  if (std::isfinite(line.range.hi) && !before(3)) return {};
  if constexpr (N == 2)
    return {true, capsule.radius > 0 ? -1 : 0};
  else
    return {true, -sign_of([&]<class W>() -> W { return room<W, N>(line, capsule); }, trace)};
}

/// Whether the distance of the line's range from the axis is at most r. Finite, not empty; the range has a point.
template <int N, bool ends, class Trace>
bool meets(Straight<N, ends> line, const Capsule<double, N>& capsule, Trace&& trace) {
  const bool point = line.is_point();
  if (point) line.range = {0, 0};
  for (const int end : {2, 3}) {
    const double t = end == 2 ? line.range.lo : line.range.hi;
    if (!std::isfinite(t)) continue;
    const int sign = compare<N>(line, t, capsule, trace);
    trace(End{end, sign});
    if (sign <= 0 || point) return sign <= 0;
  }
  for (const int end : {0, 1}) {
    const int sign = compare<N>(end == 0 ? capsule.p : capsule.q, line, capsule.radius, trace);
    trace(End{end, sign});
    if (sign <= 0) return true;
  }
  const Between inner = between_ends<N>(line, capsule, trace);
  trace(inner);
  return inner.holds && inner.sign <= 0;
}

/// Returns the part of the surface that the whole line passes where it enters the capsule, which it meets, or leaves
/// it. The line has a direction.
template <int N, bool ends, class Trace>
Piece passage(const Straight<N, ends>& line, const Capsule<double, N>& capsule, bool leaves, Trace&& trace) {
  const auto rate = [&]<class W>() -> W {
    return dot(line.template along<W>(), difference<W, N>(capsule.q, capsule.p));
  };
  const int forward = sign_of(rate, trace), all = crossing(line, capsule, trace);
  if (all == 0) return (forward < 0) != leaves ? Piece::q : Piece::p;

  // The sign of where it passes the endless cylinder less an end of the axis, along that
  const auto passes = [&](int at_end) {
    const Point<double, N>& end = at_end == 0 ? capsule.p : capsule.q;
    const int middle = (at_end == 0 ? all : -all) * past(at_end, line, capsule, trace);
    const int half_chord = leaves ? forward : -forward;
    if (middle * half_chord >= 0) return middle != 0 ? middle : half_chord;
    const auto beside_disc = [&]<class W>() -> W {
      const Components<W, N> f = difference<W, N>(line.origin, end), d = line.template along<W>();
      const W along = dot(f, difference<W, N>(capsule.q, capsule.p)), speed = rate.template operator()<W>();
      Components<W, N> across;
      for (int i = 0; i < N; ++i) across[i] = speed * f[i] - along * d[i];
      return dot(across, across) - W(capsule.radius) * W(capsule.radius) * speed * speed;
    };
    const int sign = sign_of(beside_disc, trace);
    return sign == 0 ? 0 : sign > 0 ? middle : half_chord;
  };
  if (passes(0) < 0) return Piece::p;
  return passes(1) > 0 ? Piece::q : Piece::side;
}

/// The polynomial of the ball around that end, with f = o - end and d.
template <PolynomialScalar W, int N, bool ends>
Quadratic<W> ball(const Straight<N, ends>& line, const Point<double, N>& end, double r) {
  const Components<W, N> f = difference<W, N>(line.origin, end), d = line.template along<W>();
  const W rr = W(r) * W(r), dd = dot(d, d);
  return {dd, dot(f, d), dot(f, f) - rr, rr * dd - point_segment::detail::cross_squared(f, d)};
}
/// The polynomial of the endless cylinder.
template <PolynomialScalar W, int N, bool ends>
Quadratic<W> cylinder(const Straight<N, ends>& line, const Capsule<double, N>& capsule) {
  const Components<W, N> d = line.template along<W>(), v = difference<W, N>(capsule.q, capsule.p),
                         f = difference<W, N>(line.origin, capsule.p);
  const W rr = W(capsule.radius) * W(capsule.radius), vv = dot(v, v), space = vv * room<W, N>(line, capsule);
  const W c = point_segment::detail::cross_squared(f, v) - rr * vv;
  if constexpr (N == 2) {
    const W e = cross(d, v);
    return {e * e, e * cross(f, v), c, space};
  } else {
    const Components<W, 3> n = isect::cross(d, v);
    return {dot(n, n), dot(n, isect::cross(f, v)), c, space};
  }
}

/// Where the whole line enters the capsule, which it meets, or leaves it. The line has a direction.
template <class S, int N, bool ends, class Trace>
S passes_at(const Straight<N, ends>& line, const Capsule<double, N>& capsule, bool leaves, Trace&& trace) {
  const Piece through = passage(line, capsule, leaves, trace);
  trace(Passage{leaves, through});
  const int side = leaves ? 1 : -1;
  if (through == Piece::side)
    return root_of<S>([&]<class W>() -> Quadratic<W> { return cylinder<W, N>(line, capsule); }, side, trace);
  const Point<double, N>& end = through == Piece::p ? capsule.p : capsule.q;
  return root_of<S>([&]<class W>() -> Quadratic<W> { return ball<W, N>(line, end, capsule.radius); }, side, trace);
}

/// The first or the last t of the range in the capsule, which the range meets: the range's end where that lies in the
/// capsule.
template <class S, int N, bool ends, class Trace>
S end_in(const Straight<N, ends>& line, const Capsule<double, N>& capsule, const Interval<S>& range, bool last,
         Trace&& trace) {
  const S end = last ? range.hi : range.lo;
  if (line.is_point()) return end;
  if (std::isfinite(end) && compare<N>(line, static_cast<double>(end), capsule, trace) <= 0) return end;
  return ray_range::clamped(passes_at<S>(line, capsule, last, trace), range);
}

template <class Line, class S, int N>
bool may_meet(const Line& line, const Capsule<S, N>& capsule) {
  return !empty(capsule) && finite(capsule) && finite(line);
}

template <class S, int N, bool ends, class Trace>
std::optional<Interval<S>> part_in(const Straight<N, ends>& line, const Capsule<double, N>& capsule,
                                   const Interval<S>& range, Trace&& trace) {
  return in_doubles_first(
      [&](auto& listener) -> std::optional<Interval<S>> {
        if (!meets<N>(line, capsule, listener)) return {};
        const S first = end_in<S>(line, capsule, range, false, listener);
        return Interval<S>{first, std::max(first, end_in<S>(line, capsule, range, true, listener))};
      },
      trace);
}

template <class S, int N, bool ends, class Trace>
std::optional<S> first_in(const Straight<N, ends>& line, const Capsule<double, N>& capsule, const Interval<S>& range,
                          Trace&& trace) {
  return in_doubles_first(
      [&](auto& listener) -> std::optional<S> {
        if (!meets<N>(line, capsule, listener)) return {};
        return end_in<S>(line, capsule, range, false, listener);
      },
      trace);
}

}  // namespace detail

}  // namespace ray_capsule

/// Whether a point of the ray's range lies in the capsule. Exact, for all finite input; touching counts. A zero
/// direction makes the ray a point. An empty range, an empty capsule, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Ray<S, N>& ray, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(ray, capsule) || !ray_range::has_points(ray.range)) return false;
  return in_doubles_first(
      [&](auto& listener) { return ray_capsule::detail::meets<N>(straight(ray), in_doubles(capsule), listener); },
      trace);
}
/// Whether a point of the segment, with both ends as given, lies in the capsule; otherwise as for a ray.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Segment<S, N>& segment, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(segment, capsule)) return false;
  return in_doubles_first(
      [&](auto& listener) { return ray_capsule::detail::meets<N>(straight(segment), in_doubles(capsule), listener); },
      trace);
}

/// The part of the ray's range inside the closed capsule, in units of |direction|.
///
/// Whether there is one is true for all finite input of any magnitude; touching counts. Each end is the range's where
/// that lies in the capsule, else within 0.6 ulp of S of where the line truly enters or leaves (and a unit of the least
/// subnormal number where it is subnormal), in the range, in order; infinite beyond the largest S. An axis without
/// length makes the capsule a ball, radius 0 a segment. A zero direction makes the ray a point: the whole range if it
/// lies in the capsule. An empty range, an empty capsule, NaN or an infinite coordinate: nothing.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, N>& ray, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(ray, capsule) || !ray_range::has_points(ray.range)) return {};
  return ray_capsule::detail::part_in<S>(straight(ray), in_doubles(capsule), ray.range, trace);
}
/// The t of [0, 1] at which the segment, with both ends as given, is in the closed capsule; otherwise as for a ray.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Segment<S, N>& segment, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(segment, capsule)) return {};
  return ray_capsule::detail::part_in<S>(straight(segment), in_doubles(capsule), {S(0), S(1)}, trace);
}

/// The first t of what `intersect` finds.
template <class S, int N, class Trace = NoTrace>
std::optional<S> first_hit(const Ray<S, N>& ray, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(ray, capsule) || !ray_range::has_points(ray.range)) return {};
  return ray_capsule::detail::first_in<S>(straight(ray), in_doubles(capsule), ray.range, trace);
}
template <class S, int N, class Trace = NoTrace>
std::optional<S> first_hit(const Segment<S, N>& segment, const Capsule<S, N>& capsule, Trace&& trace = {}) {
  if (!ray_capsule::detail::may_meet(segment, capsule)) return {};
  return ray_capsule::detail::first_in<S>(straight(segment), in_doubles(capsule), {S(0), S(1)}, trace);
}

}  // namespace isect
