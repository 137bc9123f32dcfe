#pragma once
// Convex polygon against convex polygon: separating axes.
//
// Two convex polygons have no common point iff the line of an edge of either has the other polygon strictly on its
// outer side: the differences a - b make a convex polygon too, whose edges are those of A and B turned, and one of
// them has the origin on its outer side. If the best such line only touches, the interiors are apart still. The
// vertex of B farthest inwards of an edge of A decides for that edge; it moves on around B as the edge does around A
// (rotating calipers), so all edges take O(n + m). Containment is a matter of all vertices.
//
// Source: S. Gottschalk, Separating axis theorem, UNC TR96-024 (1996); G. Toussaint, Solving geometric problems with
// the rotating calipers, MELECON (1983).

#include <algorithm>
#include <cassert>
#include <optional>
#include <variant>

#include <isect/orient.h>
#include <isect/point_convex_polygon.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace convex_polygons {

/// The edge from vertex `index` of A, or of B, to the next.
struct Edge {
  bool of_b;
  int index;
  friend bool operator==(const Edge&, const Edge&) = default;
};
/// The vertex of the other polygon that is farthest inwards of the edge, and its side: -1 outside, 0 on the line.
struct Farthest {
  Edge edge;
  int vertex, side;
};
/// Whether all vertices of B lie in A, and all of A in B.
struct Contained {
  bool b_in_a, a_in_b;
};
using Event = std::variant<Farthest, Contained, Fallback>;

namespace detail {

/// The first edge of A that has B strictly on its outer side; else one whose line B touches from there.
struct Separation {
  std::optional<Edge> strict, weak;
};

/// The sign of (b - a) x (d - c): whether d is farther on the left of the direction a b than c is.
template <class S, class Trace>
int rises(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c, const Point<S, 2>& d, Trace&& trace) {
  const auto text = [&]<class W>() -> W {
    return difference<W>(b[0], a[0]) * difference<W>(d[1], c[1]) -
           difference<W>(b[1], a[1]) * difference<W>(d[0], c[0]);
  };
  return sign_of(text, trace);
}

/// Looks for an edge of `a` that separates it from `b`; `of_b` names the edges in the events and the result.
template <class S, class Trace>
Separation separate(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b, bool of_b, Trace&& trace) {
  const Ring<S, 2>&v = a.vertices, &w = b.vertices;
  assert(v.size() >= 3 && w.size() >= 3);
  std::size_t far = 0;
  for (std::size_t j = 1; j < w.size(); ++j)
    if (rises(v[0], v[1], w[far], w[j], trace) > 0) far = j;

  Separation found;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Point<S, 2>&from = v[i], &to = v[i + 1 < v.size() ? i + 1 : 0];
    const auto next = [&](std::size_t j) { return j + 1 < w.size() ? j + 1 : 0; };
    while (rises(from, to, w[far], w[next(far)], trace) > 0) far = next(far);

    const Edge edge = {of_b, static_cast<int>(i)};
    const int side =
        orient2d(from.template cast<double>(), to.template cast<double>(), w[far].template cast<double>(), trace);
    trace(Farthest{edge, static_cast<int>(far), side});
    if (side == 0) found.weak = edge;
    if (side < 0) {
      found.strict = edge;
      return found;
    }
  }
  return found;
}

/// Looks for an edge of either polygon that separates them.
template <class S, class Trace>
Separation separate(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b, Trace&& trace) {
  const Separation by_a = separate(a, b, false, trace);
  if (by_a.strict) return by_a;
  const Separation by_b = separate(b, a, true, trace);
  return {by_b.strict, by_a.weak ? by_a.weak : by_b.weak};
}

/// Whether every vertex of `inner`, and so all of it, lies in `outer`.
template <class S>
bool contains(const ConvexPolygon<S>& outer, const ConvexPolygon<S>& inner) {
  return std::all_of(inner.vertices.begin(), inner.vertices.end(),
                     [&](const Point<S, 2>& p) { return locate(p, outer) != Location::out; });
}

}  // namespace detail

}  // namespace convex_polygons

/// The edge whose line has all of the other polygon strictly on its outer side; nothing when the polygons have a
/// common point. Exact, O(n + m).
template <class S, class Trace = NoTrace>
std::optional<convex_polygons::Edge> separating_edge(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b,
                                                     Trace&& trace = {}) {
  return convex_polygons::detail::separate(a, b, trace).strict;
}

/// Whether the polygons have a common point. Exact, O(n + m).
template <class S, class Trace = NoTrace>
bool intersects(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b, Trace&& trace = {}) {
  return !separating_edge(a, b, trace);
}

/// How the polygons lie. Exact, O((n + m) lg (n + m)). Both have an area, as everything from `make_convex` does; points
/// and segments are no convex polygons.
template <class S, class Trace = NoTrace>
Relation relate(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b, Trace&& trace = {}) {
  const convex_polygons::detail::Separation separation = convex_polygons::detail::separate(a, b, trace);
  if (separation.strict) return Relation::disjoint;
  if (separation.weak) return Relation::touching;

  const bool b_in_a = convex_polygons::detail::contains(a, b), a_in_b = convex_polygons::detail::contains(b, a);
  trace(convex_polygons::Contained{b_in_a, a_in_b});
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b) return Relation::a_inside_b;
  return b_in_a ? Relation::b_inside_a : Relation::overlapping;
}

}  // namespace isect
