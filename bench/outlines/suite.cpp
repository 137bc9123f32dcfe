// Rays and segments against polygons in the plane and in space, balls, capsules and half-spaces against those in the
// plane, and segments against each other: whether they meet, by naive code and exactly.

#include <algorithm>

#include <isect/polygon_convex.h>
#include <isect/polygon_polygon.h>
#include <isect/ray_outline.h>
#include <isect/segment_polygon.h>
#include <isect/segment_segment.h>

#include "bench/capsule_capsule/oracle.h"
#include "bench/half_spaces/oracle.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"
#include "bench/polygon_polygon/oracle.h"
#include "bench/ray_outline/oracle.h"
#include "bench/straight_lines.h"

namespace isect::bench::outlines_suite {
namespace {

using oracle::P2, oracle::Rational, oracle::rational, oracle::operator-;

double cross(const Vector<double, 2>& a, const Vector<double, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Whether p is inside by the even-odd rule, by crossings with a division.
bool inside(const Point<double, 2>& p, const Ring<double, 2>& ring) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point<double, 2>&a = ring[i], &b = ring[j];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]) in = !in;
  }
  return in;
}
/// Whether the line crosses an edge, or starts inside.
bool meets(const Line<2>& l, const Ring<double, 2>& ring) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vector<double, 2> e = ring[j] - ring[i], f = ring[i] - l.p;
    const double determinant = cross(l.d, e);
    if (determinant == 0) continue;
    const double t = cross(f, e) / determinant, u = cross(f, l.d) / determinant;
    if (0 <= t && t <= l.most && 0 <= u && u <= 1) return true;
  }
  return inside(l.p, ring);
}

bool truly_meets(const TrueLine<2>& l, const Polygon<double, 2>& polygon) {
  if (oracle::dot(l.d, l.d) == 0) return oracle::locate(l.p, rational(polygon)) != Location::out;
  return oracle::first_hit(l.p, l.d, l.range, rational(polygon)).has_value();
}

template <class Straight, class Exact>
void in_plane(Session& session, const char* test, const Exact& exact) {
  using Outline = Polygon<double, 2>;
  PairContest<Straight, Outline>(session, test)  // Boost has no rays
      .run([](const Straight& s, const Outline& p) { return meets(line(s), p.rings[0]); }, exact,
           [](const Straight& s, const Outline& p) { return truly_meets(true_line(s), p); });
}

/// The exact call is the core's intersects, which asks how the stretches of both overlap.
template <class Straight>
void related_in_plane(Session& session, const char* test) {
  using Outline = Polygon<double, 2>;
  const auto truly = [](const Straight& s, const Outline& p) {
    const TrueLine<2> l = true_line(s);
    if (oracle::dot(l.d, l.d) == 0) return truly_meets(l, p);
    const std::optional<Rational> end = std::isinf(l.range.hi) ? std::nullopt : std::optional<Rational>(1);
    return oracle::line_polygon_truth(l.p, l.d, Rational(0), end, p) != Relation::disjoint;
  };
  PairContest<Straight, Outline>(session, test, 1 << 11)
      .run([](const Straight& s, const Outline& p) { return meets(line(s), p.rings[0]); },
           [](const Straight& s, const Outline& p) { return intersects(s, p); }, truly);
}

/// Whether the point where it crosses Newell's plane lies in the ring, both projected along the largest component.
bool crosses(const Line<3>& l, const Ring<double, 3>& ring) {
  Vector<double, 3> n = Vector<double, 3>::Zero();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    for (int k = 0; k < 3; ++k) {
      const int y = (k + 1) % 3, z = (k + 2) % 3;
      n[k] += (ring[j][y] - ring[i][y]) * (ring[j][z] + ring[i][z]);
    }
  const double along = n.dot(l.d), t = n.dot(ring[0] - l.p) / along;
  if (along == 0 || !(0 <= t && t <= l.most)) return false;
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  const int x = axis == 0 ? 1 : 0, y = axis == 2 ? 1 : 2;
  const Point<double, 3> at = l.p + t * l.d;
  Ring<double, 2> outline;
  for (const Point<double, 3>& v : ring) outline.emplace_back(v[x], v[y]);
  return inside({at[x], at[y]}, outline);
}
const Ring<double, 3>& ring_of(const Ring<double, 3>& ring) { return ring; }
const Ring<double, 3>& ring_of(const Polygon<double, 3>& polygon) { return polygon.rings[0]; }

/// `in_it`: whether a line in the plane of the polygon may meet it, too.
template <class Straight, class Outline, bool in_it, class Exact>
void in_space(Session& session, const char* test, const Exact& exact) {
  const auto truly = [](const Straight& s, const Outline& p) {
    const TrueLine<3> l = true_line(s);
    const Ring<double, 3>& ring = ring_of(p);
    const oracle::RayPolygon across = oracle::ray_polygon(l.p, l.d, l.range, ring);
    if (across.flat || !across.coplanar || !in_it) return across.hit;
    std::vector<oracle::Coordinates<3>> v;
    for (const Point<double, 3>& x : ring) v.push_back(rational(x));
    const int axis = oracle::steepest(oracle::newell(v)), x = axis == 0 ? 1 : 0, y = axis == 2 ? 1 : 2;
    Polygon<double, 2> outline = {{{}}};
    for (const Point<double, 3>& corner : ring) outline.rings[0].emplace_back(corner[x], corner[y]);
    return truly_meets({{l.p[x], l.p[y]}, {l.d[x], l.d[y]}, l.range}, outline);
  };
  PairContest<Straight, Outline>(session, test)  // no peer asks this
      .run([](const Straight& s, const Outline& p) { return crosses(line(s), ring_of(p)); }, exact, truly);
}

// Convex bodies.

template <class Meets>
bool any_edge(const Polygon<double, 2>& polygon, const Meets& meets) {
  const Ring<double, 2>& ring = polygon.rings[0];
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (meets(ring[j], ring[i])) return true;
  return false;
}

/// The squared distance of p from an edge.
double distance2(const Point<double, 2>& p, const Point<double, 2>& a, const Point<double, 2>& b) {
  const Vector<double, 2> d = b - a;
  const double along = d.squaredNorm(), t = along > 0 ? std::clamp((p - a).dot(d) / along, 0., 1.) : 0;
  return (p - a - t * d).squaredNorm();
}
bool near(const Capsule<double, 2>& c, const Point<double, 2>& a, const Point<double, 2>& b) {
  const auto crosses = [](const Point<double, 2>& p, const Point<double, 2>& q, const Point<double, 2>& v,
                          const Point<double, 2>& w) { return cross(q - p, v - p) * cross(q - p, w - p) < 0; };
  const double least =
      std::min({distance2(c.p, a, b), distance2(c.q, a, b), distance2(a, c.p, c.q), distance2(b, c.p, c.q)});
  return least <= c.radius * c.radius || (crosses(c.p, c.q, a, b) && crosses(a, b, c.p, c.q));
}
/// Whether any part of the edge is left within the box's slabs.
bool near(const Aabb<double, 2>& box, const Point<double, 2>& a, const Point<double, 2>& b) {
  double from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    if (d == 0 && (a[i] < box.lo[i] || a[i] > box.hi[i])) return false;
    if (d == 0) continue;
    const double t = (box.lo[i] - a[i]) / d, u = (box.hi[i] - a[i]) / d;
    from = std::max(from, std::min(t, u)), to = std::min(to, std::max(t, u));
  }
  return from <= to;
}
bool truly_near(const Capsule<double, 2>& c, const Point<double, 2>& a, const Point<double, 2>& b) {
  const Rational r = c.radius;
  return oracle::distance2<2>(oracle::stretch(c), oracle::stretch(Capsule<double, 2>{a, b, 0})) <= Rational(r * r);
}
bool truly_near(const Aabb<double, 2>& box, const Point<double, 2>& a, const Point<double, 2>& b) {
  const auto at = [](const Point<double, 2>& p) { return oracle::Place{Rational(p[0]), Rational(p[1]), 0}; };
  const Aabb<double, 3> plate = {{box.lo[0], box.lo[1], 0}, {box.hi[0], box.hi[1], 0}};
  return oracle::part(at(a), at(b), oracle::sides(plate)).has_value();
}

Capsule<double, 2> body_of(const Sphere<double, 2>& b) { return {b.center, b.center, b.radius}; }
const Capsule<double, 2>& body_of(const Capsule<double, 2>& c) { return c; }
const Aabb<double, 2>& body_of(const Aabb<double, 2>& box) { return box; }
const Point<double, 2>& some_point(const Capsule<double, 2>& c) { return c.p; }
const Point<double, 2>& some_point(const Aabb<double, 2>& box) { return box.lo; }
const Sphere<double, 2>& in_core(const Sphere<double, 2>& b) { return b; }
const Capsule<double, 2>& in_core(const Capsule<double, 2>& c) { return c; }
HalfSpaces in_core(const Aabb<double, 2>& box) { return half_spaces_of(box); }

/// No peer answers this, except Boost for a box, and that within a tolerance.
template <class Shape>
void bodies(Session& session, const char* test) {
  using Outline = Polygon<double, 2>;
  PairContest<Shape, Outline>(session, test, 1 << 10)
      .only([](const Shape& x, const Outline&) { return !empty(x); })
      .run(
          [](const Shape& x, const Outline& p) {
            const auto& body = body_of(x);
            return any_edge(p, [&](const auto& a, const auto& b) { return near(body, a, b); }) ||
                   inside(some_point(body), p.rings[0]);
          },
          [](const Shape& x, const Outline& p) { return intersects(p, in_core(x)); },
          [](const Shape& x, const Outline& p) {
            const auto& body = body_of(x);
            return any_edge(p, [&](const auto& a, const auto& b) { return truly_near(body, a, b); }) ||
                   oracle::locate(rational(some_point(body)), rational(p)) != Location::out;
          });
}

void segments(Session& session) {
  using Edge = Segment<double, 2>;
  const auto parametric = [](const Edge& a, const Edge& b) {
    const Vector<double, 2> d = a.q - a.p, e = b.q - b.p, f = b.p - a.p;
    const double determinant = cross(d, e), t = cross(f, e) / determinant, u = cross(f, d) / determinant;
    return determinant != 0 && 0 <= t && t <= 1 && 0 <= u && u <= 1;
  };
  const auto truly = [](const Edge& a, const Edge& b) {
    const auto on = [](const P2& x, const Edge& s) {  // a ring of two corners
      return oracle::locate(x, std::vector{rational(s.p), rational(s.q)}) == Location::on;
    };
    if (on(rational(a.p), b) || on(rational(a.q), b) || on(rational(b.p), a) || on(rational(b.q), a)) return true;
    const P2 d = rational(a.q) - rational(a.p), e = rational(b.q) - rational(b.p), f = rational(b.p) - rational(a.p);
    namespace of = oracle::polygon_polygon;
    const Rational determinant = of::cross2(d, e);
    if (determinant == 0) return false;
    const Rational t = of::cross2(f, e) / determinant, u = of::cross2(f, d) / determinant;
    return 0 <= t && t <= 1 && 0 <= u && u <= 1;
  };
  PairContest<Edge, Edge>(session, "segment-segment")
      .run(
          parametric, [](const Edge& a, const Edge& b) { return intersects(a, b); }, truly, peers::meet_by_cgal);
}

}  // namespace

void measure(Session& session) {
  const auto hits = [](const auto& s, const auto& p) { return first_hit(s, p).has_value(); };
  in_plane<Ray<double, 2>>(session, "ray-polygon ray-outline", hits);
  in_plane<Segment<double, 2>>(session, "segment-polygon ray-outline", hits);
  related_in_plane<Ray<double, 2>>(session, "ray-polygon polygon-polygon");
  related_in_plane<Segment<double, 2>>(session, "segment-polygon polygon-polygon");
  in_space<Ray<double, 3>, Polygon<double, 3>, true>(session, "ray-polygon ray-outline in space", hits);
  in_space<Segment<double, 3>, Polygon<double, 3>, true>(session, "segment-polygon ray-outline in space", hits);
  const auto crossed = [](const auto& s, const auto& p) { return intersect(s, p).t.has_value(); };
  in_space<Segment<double, 3>, Polygon<double, 3>, false>(session, "segment-polygon", crossed);
  in_space<Segment<double, 3>, Ring<double, 3>, false>(session, "segment-ring", crossed);
  bodies<Sphere<double, 2>>(session, "polygon-sphere");
  bodies<Capsule<double, 2>>(session, "polygon-capsule");
  bodies<Aabb<double, 2>>(session, "polygon-half-spaces");
  segments(session);
}

}  // namespace isect::bench::outlines_suite
