#pragma once
// Balls and boxes by CGAL, whose sphere is a surface (so a corner inside it counts, too), by Eigen and by FCL.

#include <Eigen/Geometry>
#ifdef ISECT_HAS_FCL
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_box.h>
#endif

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

template <class S, class Case>
void sphere_aabb(Contest<S, Case>& contest, std::string_view family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Shapes {
      typename K::Sphere_3 ball;
      typename K::Iso_cuboid_3 box;
    };
    enter(
        contest, "CGAL", (std::string("do_intersect, ") + kernel).c_str(),
        [](const Case& c) {
          return Shapes{cgal<K>(c.a), cgal<K>(c.b)};
        },
        [](const Shapes& c) { return CGAL::do_intersect(c.ball, c.box) || c.ball.has_on_bounded_side((c.box.min)()); });
  });
#endif
  struct Boxed {
    Eigen::AlignedBox<S, 3> box;
    Sphere<S, 3> ball;
  };
  enter(
      contest, "Eigen", "AlignedBox::squaredExteriorDistance",
      [](const Case& c) {
        return Boxed{{c.b.lo, c.b.hi}, c.a};
      },
      [](const Boxed& c) { return c.box.squaredExteriorDistance(c.ball.center) <= c.ball.radius * c.ball.radius; });
#ifdef ISECT_HAS_FCL
  struct Fcl {
    fcl::Sphere<double> ball;
    fcl::Box<double> box;
    fcl::Transform3<double> at_ball, at_box;
  };
  const auto at = [](const Point<double, 3>& p) { return fcl::Transform3<double>(Eigen::Translation<double, 3>(p)); };
  enter(
      contest, "FCL", "sphereBoxIntersect",
      [at](const Case& c) {
        const Point<double, 3> lo = c.b.lo.template cast<double>(), hi = c.b.hi.template cast<double>();
        return Fcl{fcl::Sphere<double>(c.a.radius), fcl::Box<double>(Point<double, 3>(hi - lo)),
                   at(c.a.center.template cast<double>()), at((lo + hi) / 2)};
      },
      [](const Fcl& c) {
        return fcl::detail::sphereBoxIntersect<double>(c.ball, c.at_ball, c.box, c.at_box, nullptr);
      });
#endif
}

}  // namespace isect::bench::peers
