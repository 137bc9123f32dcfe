#pragma once
// Point in polygon by Boost.Geometry and CGAL.

#include <map>

#include "bench/growth.h"
#include "bench/peer.h"
#include "bench/point_polygon/families.h"
#ifdef ISECT_HAS_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#ifdef ISECT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#endif

namespace isect::bench::peers {

/// A case in a library's types; cases of one ring share it.
template <class TheirPoint, class TheirRing>
struct TheirCase {
  TheirPoint point;
  std::shared_ptr<const TheirRing> ring;
};
/// Converts cases by point(p), once for each ring by ring(r).
template <class S, class ToPoint, class ToRing>
auto sharing_rings(const ToPoint& to_point, const ToRing& to_ring) {
  using TheirRing = std::decay_t<decltype(to_ring(Ring<S, 2>()))>;
  using ConvertedRings = std::map<const Ring<S, 2>*, std::shared_ptr<const TheirRing>>;
  return [=, known = std::make_shared<ConvertedRings>()](const PolygonCase<S>& c) {
    std::shared_ptr<const TheirRing>& ring = (*known)[c.ring];
    if (!ring) ring = std::make_shared<const TheirRing>(to_ring(*c.ring));
    return TheirCase<std::decay_t<decltype(to_point(c.point))>, TheirRing>{to_point(c.point), ring};
  };
}

#ifdef ISECT_HAS_BOOST
template <class S>
void boost_polygon(Contest<S, PolygonCase<S>>& contest) {
  namespace bg = boost::geometry;
  using TheirPoint = bg::model::d2::point_xy<S>;
  using TheirRing = bg::model::polygon<TheirPoint, false>;
  const auto to_point = [](const Point<S, 2>& p) { return TheirPoint(p[0], p[1]); };
  const auto converted = sharing_rings<S>(to_point, [=](const Ring<S, 2>& r) {
    TheirRing ring;
    for (const Point<S, 2>& v : r) ring.outer().push_back(to_point(v));
    if (!r.empty()) ring.outer().push_back(to_point(r[0]));
    return ring;
  });
  enter(contest, "Boost", "within, crossings_multiply", converted, [](const auto& c) {
    return bg::within(c.point, *c.ring, bg::strategy::within::crossings_multiply<TheirPoint>());
  });
  enter(contest, "Boost", "covered_by, winding", converted,
        [](const auto& c) { return bg::covered_by(c.point, *c.ring); });
}
#endif

#ifdef ISECT_HAS_CGAL
template <class Kernel, class S>
Entrant<PolygonCase<S>>& cgal_polygon(Contest<S, PolygonCase<S>>& contest, const char* name) {
  using Corner = typename Kernel::Point_2;
  const auto to_point = [](const Point<S, 2>& p) { return Corner(p[0], p[1]); };
  const auto converted = sharing_rings<S>(to_point, [=](const Ring<S, 2>& r) {
    std::vector<Corner> ring;
    for (const Point<S, 2>& v : r) ring.push_back(to_point(v));
    return ring;
  });
  return enter(contest, "CGAL", name, converted, [](const auto& c) {
    return CGAL::bounded_side_2(c.ring->begin(), c.ring->end(), c.point, Kernel()) != CGAL::ON_UNBOUNDED_SIDE;
  });
}
#endif

/// CGAL promises an answer for simple polygons only.
template <class S>
void point_polygon([[maybe_unused]] Contest<S, PolygonCase<S>>& contest, [[maybe_unused]] bool simple) {
#ifdef ISECT_HAS_BOOST
  boost_polygon(contest);
#endif
#ifdef ISECT_HAS_CGAL
  if (!simple) return;
  cgal_polygon<CGAL::Simple_cartesian<double>>(contest, "bounded_side_2, inexact");
  cgal_polygon<CGAL::Exact_predicates_inexact_constructions_kernel>(contest, "bounded_side_2, EPICK").exact();
#endif
}

/// Boost's fastest way, at the sizes and queries(n) of the suite.
template <class Queries>
void grow_point_polygon([[maybe_unused]] Session& session, [[maybe_unused]] const Queries& queries) {
#ifdef ISECT_HAS_BOOST
  namespace bg = boost::geometry;
  using TheirPoint = bg::model::d2::point_xy<double>;
  Grown crossings("point-in-polygon", "within, crossings_multiply", "query", "Boost");
  for (const int n : sizes(session, 100)) {
    bg::model::polygon<TheirPoint, false> polygon;
    const Ring<double, 2> ring = polygon_family<double>("ordinary", n).rings.at(0);
    for (const Point<double, 2>& v : ring) polygon.outer().emplace_back(v[0], v[1]);
    polygon.outer().emplace_back(ring[0][0], ring[0][1]);
    crossings.add(n, least_each(session, queries(n), [&](const Point<double, 2>& p) {
                    return bg::within(TheirPoint(p[0], p[1]), polygon,
                                      bg::strategy::within::crossings_multiply<TheirPoint>());
                  }));
  }
  crossings.report(session);
#endif
}

}  // namespace isect::bench::peers
