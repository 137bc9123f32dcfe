#pragma once
// Polygon against polygon by Boost.Geometry.

#include "bench/peer.h"
#include "bench/polygon_polygon/families.h"
#ifdef ISECT_HAS_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif

namespace isect::bench::peers {

/// Enters Boost for families in which each polygon is one simple outline.
inline void polygon_polygon([[maybe_unused]] Contest<double, PolygonPair<double>>& contest) {
#ifdef ISECT_HAS_BOOST
  namespace bg = boost::geometry;
  using TheirPoint = bg::model::d2::point_xy<double>;
  using TheirPolygon = bg::model::polygon<TheirPoint>;
  const auto converted = [](const PolygonPair<double>& c) {
    const auto one = [](const Polygon<double, 2>& p) {
      TheirPolygon theirs;
      for (const Point<double, 2>& v : p.rings[0]) theirs.outer().emplace_back(v[0], v[1]);
      bg::correct(theirs);
      return theirs;
    };
    return std::pair(one(c.a), one(c.b));
  };
  enter(contest, "Boost", "intersects", converted, [](const auto& c) { return bg::intersects(c.first, c.second); });
#endif
}

}  // namespace isect::bench::peers
