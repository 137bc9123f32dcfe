#pragma once
// Smallest spheres by CGAL.

#include "bench/growth.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>

#include "bench/convex_hull/cgal_points.h"
#endif

namespace isect::bench::peers {

inline void smallest_sphere([[maybe_unused]] Session& session) {
#ifdef ISECT_HAS_CGAL
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<HullKernel, double>;
  grow(
      session, "smallest sphere", "Min_sphere_of_spheres_d, double", "set of points", cgal_cloud(true),
      [](const auto& points) {
        CGAL::Min_sphere_of_spheres_d<Traits> ball(points.begin(), points.end());
        return ball.radius();
      },
      "CGAL");
#endif
}

}  // namespace isect::bench::peers
