#pragma once
// Point against convex polygon in O(lg n).
//
// Rays from vertex 0 through the others cut a convex polygon into wedges, all within less than half a turn. The sign
// of orient2d(v0, vi, p) falls from 1 to -1 as i grows, so bisection finds the wedge of p; in it the polygon is the
// triangle v0 vi vi+1, whose third side decides. The two edges at v0, the first and the closing one, bound the fan. A
// point within the triangle v0 vlo vhi of a wider wedge is inside already, one beyond the line of an edge is outside:
// so points away from the boundary need three steps or so, however large n is.
//
// The note takes an interior point instead, the centroid of three vertices. Rounded, it may lie outside a slender
// polygon; and its wedges fill the whole turn, so that orient2d alone does not order them. A vertex is exact and
// needs no preprocessing. Source: the note, N23; Preparata, Shamos, Computational Geometry (1990), 2.2.1.

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/orient.h>
#include <isect/parts/sort_points.h>
#include <isect/point_polygon.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// A convex polygon with an area. Its vertices turn left at every vertex, go around once, and are finite: `make_convex`
/// ensures that, and the tests rely on it.
template <class S>
struct ConvexPolygon {
  Ring<S, 2> vertices;
};

namespace point_convex_polygon {

/// The bisection asked for the turn of v0, v_mid, p: the wedge is lo, hi from now on.
struct Wedge {
  int lo, mid, hi, turn;
};
/// The turn of v_lo, v_hi, p. For the wedge: positive when p lies in the triangle with v0. For the edge after v_mid:
/// negative when p lies outside.
struct Chord {
  int lo, hi, turn;
};
/// The turns of the edges at v0: p lies outside when first < 0 or last > 0.
struct Fan {
  int first, last;
};
using Event = std::variant<Fan, Wedge, Chord, Fallback>;

}  // namespace point_convex_polygon

/// The ring as a convex polygon: counter-clockwise, without repeated vertices or those within an edge. Nothing when
/// it is not convex, goes around more than once, has no area, turns back on itself, or has a NaN or infinite
/// coordinate. The first vertex stays first, if it is one. Exact, in O(n).
template <class S>
std::optional<ConvexPolygon<S>> make_convex(const Ring<S, 2>& ring) {
  if (!finite(ring)) return {};
  Ring<S, 2> distinct;
  for (const Point<S, 2>& v : ring)
    if (distinct.empty() || v != distinct.back()) distinct.push_back(v);
  while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();

  const std::size_t n = distinct.size();
  ConvexPolygon<S> polygon;
  int sense = 0, reversals = 0;  // of the turns; and of the direction, forwards or backwards in `before`
  for (std::size_t i = 0; i < n; ++i) {
    const Point<S, 2>&a = distinct[i > 0 ? i - 1 : n - 1], &b = distinct[i], &c = distinct[i + 1 < n ? i + 1 : 0];
    const bool reverses = before(a, b) != before(b, c);
    const int turn = orient2d(a.template cast<double>(), b.template cast<double>(), c.template cast<double>());
    if (reverses) ++reversals;
    if (turn == 0 && reverses) return {};
    if (turn == 0) continue;
    if (turn == -sense) return {};
    sense = turn;
    polygon.vertices.push_back(b);
  }
  // with turns of one sense the direction goes around once for every two reversals
  if (sense == 0 || reversals != 2) return {};
  if (sense < 0) std::reverse(polygon.vertices.begin() + 1, polygon.vertices.end());
  return polygon;
}

/// Where the point lies. Exact; for n vertices at most 3 + 3 lg (n - 2) orientations, lg rounded up. A point with a NaN
/// or infinite coordinate: out.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const ConvexPolygon<S>& polygon, Trace&& trace = {}) {
  using namespace point_convex_polygon;
  const Ring<S, 2>& v = polygon.vertices;
  if (v.size() < 3) return locate(point, v);  // a point or a segment
  if (!finite(point)) return Location::out;
  const Point<double, 2> p = point.template cast<double>();
  const auto turn = [&](std::size_t a, std::size_t b) {
    return orient2d(v[a].template cast<double>(), v[b].template cast<double>(), p, trace);
  };

  std::size_t lo = 1, hi = v.size() - 1;
  const int first = turn(0, lo), last = turn(0, hi);
  trace(Fan{first, last});
  if (first < 0 || last > 0) return Location::out;

  int chord = turn(lo, hi);
  trace(Chord{static_cast<int>(lo), static_cast<int>(hi), chord});
  while (chord <= 0 && hi - lo > 1) {
    const std::size_t mid = lo + (hi - lo) / 2;
    const int side = turn(0, mid);
    (side >= 0 ? lo : hi) = mid;
    trace(Wedge{static_cast<int>(lo), static_cast<int>(mid), static_cast<int>(hi), side});

    const int edge = turn(mid, mid + 1);
    trace(Chord{static_cast<int>(mid), static_cast<int>(mid) + 1, edge});
    if (edge < 0) return Location::out;

    chord = turn(lo, hi);
    trace(Chord{static_cast<int>(lo), static_cast<int>(hi), chord});
  }

  if (chord < 0) return Location::out;
  return chord == 0 || first == 0 || last == 0 ? Location::on : Location::in;
}

}  // namespace isect
