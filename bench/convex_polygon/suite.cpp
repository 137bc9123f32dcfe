// Point in convex polygon in O(lg n): whether the closed polygon holds the point; and how the time of a query grows.

#include <isect/convex_hull.h>
#include <isect/methods/point_convex_polygon.h>
#include <isect/point_convex_polygon.h>
#include "bench/contest.h"
#include "bench/growth.h"
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "bench/session.h"

namespace isect::bench::convex_polygon_suite {
namespace {

template <class S>
struct Case {
  Point<S, 2> point;
  const ConvexPolygon<S>* polygon;
};
template <class S>
using Polygons = std::vector<ConvexPolygon<S>>;

/// The hull of n points of an ellipse of that height: nearly n vertices, as roundoff makes some concave.
template <class S>
Polygons<S> ellipse(int n, double height) {
  Ring<S, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    ring.push_back({static_cast<S>(std::cos(angle)), static_cast<S>(height * std::sin(angle))});
  }
  return {make_convex(convex_hull(ring)).value()};
}
/// A half disc that begins and ends with its diameter, whose direction and place are not round numbers.
template <class S>
Polygons<S> half_disc(int n) {
  Ring<S, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.5 + std::numbers::pi * i / (n - 1);
    ring.push_back({static_cast<S>(0.1 + std::cos(angle)), static_cast<S>(0.7 + std::sin(angle))});
  }
  return {make_convex(ring).value()};
}
/// Triangles whose third vertex lies up to 4 ulp beside the middle of the others.
template <class S>
Polygons<S> sliver_triangles() {
  Random random(stream(1, "slivers"));
  Polygons<S> all;
  while (all.size() < 256) {
    const Point<S, 2> a = random.in_box<2>(1).template cast<S>(), b = random.in_box<2>(1).template cast<S>();
    Point<S, 2> c = a / S(2) + b / S(2);
    for (int k = 0; k < 2; ++k) c[k] = moved(c[k], random.integer(-4, 4));
    if (auto convex = make_convex(Ring<S, 2>{a, b, c})) all.push_back(*std::move(convex));
  }
  return all;
}

/// A point within 2 ulp of the edge from the last vertex to the first, where the fan of wedges begins and ends.
template <class S>
Point<S, 2> near_closing_edge(Random& random, const Ring<S, 2>& ring) {
  return polygon_families::near_edge(random, Ring<S, 2>{ring.back(), ring[0]});
}

template <class S>
struct Family {
  const char* name;
  Polygons<S> polygons;
  Point<S, 2> (*point)(Random&, const Ring<S, 2>&);
  const char* note = "";  ///< of NamedDraw

  Case<S> draw(Random& random) const {
    const ConvexPolygon<S>& polygon = polygons[random.below(static_cast<int>(polygons.size()))];
    return {point(random, polygon.vertices), &polygon};
  }
};

template <class S>
void compete(Session& session, const Family<S>& family, int n) {
  const std::string test = "convex-polygon" + (n == 64 ? std::string() : ", n = " + std::to_string(n));
  Contest<S, Case<S>> contest(
      session, {test,
                scalar_name<S>,
                family.name,
                family.note,
                std::string_view(family.name) != "ordinary",
                [&](Random& random) { return family.draw(random); },
                [](const Case<S>& c) -> Truth { return truth_of(oracle::location(c.point, c.polygon->vertices)); },
                [](const Case<S>& c) {
                  const Ring<S, 2>& v = c.polygon->vertices;
                  return text("point", c.point, "vertex 0", v[0], "vertex 1", v[1], "last vertex", v.back(), "of",
                              v.size());
                },
                {},
                n > 100'000 ? 1 << 12 : 1 << 16});  // the oracle looks at all vertices
  contest.enter("wedges", [](const Case<S>& c) { return point_convex_polygon::wedge_naive(c.point, *c.polygon); })
      .standard();
  contest.enter("exact", [](const Case<S>& c) { return locate(c.point, *c.polygon); })
      .exact()
      .fallback(
          [](const Case<S>& c) { return fell_back([&](const auto& trace) { locate(c.point, *c.polygon, trace); }); });
  contest.run();
}

constexpr const char* near_edge_note = "points on an edge but for rounding, and up to 2 ulp beside that.";

template <class S>
void compete_all(Session& session) {
  using polygon_families::anywhere, polygon_families::near_edge;
  compete<S>(session, {"ordinary", ellipse<S>(64, 1), anywhere<S>}, 64);
  compete<S>(session, {"near-edge", ellipse<S>(64, 1), near_edge<S>, near_edge_note}, 64);
  compete<S>(session,
             {"closing edge", half_disc<S>(64), near_closing_edge<S>,
              "the same of the long edge at which the fan of wedges begins and ends."},
             64);
  compete<S>(session,
             {"flat", ellipse<S>(64, sizeof(S) == 4 ? 1e-5 : 1e-13), near_edge<S>,
              "the same of an ellipse as flat as the scalar allows."},
             64);
  compete<S>(session,
             {"sliver triangles", sliver_triangles<S>(), near_edge<S>,
              "triangles a few ulp high, whose centroid may lie outside when rounded."},
             64);
}

void grow(Session& session) {
  Grown naive("point-in-convex-polygon", "wedges", "query"), exact("point-in-convex-polygon", "exact", "query");
  Random random(stream(session.seed, "convex growth"));
  Ring<double, 2> points;
  for (int i = 0; i < 1 << 16; ++i) points.push_back(random.in_box<2>(1));
  for (const int n : sizes(session, 100)) {
    const ConvexPolygon<double> polygon = ellipse<double>(n, 1)[0];
    naive.add(
        n, least_each(session, points, [&](const auto& p) { return point_convex_polygon::wedge_naive(p, polygon); }));
    exact.add(n, least_each(session, points, [&](const auto& p) { return locate(p, polygon) != Location::out; }));
  }
  for (Grown* g : {&naive, &exact}) g->report(session);
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "point in a convex polygon, 10^6 vertices",
               .kind = Target::time,
               .test = "point-in-convex-polygon",
               .n = 1e6,
               .unit = "query",
               .at_most = 60});
  session.aim_on_hard_input("convex-polygon");
  compete_all<double>(session);
  compete_all<float>(session);
  using polygon_families::anywhere, polygon_families::near_edge;
  for (const int n : {10'000, 1'000'000}) {
    if (n > 10'000 && !session.effort.all_sizes) continue;
    compete<double>(session, {"ordinary", ellipse<double>(n, 1), anywhere<double>}, n);
    compete<double>(session, {"near-edge", ellipse<double>(n, 1), near_edge<double>, near_edge_note}, n);
  }
  session.progress("convex-polygon, growth");
  grow(session);
}

}  // namespace isect::bench::convex_polygon_suite
