#pragma once
// Hulls by CGAL and qhull, smallest spheres by CGAL.

#include "bench/growth.h"
#include "bench/growth_shapes.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#endif
#ifdef ISECT_HAS_QHULL
#include "bench/qhull.h"
#endif

namespace isect::bench::peers {

/// One library at all sizes: points(n) makes what run(it) is timed on.
template <class Make, class Run>
void grow_peer(Session& session, const char* test, const char* library, const char* method,
               const Make& points, const Run& run) {
  session.progress(std::string(test) + ", " + library);
  Grown grown(test, method, "set of points", library);
  for (const int n : sizes(session, 1000)) {
    const auto made = points(n);
    grown.add(n, least_time(session, [&] { return run(made); }));
  }
  grown.report(session);
}

#ifdef ISECT_HAS_CGAL
using HullKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline auto cgal_cloud(bool ball) {
  return [ball](int n) {
    std::vector<HullKernel::Point_3> points;
    for (const Point<double, 3>& p : cloud(n, ball)) points.emplace_back(p[0], p[1], p[2]);
    return points;
  };
}
inline auto cgal_disc(bool circle) {
  return [circle](int n) {
    std::vector<HullKernel::Point_2> points;
    for (const Point<double, 2>& p : disc(n, circle)) points.emplace_back(p[0], p[1]);
    return points;
  };
}
#endif

inline void hulls([[maybe_unused]] Session& session) {
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
  grow_peer(session, "hull 2D, disc", "CGAL", "convex_hull_2", cgal_disc(false), hull2);
  grow_peer(session, "hull 2D, circle", "CGAL", "convex_hull_2", cgal_disc(true), hull2);
  grow_peer(session, "hull 3D", "CGAL", "convex_hull_3", cgal_cloud(true), hull3);
  grow_peer(session, "hull 3D, sphere", "CGAL", "convex_hull_3", cgal_cloud(false), hull3);
#endif
#ifdef ISECT_HAS_QHULL
  for (const bool ball : {true, false})
    grow_peer(
        session, ball ? "hull 3D" : "hull 3D, sphere", "qhull", "qh_new_qhull",
        [&](int n) { return cloud(n, ball); }, [](const auto& points) { return qhull_vertices(points); });
#endif
}

inline void smallest_sphere([[maybe_unused]] Session& session) {
#ifdef ISECT_HAS_CGAL
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<HullKernel, double>;
  grow_peer(session, "smallest sphere", "CGAL", "Min_sphere_of_spheres_d, double", cgal_cloud(true),
            [](const auto& points) {
              CGAL::Min_sphere_of_spheres_d<Traits> ball(points.begin(), points.end());
              return ball.radius();
            });
#endif
}

}  // namespace isect::bench::peers
