#pragma once
// The questions in the plane asked of installed libraries: rows of peer_speed, each beside the core's. Their answers
// are counted as hits, for comparison; CGAL's exact kernel is a second opinion on every one of ours.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <iterator>

#include "bench/measure.h"
#include "core/shapes.h"

namespace isect::bench::peers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Kernel::Point_2 cgal(const Point<double, 2>& p) { return {p[0], p[1]}; }

template <class Cases>
void orientation(Table& table, const Cases& cases, int passes) {
  struct Three {
    Kernel::Point_2 a, b, c;
  };
  std::vector<Three> all;
  for (const auto& t : cases) all.push_back({cgal(t.a), cgal(t.b), cgal(t.c)});
  table.row("CGAL", timed(all, passes, [](const Three& t) {
              return CGAL::orientation(t.a, t.b, t.c) == CGAL::LEFT_TURN;
            }));
}

inline void polygon(Table& table, const Ring<double, 2>& ring, const Ring<double, 2>& points, int passes) {
  namespace bg = boost::geometry;
  using BoostPoint = bg::model::d2::point_xy<double>;
  bg::model::polygon<BoostPoint, false> polygon;
  for (const Point<double, 2>& v : ring) polygon.outer().emplace_back(v[0], v[1]);
  polygon.outer().emplace_back(ring[0][0], ring[0][1]);
  const bg::strategy::within::crossings_multiply<BoostPoint> crossings;
  table.row("Boost crossings_multiply", timed(points, passes, [&](const auto& p) {
              return bg::within(BoostPoint(p[0], p[1]), polygon, crossings);
            }));
  table.row("Boost winding", timed(points, passes, [&](const auto& p) {
              return bg::covered_by(BoostPoint(p[0], p[1]), polygon);
            }));

  std::vector<Kernel::Point_2> vertices;
  for (const Point<double, 2>& v : ring) vertices.push_back(cgal(v));
  table.row("CGAL bounded_side_2", timed(points, passes, [&](const auto& p) {
              return CGAL::bounded_side_2(vertices.begin(), vertices.end(), cgal(p), Kernel()) !=
                     CGAL::ON_UNBOUNDED_SIDE;
            }));
}

inline void hull(Table& table, const std::vector<Ring<double, 2>>& sets) {
  std::vector<std::vector<Kernel::Point_2>> all(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const Point<double, 2>& p : sets[i]) all[i].push_back(cgal(p));
  table.row("CGAL convex_hull_2", timed(all, 3, [](const auto& points) {
              std::vector<Kernel::Point_2> hull;
              CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
              return hull.size();
            }));
}

}  // namespace isect::bench::peers
