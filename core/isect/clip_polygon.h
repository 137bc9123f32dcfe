#pragma once
// Clipping a convex polygon at a half-space, or at the six (four) of a box.
//
// Walk around the ring. With h(v) the height of a vertex over the plane, keep v where h(v) >= 0; where an edge pq
// runs from one side to the other, P = h(p) and Q = h(q) of opposite signs, put in the point where it crosses,
//
//   x = (p Q - q P) / (Q - P).
//
// The signs are exact, so which vertices survive is certain. New vertices are rounded: a box clips at one plane after
// the other, and each from the second on cuts vertices that were rounded before. Source: Sutherland, Hodgman, Reentrant
// polygon clipping, Comm. ACM 17 (1974).

#include <variant>
#include <vector>

#include <isect/parts/ray_range.h>
#include <isect/trace.h>

namespace isect {

namespace clip_polygon {

/// The side of vertex `index` beside the plane in turn: 1 above, 0 on it, -1 below.
struct Side {
  int index, sign;
};
/// The edge from vertex `index` crosses the plane here.
template <class S, int N>
struct Crossing {
  int index;
  Point<S, N> point;
};
template <class S, int N>
using Event = std::variant<Side, Crossing<S, N>, Fallback>;

namespace detail {

/// Where the edge pq crosses the plane of the heights: each coordinate within 2 ulp of S, between those of p and q.
/// Swapping p and q, or turning the plane around, changes nothing: neighbours get the same new vertex.
template <class S, int N, class Height, class Trace>
Point<S, N> crossing(const Point<S, N>& p, const Point<S, N>& q, const Height& height, Trace&& trace) {
  const Point<double, N> a = p.template cast<double>(), b = q.template cast<double>();
  Point<S, N> x;
  for (int i = 0; i < N; ++i) {
    const auto coordinate = [&]<class W>() -> Ratio<W> {
      const W from = height.template operator()<W>(a), to = height.template operator()<W>(b);
      return {W(a[i]) * to - W(b[i]) * from, to - from};
    };
    x[i] = p[i] == q[i] ? p[i] : value_of<S>(coordinate, trace);
    x[i] = ray_range::clamped(x[i], {std::min(p[i], q[i]), std::max(p[i], q[i])});
  }
  return x;
}

/// The part of the ring where height<W>(v) >= 0. `settle` may put a new vertex right.
template <class S, int N, class Height, class Settle, class Trace>
Ring<S, N> cut(const Ring<S, N>& ring, const Height& height, const Settle& settle, Trace&& trace) {
  std::vector<int> sides;
  for (const Point<S, N>& v : ring) {
    const Point<double, N> wide = v.template cast<double>();
    sides.push_back(sign_of([&]<class W>() -> W { return height.template operator()<W>(wide); }, trace));
    trace(Side{static_cast<int>(sides.size()) - 1, sides.back()});
  }

  Ring<S, N> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = i + 1 < ring.size() ? i + 1 : 0;
    if (sides[i] >= 0) kept.push_back(ring[i]);
    if (sides[i] * sides[next] >= 0) continue;
    kept.push_back(crossing(ring[i], ring[next], height, trace));
    settle(kept.back());
    trace(Crossing<S, N>{static_cast<int>(i), kept.back()});
  }
  return kept;
}

}  // namespace detail

}  // namespace clip_polygon

/// The part of a convex polygon on the plane or on the side that its normal points to, normal.x + d >= 0.
///
/// Which vertices survive is true for all finite input of any magnitude; each coordinate of a new one lies within 2 ulp
/// of S of the true one. A polygon that touches the plane from below keeps the vertices on it, one or two. Vertices may
/// coincide. A ring that is not convex comes out with edges along the plane. The ring is empty where nothing is kept,
/// and for a zero normal, which makes no half-space, NaN or an infinite coordinate.
template <class S, int N, class Trace = NoTrace>
Ring<S, N> clip(const Ring<S, N>& ring, const Plane<S, N>& half_space, Trace&& trace = {}) {
  if (!finite(ring) || !finite(half_space) || half_space.normal == Vector<S, N>::Zero()) return {};
  const Plane<double, N> plane = cast<double>(half_space);
  const auto height = [&]<class W>(const Point<double, N>& x) -> W {
    return dot(exactly<W>(plane.normal), exactly<W>(x)) + W(plane.d);
  };
  return clip_polygon::detail::cut(
      ring, height, [](Point<S, N>&) {}, trace);
}

/// The part of a convex polygon in the closed box.
///
/// All its vertices lie in the box, exactly, and every input vertex in the box is among them, unchanged. Each plane
/// cuts at coordinates within 2 ulp of S for the vertices that it is given; a cut of a cut moves on by as much, so that
/// a polygon which passes a corner or an edge within rounding may be missed, or met. Otherwise as for one plane. An
/// empty box keeps nothing.
template <class S, int N, class Trace = NoTrace>
Ring<S, N> clip(const Ring<S, N>& ring, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (empty(box) || !finite(ring) || !finite(box)) return {};
  Ring<S, N> kept = ring;
  for (int i = 0; i < N; ++i)
    for (const bool upper : {false, true}) {
      const S bound = upper ? box.hi[i] : box.lo[i];
      const auto height = [&]<class W>(const Point<double, N>& x) -> W {
        return upper ? difference<W>(bound, x[i]) : difference<W>(x[i], bound);
      };
      kept = clip_polygon::detail::cut(
          kept, height, [&](Point<S, N>& x) { x[i] = bound; }, trace);
    }
  return kept;
}

}  // namespace isect
