#pragma once
// Balls and capsules by FCL, whose capsule is a length along z in a frame, so that its ends are rounded.

#include <Eigen/Geometry>
#ifdef ISECT_HAS_FCL
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_capsule.h>
#endif

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

#ifdef ISECT_HAS_FCL
struct FclCapsule {
  fcl::Capsule<double> capsule;
  fcl::Transform3<double> frame;
};
template <class S>
FclCapsule fcl_capsule(const Capsule<S, 3>& c) {
  const Point<double, 3> p = c.p.template cast<double>(), q = c.q.template cast<double>();
  const Vector<double, 3> d = q - p;
  fcl::Transform3<double> frame(Eigen::Translation<double, 3>((p + q) / 2));
  if (d.squaredNorm() > 0) frame.rotate(Eigen::Quaterniond::FromTwoVectors(Vector<double, 3>::UnitZ(), d));
  return {fcl::Capsule<double>(c.radius, d.norm()), frame};
}
#endif

template <class S, class Case>
void sphere_capsule([[maybe_unused]] Contest<S, Case>& contest) {
#ifdef ISECT_HAS_FCL
  struct Fcl {
    fcl::Sphere<double> ball;
    fcl::Transform3<double> at;
    FclCapsule b;
  };
  enter(
      contest, "FCL", "sphereCapsuleIntersect",
      [](const Case& c) {
        const Point<double, 3> center = c.a.center.template cast<double>();
        return Fcl{fcl::Sphere<double>(c.a.radius), fcl::Transform3<double>(Eigen::Translation<double, 3>(center)),
                   fcl_capsule(c.b)};
      },
      [](const Fcl& c) {
        return fcl::detail::sphereCapsuleIntersect<double>(c.ball, c.at, c.b.capsule, c.b.frame, nullptr);
      });
#endif
}

}  // namespace isect::bench::peers
