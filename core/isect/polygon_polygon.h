#pragma once
// Polygon against polygon, and what runs along a line against a polygon: outlines of any form, with holes, in parts.
//
// A polygon is what `locate` of isect/point_polygon.h makes of its rings: interior where an odd number of edges is
// crossed on the way out, boundary on every edge. Every edge of both is cut where another one meets it. Then each piece
// lies in the interior of A, on the boundary of A, or outside, as a whole, and so does the plane just beside it, on the
// left and on the right; the same of B. As both are bounded, all regions of the plane lie beside some piece:
//
//   the interiors meet    iff a piece has both on one side,
//   A does not lie in B   iff a piece has A and not B on one side, or is of A and lies outside of B.
//
// No point is computed. Along an edge e the left side is followed on the line of e, moved to the left by an
// infinitesimal: another edge changes it iff that line parts its ends, those on the line of e counted as right of it.
// From one edge to the next, around their common corner, it changes with every other edge that leaves the corner within
// the angle on the left. For the first edge of a ring the crossings of a ray to the right tell it. The right side
// differs from the left if an odd number of edges runs along the piece. Where several edges meet e, the order is that
// of the quotients t = (r - p) x (s - r) / (d x (s - r)): the sign of a polynomial of degree four. So all of it is
// comparisons and true signs.
//
// A hierarchy of the edges' boxes finds which meet, edge by edge, in O(n) space, until nothing is left open: two that
// overlap are soon decided. Else it takes O((n + k) lg (n + k)) with k pairs of edges whose boxes have a common point,
// pairs of one polygon counted as well, and for each ring a ray past all edges to the right of it. Long edges side by
// side, as of a comb that stands obliquely, have k near n^2; n small rings in rows may take n^1.5.
//
// Source: M. Margalit, G. Knott, An algorithm for computing the union, intersection or difference of two polygons,
// Computers & Graphics 13 (1989), for edges that are cut and classified; Edelsbrunner, Mücke, Simulation of simplicity,
// ACM Trans. Graphics 9 (1990), for lines moved by an infinitesimal.

#include <optional>
#include <vector>

#include <isect/parts/polygon_overlay.h>

namespace isect {

/// How two polygons lie, each with its boundary: outlines, holes, islands, several parts, whatever the even-odd rule
/// makes of the rings, which may go either way, name a corner again, and cross themselves and each other.
///
/// Exact for all finite input of any magnitude. The interior is where `locate` says `in`, the set all where it does not
/// say `out`: every edge belongs to it, one that parts nothing as well. So a polygon without an area has no interior,
/// and touches what it meets unless one lies in the other. A polygon without a vertex is disjoint from everything; NaN
/// or an infinite coordinate: disjoint. O((n + k) lg (n + k)), with k pairs of edges whose boxes meet, and a ray for
/// each ring.
template <class S>
Relation relate(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!all_finite(a) || !all_finite(b)) return Relation::disjoint;
  const std::optional<Aabb<double, 2>> box_a = box_of(a), box_b = box_of(b);
  if (!box_a || !box_b || !intersects(*box_a, *box_b)) return Relation::disjoint;
  std::vector<Edge> edges;
  add_edges(a, false, edges);
  add_edges(b, true, edges);
  const Edges sorted(std::move(edges));
  return Overlay(sorted).found().relation();
}

/// Whether two polygons have a common point. Exact; see relate. It stops at the first edges that meet: O(n lg m), and
/// the pairs of an edge of each whose boxes meet.
template <class S>
bool intersects(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!all_finite(a) || !all_finite(b)) return false;
  const std::optional<Aabb<double, 2>> box_a = box_of(a), box_b = box_of(b);
  if (!box_a || !box_b || !intersects(*box_a, *box_b)) return false;
  std::vector<Edge> of_a, of_b;
  add_edges(a, false, of_a);
  add_edges(b, true, of_b);
  const Edges sorted(std::move(of_b));
  for (const Edge& e : of_a) {
    const Aabb<double, 2> box = box_of(e.p, e.q);
    const Segment<double, 2> edge = {e.p, e.q};
    const auto meets = [&](int i) { return intersects(edge, Segment<double, 2>{sorted.all[i].p, sorted.all[i].q}); };
    if (sorted.any([&](const Aabb<double, 2>& other) { return intersects(box, other); }, meets)) return true;
  }
  // no ring crosses another one's edges: all of it lies within, or nothing
  for (const Edge& e : of_a)
    if (e.start && sorted.within(e.p)[1]) return true;
  const Edges others(std::move(of_a));
  return std::any_of(sorted.all.begin(), sorted.all.end(),
                     [&](const Edge& e) { return e.start && others.within(e.p)[0]; });
}

/// How a segment (A) lies to a polygon (B), a set as above. The segment has its interior between its ends: what pierces
/// overlaps, what runs along the boundary and leaves it touches, what lies within or along an edge lies in the polygon.
/// Ends that coincide are a point: it lies in the polygon or is disjoint. Exact for all finite input; O(n lg n). NaN or
/// an infinite coordinate: disjoint.
template <class S>
Relation relate(const Segment<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!finite(a) || !all_finite(b)) return Relation::disjoint;
  if (a.p == a.q) return relate_point(a.p, b);
  const Segment<double, 2> wide = cast<double>(a);
  Mark from = {Mark::Kind::number}, to = {Mark::Kind::number};
  to.number = 1;
  return relate_part(LineOfSegment{wide.p, wide.q}, from, to, b);
}

/// Whether a segment and a polygon have a common point. Exact; O(n).
template <class S>
bool intersects(const Segment<S, 2>& a, const Polygon<S, 2>& b) {
  if (!finite(a) || !polygon_polygon::detail::all_finite(b)) return false;
  for (const Ring<S, 2>& ring : b.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (intersects(a, Segment<S, 2>{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]})) return true;
  return locate(a.p, b) != Location::out;
}

/// How a ray, a segment o + t d or a line (A) lies to a polygon (B): as a segment does, with the ends of the range,
/// which may be infinite. A zero direction, or a range of one t, is a point. Empty, NaN, or another number that is
/// infinite: disjoint. Exact; O(n lg n).
template <class S>
Relation relate(const Ray<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  constexpr Interval<S> all = infinite<S>;
  const bool has_t = a.range.lo <= a.range.hi && a.range.lo < all.hi && a.range.hi > all.lo;
  if (!has_t || !finite(a.origin) || !finite(a.direction) || !all_finite(b)) return Relation::disjoint;
  if (a.direction == Vector<S, 2>(S(0), S(0))) return relate_point(a.origin, b);
  const Ray<double, 2> wide = cast<double>(a);
  const auto end = [](double t) -> std::optional<Mark> {
    if (std::isinf(t)) return {};
    Mark mark = {Mark::Kind::number};
    mark.number = t;
    return mark;
  };
  return relate_part(LineOfRay{wide.origin, wide.direction}, end(wide.range.lo), end(wide.range.hi), b);
}

/// Whether a ray and a polygon have a common point. Exact; see relate.
template <class S>
bool intersects(const Ray<S, 2>& a, const Polygon<S, 2>& b) {
  return relate(a, b) != Relation::disjoint;
}

}  // namespace isect
