#pragma once
// The convex hull of points in the plane.
//
// Sorted by x, then y, the points are scanned from left to right and back. A chain that turns left at every vertex is
// kept: a new point removes the last vertices of the chain at which it does not turn left (Andrew's monotone chain).
// orient2d decides, so the hull is exact; it holds strict vertices only, those that are in no hull of the others.
//
// Sorting takes the time. But the hull of a thousand of the points holds nearly all others, and what lies in its
// interior is no vertex. Boxes in upright columns fill that hull, their corners located in it exactly: a point in the
// box of its column is discarded for a few comparisons. The rest is sorted.
//
// Source: A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Inf. Process. Lett. 9 (1979);
// S. G. Akl, G. T. Toussaint, A fast convex hull algorithm, Inf. Process. Lett. 7 (1978), for discarding.

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

#include <isect/orient.h>
#include <isect/parts/sort_points.h>
#include <isect/point_convex_polygon.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace convex_hull_2d {

/// How many points are left after discarding those in the interior.
struct Remaining {
  std::size_t count;
};
/// A point joins the chain.
template <class S>
struct Added {
  Point<S, 2> p;
};
/// A point leaves the chain again: the turn at it, to the next point, is not to the left.
template <class S>
struct Removed {
  Point<S, 2> p, next;
  int turn;
};
template <class S>
using Event = std::variant<Remaining, Added<S>, Removed<S>, Fallback>;

namespace detail {

/// Throws where a coordinate is NaN or infinite.
template <class S>
void demand_finite(std::span<const Point<S, 2>> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!finite(points[i]))
      throw std::invalid_argument("convex_hull: point " + std::to_string(i) + " has a NaN or infinite coordinate");
}

/// The chain from the first point to the last that turns left at every vertex and has no point on its right.
/// turn(a, b, c) > 0: a left turn.
template <class S, class Iterator, class Turn, class Trace>
Ring<S, 2> left_turning(Iterator first, Iterator last, const Turn& turn, Trace&& trace) {
  Ring<S, 2> chain;
  chain.reserve(last - first);
  for (Iterator p = first; p != last; ++p) {
    while (chain.size() > 1) {
      const Point<S, 2>&a = chain[chain.size() - 2], &b = chain.back();
      const int sign = turn(a, b, *p);
      if (sign > 0) break;
      trace(Removed<S>{b, *p, sign});
      chain.pop_back();
    }
    chain.push_back(*p);
    trace(Added<S>{*p});
  }
  return chain;
}

/// Joins both chains: they are the hull, if `turn` is right.
template <class S, class Turn, class Trace>
Ring<S, 2> chains(Ring<S, 2> points, const Turn& turn, Trace&& trace) {
  sort_points(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;

  Ring<S, 2> hull = left_turning<S>(points.begin(), points.end(), turn, trace);
  const Ring<S, 2> back = left_turning<S>(points.rbegin(), points.rend(), turn, trace);
  hull.insert(hull.end(), back.begin() + 1, back.end() - 1);  // the ends are in both
  return hull;
}

}  // namespace detail

/// The hull by sorting. Throws std::invalid_argument where a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
Ring<S, 2> monotone_chain(Ring<S, 2> points, Trace&& trace = {}) {
  detail::demand_finite<S>(points);
  const auto turn = [&](const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c) {
    return orient2d(a.template cast<double>(), b.template cast<double>(), c.template cast<double>(), trace);
  };
  return detail::chains(std::move(points), turn, trace);
}

namespace detail {

/// Where the line at x meets the polygon, rounded; lo > hi where it does not.
template <class S>
Interval<S> heights(const Ring<S, 2>& polygon, S x) {
  Interval<S> y = {std::numeric_limits<S>::infinity(), -std::numeric_limits<S>::infinity()};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<S, 2>&a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if ((a[0] <= x) == (b[0] <= x)) continue;
    const S at = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    y = {std::min(y.lo, at), std::max(y.hi, at)};
  }
  return y;
}

/// Boxes in the interior of a convex polygon, one above each of many equal parts of its extent in x; empty ones where
/// rounding, or a lack of room, allows no better.
template <class S>
struct Columns {
  static constexpr int count = 256;
  S left, per_unit;  ///< per_unit: columns
  std::array<Aabb<S, 2>, count> boxes;

  explicit Columns(const ConvexPolygon<S>& polygon) {
    const auto [least, most] = std::minmax_element(polygon.vertices.begin(), polygon.vertices.end(), before<S>);
    const S width = ((*most)[0] - (*least)[0]) / count;
    left = (*least)[0], per_unit = 1 / width;
    for (int i = 0; i < count; ++i) {
      const S from = left + S(i) * width, to = left + S(i + 1) * width;
      const Interval<S> a = heights(polygon.vertices, from), b = heights(polygon.vertices, to);
      const S lo = std::max(a.lo, b.lo), hi = std::min(a.hi, b.hi), margin = (hi - lo) / 1024;
      Aabb<S, 2>& box = boxes[i] = {{from, lo + margin}, {to, hi - margin}};
      for (const Point<S, 2>& corner : {box.lo, {box.lo[0], box.hi[1]}, box.hi, {box.hi[0], box.lo[1]}})
        if (!(lo < hi) || locate(corner, polygon) != Location::in) box = {{S(1), S(1)}, {S(0), S(0)}};
    }
  }

  /// Whether p is certainly in the interior: rounding may choose a wrong column, but not put p in its box.
  bool hold(const Point<S, 2>& p) const {
    const S column = (p[0] - left) * per_unit;
    if (!(column >= S(0) && column < S(count))) return false;
    const Aabb<S, 2>& box = boxes[static_cast<std::size_t>(column)];
    const S x = p[0], y = p[1], x_lo = box.lo[0], x_hi = box.hi[0], y_lo = box.lo[1], y_hi = box.hi[1];
    return (x_lo <= x) & (x <= x_hi) & (y_lo <= y) & (y <= y_hi);
  }
};

/// The points, without many that are certainly not vertices of their hull. Throws where a coordinate is NaN or
/// infinite.
template <class S>
Ring<S, 2> without_interior(std::span<const Point<S, 2>> points) {
  constexpr std::size_t few = 1000;
  Ring<S, 2> sample;
  for (std::size_t i = 0; i < few && points.size() >= 10 * few; ++i)
    sample.push_back(points[i * (points.size() / few)]);
  ConvexPolygon<S> inner;
  if (finite(sample)) inner = {monotone_chain(std::move(sample))};
  if (inner.vertices.size() < 3) {
    demand_finite(points);
    return {points.begin(), points.end()};
  }

  const Columns<S> columns(inner);
  Ring<S, 2> rest;
  bool usable = true;  // a point in a box is
  for (const Point<S, 2>& p : points)
    if (!columns.hold(p)) rest.push_back(p), usable &= finite(p);
  if (!usable) demand_finite(points);
  return rest;
}

}  // namespace detail

}  // namespace convex_hull_2d

/// The vertices of the hull, counter-clockwise, from the one of lowest x, then y. Points within an edge and repeated
/// ones are left out: points on one line give the two ends, equal points give one, none give none. Exact; the
/// vertices are points given. O(n log n), with sorting for the few points near the boundary only. Throws
/// std::invalid_argument where a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
Ring<S, 2> convex_hull(std::span<const Point<S, 2>> points, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  Ring<S, 2> candidates = convex_hull_2d::detail::without_interior(points);
  if constexpr (heard<Trace>) trace(convex_hull_2d::Remaining{candidates.size()});
  return convex_hull_2d::monotone_chain(std::move(candidates), trace);
}
template <class S, class Trace = NoTrace>
Ring<S, 2> convex_hull(const Ring<S, 2>& points, Trace&& trace = {}) {
  return convex_hull(std::span<const Point<S, 2>>(points), trace);
}

}  // namespace isect
