#pragma once
// Rays and planes by CGAL, yes or no, and by Eigen with t. Except in EPECK CGAL's ray goes through origin + direction,
// rounded, and so another way than ours.

#include <Eigen/Geometry>

#include "bench/peer_shapes.h"
#include "bench/ray_plane/families.h"

namespace isect::bench::peers {

template <class S, class Case>
void ray_plane(Contest<S, Case>& contest, [[maybe_unused]] std::string_view family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Shapes {
      typename K::Ray_3 ray;
      typename K::Plane_3 plane;
    };
    enter(
        contest, "CGAL", (std::string("do_intersect, ") + kernel).c_str(),
        [](const Case& c) {
          const auto& n = c.plane.normal;
          return Shapes{cgal<K>(c.ray),
                        typename K::Plane_3(double(n[0]), double(n[1]), double(n[2]), double(c.plane.d))};
        },
        [](const Shapes& c) { return CGAL::do_intersect(c.ray, c.plane); });
  });
#endif
  struct Eigens {
    Eigen::ParametrizedLine<S, 3> line;
    Eigen::Hyperplane<S, 3> plane;
    Interval<S> range;
  };
  enter(
      contest, "Eigen", "ParametrizedLine::intersectionParameter",
      [](const Case& c) {
        return Eigens{{c.ray.origin, c.ray.direction}, {c.plane.normal, c.plane.d}, c.ray.range};
      },
      [](const Eigens& c) -> std::optional<S> {
        const S t = c.line.intersectionParameter(c.plane);
        return std::isfinite(t) && c.range.contains(t) ? std::optional<S>(t) : std::nullopt;
      });
}

}  // namespace isect::bench::peers
