// Point in polygon in O(n): the question is whether the closed polygon holds the point, by the even-odd rule. The naive
// forms decide as they like on the boundary, so points on it are wrong in some and right in others.

#include <isect/point_polygon.h>

#include <isect/many/batch_point_polygon.h>
#include <isect/methods/point_polygon.h>
#include "bench/contest.h"
#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/point_polygon/peers.h"
#endif

namespace isect::bench::point_polygon_suite {
namespace {

template <class S>
using Case = PolygonCase<S>;

/// The point, and the edge that comes closest to it: alone, with a third vertex on either side, it fails alike.
template <class S>
std::string full_precision(const Case<S>& c) {
  const Ring<S, 2>& ring = *c.ring;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector<double, 2> a = (ring[i] - c.point).template cast<double>(),
                            e = (ring[(i + 1) % ring.size()] - ring[i]).template cast<double>();
    const double length2 = e.squaredNorm(), t = length2 > 0 ? std::clamp(-a.dot(e) / length2, 0.0, 1.0) : 0;
    const double distance = (a + t * e).norm();
    if (distance < least) least = distance, nearest = i;
  }
  return text("point", c.point, "nearest edge from", ring[nearest], "to", ring[(nearest + 1) % ring.size()], "of edges",
              ring.size());
}

template <class S>
void enter_batch(Contest<S, Case<S>>& contest, const Ring<S, 2>& ring, std::array<std::vector<S>, 2>& columns) {
  for (const Case<S>& c : contest.cases())
    for (int k = 0; k < 2; ++k) columns[k].push_back(c.point[k]);
  const PointBatch<S, 2> points = {{columns[0], columns[1]}};
  const auto answers = std::make_shared<std::vector<Location>>(locate(points, ring));
  contest
      .enter_pass(
          "batch",
          [points, &ring] {
            const std::vector<Location> where = locate(points, ring);
            asm volatile("" : : "r"(where.data()) : "memory");
          },
          [answers](std::size_t i) { return said((*answers)[i]); })
      .exact();
}

template <class S>
void compete(Session& session, const char* name, int n) {
  using namespace point_polygon;
  const PolygonFamily<S> family = polygon_family<S>(name, n);
  const std::string test = n == 100 ? "point-polygon" : "point-polygon, n = " + std::to_string(n);
  Contest<S, Case<S>> contest(session,
                              {test,
                               scalar_name<S>,
                               name,
                               family.note,
                               std::string_view(name) != "ordinary",
                               [&](Random& random) { return family.draw(random); },
                               [](const Case<S>& c) -> Truth { return truth_of(oracle::location(c.point, *c.ring)); },
                               full_precision<S>,
                               {},
                               (1 << 21) / std::max(n, 32)});
  contest.enter("division", [](const Case<S>& c) { return crossings_naive(c.point, *c.ring); }).standard();
  contest.enter("multiplication", [](const Case<S>& c) { return crossings_multiplied(c.point, *c.ring); });
  contest.enter("translated", [](const Case<S>& c) { return crossings_translated(c.point, *c.ring); });
  contest.enter("winding", [](const Case<S>& c) { return winding_naive(c.point, *c.ring) % 2 != 0; });
  contest.enter("exact", [](const Case<S>& c) { return locate(c.point, *c.ring); })
      .exact()
      .fallback([](const Case<S>& c) {
        return fell_back([&](const auto& trace) { locate(c.point, *c.ring, FillRule::even_odd, trace); });
      });
  std::array<std::vector<S>, 2> columns;
  if (family.rings.size() == 1) enter_batch(contest, family.rings[0], columns);
#ifdef ISECT_PEERS
  peers::point_polygon<S>(contest, family.simple);
#endif
  contest.run();
}

template <class S>
void compete_all(Session& session) {
  for (const char* name : {"ordinary", "near-edge", "on-vertex", "horizontal", "degenerate", "bow-tie", "far 1e5"})
    compete<S>(session, name, 100);
}

/// Fewer queries of larger polygons.
Ring<double, 2> queries(int n) { return points_in_square(std::clamp(50'000'000 / n, 64, 1 << 16)); }

void grow(Session& session) {
  using namespace point_polygon;
  Grown naive("point-in-polygon", "division", "query"), exact("point-in-polygon", "exact", "query"),
      batch("point-in-polygon", "batch", "query");
  for (const int n : sizes(session, 100)) {
    const Ring<double, 2> ring = polygon_family<double>("ordinary", n).rings.at(0), points = queries(n);
    naive.add(n, least_each(session, points, [&](const auto& p) { return crossings_naive(p, ring); }));
    exact.add(n, least_each(session, points, [&](const auto& p) { return locate(p, ring) != Location::out; }));
    std::array<std::vector<double>, 2> columns;
    for (const Point<double, 2>& p : points) columns[0].push_back(p[0]), columns[1].push_back(p[1]);
    const PointBatch<double, 2> all = {{columns[0], columns[1]}};
    batch.add(n, least_time(session, [&] { return locate(all, ring); }) / static_cast<double>(points.size()));
  }
  for (Grown* g : {&naive, &exact, &batch}) g->report(session);
#ifdef ISECT_PEERS
  peers::grow_point_polygon(session, queries);
#endif
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "point in polygon, 10 vertices",
               .test = "point-polygon, n = 10",
               .theirs = "Boost",
               .at_most = 1,
               .limit = "A call takes about as long for 24 vertices as for 8: it is its beginning and end, where "
                        "instructions are chosen and crossings counted."});
  session.aim_on_hard_input("point-polygon");
  for (const auto& [n, written] : {std::pair(1e2, "100"), std::pair(1e4, "10^4"), std::pair(1e6, "10^6")})
    session.aim(
        {.work = std::string("point in polygon, ") + written + " vertices",
         .kind = Target::growth,
         .test = "point-in-polygon",
         .theirs = "Boost",
         .n = n,
         .unit = "query",
         .at_most = 0.35,
         .limit = n == 1e2 ? "Two fifths of the time are the call's beginning and end, the rest its loop, by vectors "
                             "as wide as the machine has them."
                  : n == 1e4
                      ? "It is the loop itself, by vectors as wide as the machine has them: 1,000 vertices take as "
                        "long each."
                      : "It is the loop itself, by vectors as wide as the machine has them. An edge is 16 bytes; to "
                        "read those alone, from beyond the cache of the second level, would be some 0.45 × Boost."});
  compete_all<double>(session);
  compete<double>(session, "far 1e8", 100);  // floats of that size are 8 apart
  for (const int n : {10, 1000})
    for (const char* name : {"ordinary", "near-edge"}) compete<double>(session, name, n);
  compete_all<float>(session);
  session.progress("point-polygon, growth");
  grow(session);
}

}  // namespace isect::bench::point_polygon_suite
