#pragma once
// Convex polygons by Boost.Geometry, which knows polygons of any form only.

#include "bench/convex_polygons/families.h"
#include "bench/peer.h"
#ifdef ISECT_HAS_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif

namespace isect::bench::peers {

inline void convex_polygons([[maybe_unused]] Contest<double, ConvexPolygons<double>>& contest) {
#ifdef ISECT_HAS_BOOST
  namespace bg = boost::geometry;
  using TheirPolygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
  const auto converted = [](const ConvexPolygons<double>& c) {
    const auto one = [](const ConvexPolygon<double>& p) {
      TheirPolygon theirs;
      for (const Point<double, 2>& v : p.vertices) theirs.outer().emplace_back(v[0], v[1]);
      bg::correct(theirs);
      return theirs;
    };
    return std::pair(one(c.a), one(c.b));
  };
  enter(contest, "Boost", "intersects", converted, [](const auto& c) { return bg::intersects(c.first, c.second); });
#endif
}

}  // namespace isect::bench::peers
