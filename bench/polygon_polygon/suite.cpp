// Polygon against polygon: whether they meet, and how they lie; by edges and corners in floating point, and exactly.

#include <isect/methods/point_polygon.h>
#include <isect/methods/segment_segment.h>
#include <isect/polygon_polygon.h>

#include "bench/contest.h"
#include "bench/named_draw.h"
#include "bench/polygon_polygon/families.h"
#include "bench/polygon_polygon/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/polygon_polygon/peers.h"
#endif

namespace isect::bench::polygon_polygon_suite {
namespace {

using Case = PolygonPair<double>;

std::string text_of(const Case& c) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Polygon<double, 2>* p : {&c.a, &c.b})
    for (const Ring<double, 2>& ring : p->rings) {
      text << (p == &c.a ? "a" : "b");
      for (const Point<double, 2>& v : ring) text << " (" << v[0] << ", " << v[1] << ")";
      text << "; ";
    }
  return text.str();
}

/// Two edges have a common point by their parameters, or the first corner of a ring lies inside by its crossings.
bool by_edges(const Polygon<double, 2>& a, const Polygon<double, 2>& b) {
  const auto edge = [](const Ring<double, 2>& r, std::size_t i) {
    return Segment<double, 2>{r[i], r[i + 1 < r.size() ? i + 1 : 0]};
  };
  for (const Ring<double, 2>& r : a.rings)
    for (std::size_t i = 0; i < r.size(); ++i)
      for (const Ring<double, 2>& s : b.rings)
        for (std::size_t k = 0; k < s.size(); ++k)
          if (segment_segment::parametric_naive(edge(r, i), edge(s, k))) return true;
  const auto holds = [](const Polygon<double, 2>& outer, const Polygon<double, 2>& inner) {
    return std::ranges::any_of(inner.rings, [&](const Ring<double, 2>& r) {
      bool inside = false;
      if (r.empty()) return false;
      for (const Ring<double, 2>& s : outer.rings) inside ^= point_polygon::crossings_naive(r.front(), s);
      return inside;
    });
  };
  return holds(a, b) || holds(b, a);
}

CaseFamily<Case> family(const char* test, const PolygonPairFamily& drawn, Truth (*truth)(const Case&)) {
  const bool hard = std::string_view(drawn.name) != "ordinary";
  CaseFamily<Case> all = {test, "double", drawn.name, drawn.note, hard, drawn.draw, truth, text_of};
  all.most_cases = 1 << 12;
  return all;
}

void compete(Session& session, const PolygonPairFamily& drawn) {
  Contest<double, Case> meet(session, family("polygon-polygon", drawn, [](const Case& c) -> Truth {
                               return {oracle::polygon_polygon_truth(c.a, c.b).meet, {}};
                             }));
  meet.enter("edges and corners", [](const Case& c) { return by_edges(c.a, c.b); }).standard();
  meet.enter("exact", [](const Case& c) { return intersects(c.a, c.b); }).exact();
#ifdef ISECT_PEERS
  if (drawn.simple) peers::polygon_polygon(meet);
#endif
  meet.run();

  Contest<double, Case> lie(session, family("polygon-polygon, six relations", drawn, [](const Case& c) -> Truth {
                              return {static_cast<int>(oracle::polygon_polygon_truth(c.a, c.b).relation()), {}};
                            }));
  lie.enter("exact", [](const Case& c) { return static_cast<int>(relate(c.a, c.b)); }).exact();
  lie.run();
}

}  // namespace

void measure(Session& session) {
  for (const char* test : {"polygon-polygon", "polygon-polygon, six relations"})
    session.aim({.work = std::string(test) + ": wrong verdicts", .kind = Target::wrong, .test = test, .at_most = 0});
  for (const PolygonPairFamily& drawn : polygon_pair_families) compete(session, drawn);
}

}  // namespace isect::bench::polygon_polygon_suite
