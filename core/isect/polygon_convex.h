#pragma once
// A polygon of any form in the plane against a convex body: a ball, a capsule, or half-spaces.
//
// Some edges part the polygon from the rest of the plane. If no such edge passes through the body's inside, the inside
// lies in the polygon or out of it as a whole, and any point of it tells which. If one does, the body has points of
// both kinds beside that edge. The polygon lies in the body where its corners do.
//
// Rings may run along each other: what they run along an even number of times parts nothing. So edges are cut where
// others on their line end, and pieces that then are there twice are dropped. No new point is needed for that.
// Source: de Berg et al., Computational Geometry (2008), 2.3, for what edges on one line do to an overlay.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <isect/capsule_capsule.h>
#include <isect/parts/inner_point.h>
#include <isect/point_capsule.h>
#include <isect/polygon_polygon.h>
#include <isect/sphere_half_spaces.h>
#include <isect/triangle_half_spaces.h>

namespace isect {

namespace polygon_convex::detail {

using polygon_polygon::detail::Edge, polygon_polygon::detail::Edges;
using Point2 = Point<double, 2>;
using Side = std::pair<Point2, Point2>;

template <class S>
std::vector<Edge> edges_of(const Polygon<S, 2>& polygon) {
  std::vector<Edge> edges;
  polygon_polygon::detail::add_edges(polygon, false, edges);
  return edges;
}

/// The pieces of edges that part something.
inline std::vector<Side> parting(const std::vector<Edge>& edges) {
  const auto before = [](const Point2& a, const Point2& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; };
  const auto first = [&](const Side& a, const Side& b) {
    return a.first != b.first ? before(a.first, b.first) : before(a.second, b.second);
  };
  const Edges all(edges);
  std::map<Side, bool, decltype(first)> odd(first);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Point2 p = std::min(edges[i].p, edges[i].q, before), q = std::max(edges[i].p, edges[i].q, before);
    if (p == q) continue;
    std::vector<Point2> ends = {p, q};
    const Aabb<double, 2> box = all.boxes[i];
    all.any([&](const Aabb<double, 2>& other) { return intersects(box, other); },
            [&](int k) {
              const Edge& e = all.all[static_cast<std::size_t>(k)];
              if (orient2d(p, q, e.p) == 0 && orient2d(p, q, e.q) == 0)
                for (const Point2& v : {e.p, e.q})
                  if (before(p, v) && before(v, q)) ends.push_back(v);
              return false;
            });
    std::ranges::sort(ends, before);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (ends[k] != ends[k + 1]) odd[{ends[k], ends[k + 1]}] ^= true;
  }
  std::vector<Side> pieces;
  for (const auto& [piece, parts] : odd)
    if (parts) pieces.push_back(piece);
  return pieces;
}

/// How a polygon lies to a body. `reach` of a side is 1 where it has a point inside the body, 0 where it touches it,
/// else -1; `in` tells where a point lies; `around` whether a point inside the body, on no edge that parts something,
/// lies among edges.
template <class S, class Reach, class In, class Around>
Relation relation(const Polygon<S, 2>& polygon, const Reach& reach, const In& in, const Around& around) {
  const std::vector<Edge> edges = edges_of(polygon);
  if (edges.empty()) return Relation::disjoint;
  int most = -1;
  for (const Edge& e : edges) most = std::max(most, reach(e.p, e.q));
  bool cut = most > 0;
  if (cut) cut = std::ranges::any_of(parting(edges), [&](const Side& s) { return reach(s.first, s.second) > 0; });
  const bool holds = !cut && around(edges);
  const bool held = std::ranges::all_of(edges, [&](const Edge& e) { return in(e.p) != Location::out; });
  if (held) return holds ? Relation::equal : Relation::a_inside_b;
  if (holds) return Relation::b_inside_a;
  return cut ? Relation::overlapping : most >= 0 ? Relation::touching : Relation::disjoint;
}

template <class S>
int reach_of(const Capsule<S, 2>& body, const Point2& p, const Point2& q) {
  return -capsule_capsule::detail::compare<2>(cast<double>(body), Capsule<double, 2>{p, q, 0}, NoTrace());
}
inline int reach_of(const HalfSpaces& body, const Point2& p, const Point2& q) {
  const Point<double, 3> a(p[0], p[1], 0), b(q[0], q[1], 0);
  return triangle_half_spaces::detail::common({{a, b, b}}, body.faces, NoTrace());
}

/// Whether a place lies among the edges, by the ray to the right, which does not pass an edge on the left of it. The
/// place need be no point of doubles: way<W>(v) is a positive multiple of the way from it to v.
template <class Way>
bool is_among(const std::vector<Edge>& edges, const Way& way) {
  const auto above = [&](const Point2& v) {
    return sign_of<long_text>([&]<class W>() -> W { return way.template operator()<W>(v)[1]; }) > 0;
  };
  bool odd = false;
  for (const Edge& e : edges) {
    const bool up = above(e.q);
    if (above(e.p) == up) continue;
    const int side = sign_of<long_text>([&]<class W>() -> W {
      const auto p = way.template operator()<W>(e.p), q = way.template operator()<W>(e.q);
      return p[0] * q[1] - p[1] * q[0];
    });
    odd ^= up ? side > 0 : side < 0;
  }
  return odd;
}
inline bool is_among(const std::vector<Edge>& edges, const Point2& p) {
  bool odd = false;
  for (const Edge& e : edges) odd ^= polygon_polygon::detail::crossed_rightwards(e, p);
  return odd;
}
inline bool is_among(const std::vector<Edge>& edges, const InnerPoint& place) {
  return is_among(edges, [&]<class W>(const Point2& v) { return place.template way_to<W>({v[0], v[1], 0}); });
}

/// Bounds half-spaces of the plane in z, so that they have corners there.
inline HalfSpaces bounded_in_z(HalfSpaces solid) {
  for (const int up : {-1, 1}) solid.faces.push_back({half_spaces::Level{Vector<double, 3>(0, 0, up), 1}});
  return solid;
}

/// Whether a corner of a convex solid in the plane lies among edges; no if it has none.
inline bool corner_is_among(const std::vector<Edge>& edges, const HalfSpaces& solid) {
  const std::vector<half_spaces::Face> faces = sphere_half_spaces::detail::with_corners(solid);
  bool among = false;
  const auto found = [&](const auto& corner, const auto& scale) {
    const double turned = sign_of<long_text>(scale);
    among = is_among(edges, [&]<class W>(const Point2& v) -> Components<W, 2> {
      const Components<W, 3> x = corner.template operator()<W>();
      const W k = scale.template operator()<W>();
      return {W(turned) * (W(v[0]) * k - x[0]), W(turned) * (W(v[1]) * k - x[1])};
    });
    return false;  // one corner is enough
  };
  inequalities::all_corners(half_spaces::detail::count(faces), half_spaces::detail::text_of(faces), found, NoTrace());
  return among;
}

}  // namespace polygon_convex::detail

// How a polygon (A), an even-odd set as in isect/polygon_polygon.h, lies to a convex body (B). Exact, for all finite
// input. An empty shape, NaN or an infinite coordinate: disjoint.

template <class S>
Relation relate(const Polygon<S, 2>& polygon, const Capsule<S, 2>& capsule) {
  using namespace polygon_convex::detail;
  if (!polygon_polygon::detail::all_finite(polygon) || empty(capsule) || !finite(capsule)) return Relation::disjoint;
  if (capsule.radius == 0) return reversed(relate(Segment<S, 2>{capsule.p, capsule.q}, polygon));
  const Capsule<double, 2> body = cast<double>(capsule);
  return relation(
      polygon, [&](const Point2& p, const Point2& q) { return reach_of(body, p, q); },
      [&](const Point2& p) { return locate(p, body); },
      [&](const std::vector<Edge>& edges) { return is_among(edges, body.p); });
}
template <class S>
Relation relate(const Polygon<S, 2>& polygon, const Sphere<S, 2>& ball) {
  return relate(polygon, Capsule<S, 2>{ball.center, ball.center, ball.radius});
}

/// The half-spaces may be unbounded. They have an interior: else the result is disjoint (`intersects` is right then).
template <class S>
Relation relate(const Polygon<S, 2>& polygon, const HalfSpaces& solid) {
  using namespace polygon_convex::detail;
  assert(solid.dimension == 2);
  if (!polygon_polygon::detail::all_finite(polygon) || !half_spaces::detail::has_interior(solid.faces, NoTrace()))
    return Relation::disjoint;
  return relation(
      polygon, [&](const Point2& p, const Point2& q) { return reach_of(solid, p, q); },
      [&](const Point2& p) { return locate(p, solid); },
      [&](const std::vector<Edge>& edges) {
        const std::optional<InnerPoint> inner = inner_point(bounded_in_z(solid));
        return inner && is_among(edges, *inner);  // what is unbounded lies in no polygon
      });
}

// Whether they have a common point: an edge has one in the body, or all of the body lies within. Exact, for half-spaces
// without an interior, too.

template <class S>
bool intersects(const Polygon<S, 2>& polygon, const Capsule<S, 2>& capsule) {
  using namespace polygon_convex::detail;
  if (!polygon_polygon::detail::all_finite(polygon) || empty(capsule) || !finite(capsule)) return false;
  const std::vector<Edge> edges = edges_of(polygon);
  return std::ranges::any_of(edges, [&](const Edge& e) { return reach_of(capsule, e.p, e.q) >= 0; }) ||
         is_among(edges, Point2(capsule.p.template cast<double>()));
}
template <class S>
bool intersects(const Polygon<S, 2>& polygon, const Sphere<S, 2>& ball) {
  return intersects(polygon, Capsule<S, 2>{ball.center, ball.center, ball.radius});
}
template <class S>
bool intersects(const Polygon<S, 2>& polygon, const HalfSpaces& solid) {
  using namespace polygon_convex::detail;
  if (!polygon_polygon::detail::all_finite(polygon)) return false;
  const std::vector<Edge> edges = edges_of(polygon);
  return std::ranges::any_of(edges, [&](const Edge& e) { return reach_of(solid, e.p, e.q) >= 0; }) ||
         corner_is_among(edges, solid);
}

}  // namespace isect
