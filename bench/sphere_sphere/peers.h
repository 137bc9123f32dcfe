#pragma once
// Balls by CGAL, whose own sphere is a surface: the squared distance of the centers is compared with (r + s)^2; and by
// FCL.

#ifdef ISECT_HAS_FCL
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_sphere.h>
#endif

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

template <class S, class Case>
void sphere_sphere(Contest<S, Case>& contest, const char* family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Balls {
      typename K::Point_3 a, b;
      typename K::FT r, s;
    };
    enter(
        contest, "CGAL", (std::string("compare_squared_distance, ") + kernel).c_str(),
        [](const Case& c) {
          return Balls{cgal<K>(c.a.center), cgal<K>(c.b.center), double(c.a.radius), double(c.b.radius)};
        },
        [](const Balls& c) {
          const typename K::FT sum = c.r + c.s;
          return CGAL::compare_squared_distance(c.a, c.b, sum * sum) != CGAL::LARGER;
        });
  });
#endif
#ifdef ISECT_HAS_FCL
  struct Fcl {
    fcl::Sphere<double> a, b;
    fcl::Transform3<double> at_a, at_b;
  };
  const auto at = [](const Point<S, 3>& p) {
    return fcl::Transform3<double>(Eigen::Translation<double, 3>(p.template cast<double>()));
  };
  enter(
      contest, "FCL", "sphereSphereIntersect",
      [at](const Case& c) {
        return Fcl{fcl::Sphere<double>(c.a.radius), fcl::Sphere<double>(c.b.radius), at(c.a.center), at(c.b.center)};
      },
      [](const Fcl& c) { return fcl::detail::sphereSphereIntersect<double>(c.a, c.at_a, c.b, c.at_b, nullptr); });
#endif
}

}  // namespace isect::bench::peers
