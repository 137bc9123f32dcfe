#pragma once
// Point against convex polygon by wedges around an inner point, as in the note: for lessons and comparison. `locate` in
// isect/point_convex_polygon.h is right for all input. Source: the note, N23.

#include <variant>

#include <isect/point_convex_polygon.h>

namespace isect::point_convex_polygon {

template <class S>
struct Centroid {
  Point<S, 2> q;
};
template <class S>
struct WedgeAround {
  int lo, mid, hi;  ///< after the step
  S cross;          ///< of v_mid - q and p - q
};
template <class S>
struct EdgeSide {
  int from, to;
  S cross;  ///< positive inside
};
template <class S>
using NaiveEvent = std::variant<Centroid<S>, WedgeAround<S>, EdgeSide<S>>;

/// Whether the point lies inside, as in the note: wedges around the centroid of three vertices, bisected by cross
/// products, then one edge. Naive: rounding may decide near edges, and the centroid of a sliver may lie outside.
template <class S, class Trace = NoTrace>
bool wedge_naive(const Point<S, 2>& p, const ConvexPolygon<S>& polygon, Trace&& trace = {}) {
  const Ring<S, 2>& v = polygon.vertices;
  const std::size_t n = v.size();
  if (n < 3) return false;
  const auto cross = [](const Point<S, 2>& o, const Point<S, 2>& a, const Point<S, 2>& b) -> S {
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  };
  const Point<S, 2>&a = v[0], &b = v[n / 3], &c = v[2 * n / 3];
  const Point<S, 2> q = {(a[0] + b[0] + c[0]) / S(3), (a[1] + b[1] + c[1]) / S(3)};
  trace(Centroid<S>{q});

  // directions from q are ordered from that of v0 on: the half turn to its left, then the other
  const bool p_left = cross(q, a, p) >= S(0);
  std::size_t lo = 0, hi = n;
  while (hi - lo > 1) {
    const std::size_t mid = lo + (hi - lo) / 2;
    const bool mid_left = cross(q, a, v[mid]) >= S(0);
    const S side = cross(q, v[mid], p);
    const bool passed = p_left == mid_left ? side >= S(0) : mid_left;
    (passed ? lo : hi) = mid;
    if constexpr (heard<Trace>)
      trace(WedgeAround<S>{static_cast<int>(lo), static_cast<int>(mid), static_cast<int>(hi), side});
  }

  const std::size_t to = hi < n ? hi : 0;
  const S inner = cross(v[lo], v[to], p);
  trace(EdgeSide<S>{static_cast<int>(lo), static_cast<int>(to), inner});
  return inner >= S(0);
}

}  // namespace isect::point_convex_polygon
