// Clipping: what boxes and half-spaces keep of rays, segments and polygons; and convex polygons against each other,
// which clipping, too, would decide.

#include <isect/clip_polygon.h>
#include <isect/clip_segment.h>
#include <isect/convex_polygons.h>
#include <isect/methods/clip_polygon.h>

#include "bench/clip_polygon/oracle.h"
#include "bench/clip_segment/oracle.h"
#include "bench/convex_polygons/families.h"
#include "bench/convex_polygons/oracle.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"
#include "bench/straight_lines.h"
#ifdef ISECT_PEERS
#include "bench/clipping/peers.h"
#endif

namespace isect::bench::clipping_suite {
namespace {

using Beam = Ray<double, 3>;
using Edge = Segment<double, 3>;
using Box = Aabb<double, 3>;
using Wall = Plane<double, 3>;
using oracle::Rational, oracle::rational, oracle::operator+;

/// Clips the range `kept` of t by one half-space; whether any t is left.
bool keep(Interval<double>& kept, double height, double rate) {
  if (rate > 0) kept.lo = std::max(kept.lo, -height / rate);
  if (rate < 0) kept.hi = std::min(kept.hi, -height / rate);
  return (rate != 0 || height >= 0) && kept.lo <= kept.hi;
}

/// Clips the line by the box's sides, as Liang and Barsky do.
template <class Straight>
void at_boxes(Session& session, const char* test) {
  const auto by_sides = [](const Straight& s, const Box& b) {
    const Line<3> l = line(s);
    Interval<double> kept = {0, l.most};
    for (int i = 0; i < 3; ++i)
      if (!keep(kept, l.p[i] - b.lo[i], l.d[i]) || !keep(kept, b.hi[i] - l.p[i], -l.d[i])) return false;
    return true;
  };
  const auto truly = [](const Straight& s, const Box& b) {
    const TrueLine<3> l = true_line(s);
    std::optional<Rational> lo, hi;
    for (int i = 0; i < 3; ++i)
      for (const int side : {1, -1}) {
        const Rational bound(side > 0 ? b.lo[i] : b.hi[i]);
        const auto part = oracle::kept_above(l.range, side * (l.p[i] - bound), side * (l.p[i] + l.d[i] - bound));
        if (!part) return false;
        if (part->lo && (!lo || *lo < *part->lo)) lo = part->lo;
        if (part->hi && (!hi || *hi > *part->hi)) hi = part->hi;
      }
    return !lo || !hi || *lo <= *hi;
  };
  PairContest<Straight, Box>(session, test)
      .run(
          by_sides, [](const Straight& s, const Box& b) { return clip(s, b).has_value(); }, truly, peers::meet_by_cgal);
}

template <class Straight>
void at_planes(Session& session, const char* test) {
  const auto by_quotient = [](const Straight& s, const Wall& w) {
    const Line<3> l = line(s);
    Interval<double> kept = {0, l.most};
    return keep(kept, w.normal.dot(l.p) + w.d, w.normal.dot(l.d));
  };
  const auto truly = [](const Straight& s, const Wall& w) {
    const TrueLine<3> l = true_line(s);
    return oracle::kept_above(l.range, oracle::height<double, 3>(w, l.p), oracle::height<double, 3>(w, l.p + l.d))
        .has_value();
  };
  PairContest<Straight, Wall>(session, test)  // no peer asks this
      .run(
          by_quotient, [](const Straight& s, const Wall& w) { return clip(s, w).has_value(); }, truly);
}

/// How many vertices are left.
void polygons_at_planes(Session& session) {
  using Outline = Ring<double, 3>;
  const auto count = [](const auto& ring) { return static_cast<int>(ring.size()); };
  PairContest<Outline, Wall>(session, "ring-plane")  // no peer asks this
      .run([=](const Outline& r, const Wall& w) { return count(clip_polygon::sutherland_hodgman(r, w)); },
           [=](const Outline& r, const Wall& w) { return count(clip(r, w)); },
           [=](const Outline& r, const Wall& w) { return count(oracle::clipped<double, 3>(r, w)); });
}

/// How many of the polygon's own vertices are left, if all of what is left lies in the box; else -1.
void polygons_at_boxes(Session& session) {
  using Outline = Ring<double, 2>;
  using Square = Aabb<double, 2>;
  const auto in = [](const Point<double, 2>& x, const Square& b) {
    return (b.lo.array() <= x.array()).all() && (x.array() <= b.hi.array()).all();
  };
  const auto kept_in = [in](const Outline& r, const Outline& left, const Square& b) {
    if (!std::ranges::all_of(left, [&](const auto& x) { return in(x, b); })) return -1;
    return static_cast<int>(std::ranges::count_if(r, [&](const auto& x) { return std::ranges::count(left, x) > 0; }));
  };
  const auto by_planes = [kept_in](const Outline& r, const Square& b) {
    Outline left = r;
    for (int i = 0; i < 2; ++i) {
      const Vector<double, 2> unit = Vector<double, 2>::Unit(i);
      left = clip_polygon::sutherland_hodgman(left, Plane<double, 2>{unit, -b.lo[i]});
      left = clip_polygon::sutherland_hodgman(left, Plane<double, 2>{-unit, b.hi[i]});
    }
    return kept_in(r, left, b);
  };
  const auto truly = [](const Outline& r, const Square& b) {
    return static_cast<int>(std::ranges::count_if(r, [&](const Point<double, 2>& x) {
      bool within = true;
      for (int i = 0; i < 2; ++i) within &= Rational(b.lo[i]) <= Rational(x[i]) && Rational(x[i]) <= Rational(b.hi[i]);
      return within;
    }));
  };
  PairContest<Outline, Square>(session, "ring-aabb")  // no peer says this of its vertices
      .run(
          by_planes, [kept_in](const Outline& r, const Square& b) { return kept_in(r, clip(r, b), b); }, truly);
}

/// Whether an edge of the first has all of the second on its right.
bool edge_separates(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b) {
  for (std::size_t i = 0, j = a.vertices.size() - 1; i < a.vertices.size(); j = i++) {
    const Point<double, 2>& from = a.vertices[j];
    const Vector<double, 2> e = a.vertices[i] - from;
    if (std::ranges::all_of(b.vertices, [&](const Point<double, 2>& x) {
          return e[0] * (x[1] - from[1]) - e[1] * (x[0] - from[0]) < 0;
        }))
      return true;
  }
  return false;
}
void convex_polygons(Session& session) {
  using Case = ConvexPolygons<double>;
  const char* test = "convex-polygon-convex-polygon";
  session.aim({.work = std::string(test) + ": wrong verdicts", .kind = Target::wrong, .test = test, .at_most = 0});
  for (const NamedDraw<Case>& drawn : convex_polygons_draws<double>) {
    CaseFamily<Case> family = {
        test,
        "double",
        drawn.name,
        drawn.note,
        drawn.hard(),
        drawn.draw,
        [](const Case& c) { return truth_that(oracle::relation(c.a, c.b) != Relation::disjoint); },
        [](const Case& c) { return "a: " + full_precision(c.a.vertices) + "; b: " + full_precision(c.b.vertices); }};
    family.most_cases = 1 << 12;
    Contest<double, Case> contest(session, family);
    contest.enter("naive", [](const Case& c) { return !edge_separates(c.a, c.b) && !edge_separates(c.b, c.a); })
        .standard();
    contest.enter("exact", [](const Case& c) { return intersects(c.a, c.b); }).exact();
#ifdef ISECT_PEERS
    peers::convex_polygons(contest);
#endif
    contest.run();
  }
}

}  // namespace

void measure(Session& session) {
  at_boxes<Beam>(session, "ray-aabb clip-segment");
  at_boxes<Edge>(session, "segment-aabb");
  at_planes<Beam>(session, "ray-plane clip-segment");
  at_planes<Edge>(session, "segment-plane clip-segment");
  polygons_at_planes(session);
  polygons_at_boxes(session);
  convex_polygons(session);
}

}  // namespace isect::bench::clipping_suite
