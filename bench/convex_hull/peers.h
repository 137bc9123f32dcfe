#pragma once
// Hulls by CGAL and qhull.

#include "bench/growth.h"
#include "bench/growth_shapes.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include "bench/convex_hull/cgal_points.h"
#endif
#ifdef ISECT_HAS_QHULL
#include "bench/convex_hull/qhull.h"
#endif

namespace isect::bench::peers {

#ifdef ISECT_HAS_CGAL
inline auto cgal_disc(bool circle) {
  return [circle](int n) {
    std::vector<HullKernel::Point_2> points;
    for (const Point<double, 2>& p : disc(n, circle)) points.emplace_back(p[0], p[1]);
    return points;
  };
}
#endif

inline void convex_hull([[maybe_unused]] Session& session) {
  [[maybe_unused]] constexpr const char* unit = "set of points";
#ifdef ISECT_HAS_CGAL
  const auto hull2 = [](const auto& points) {
    std::vector<HullKernel::Point_2> hull;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    return hull.size();
  };
  const auto hull3 = [](const auto& points) {
    CGAL::Surface_mesh<HullKernel::Point_3> mesh;
    CGAL::convex_hull_3(points.begin(), points.end(), mesh);
    return mesh.number_of_vertices();
  };
  grow(session, "hull 2D, disc", "convex_hull_2", unit, cgal_disc(false), hull2, "CGAL");
  grow(session, "hull 2D, circle", "convex_hull_2", unit, cgal_disc(true), hull2, "CGAL");
  grow(session, "hull 3D", "convex_hull_3", unit, cgal_cloud(true), hull3, "CGAL");
  grow(session, "hull 3D, sphere", "convex_hull_3", unit, cgal_cloud(false), hull3, "CGAL");
#endif
#ifdef ISECT_HAS_QHULL
  for (const bool ball : {true, false})
    grow(
        session, ball ? "hull 3D" : "hull 3D, sphere", "qh_new_qhull", unit, [&](int n) { return cloud(n, ball); },
        [](const auto& points) { return qhull_vertices(points); }, "qhull");
#endif
}

}  // namespace isect::bench::peers
