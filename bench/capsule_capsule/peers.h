#pragma once
// Capsules by FCL, which follows Ericson, and computes the distance of their surfaces.

#ifdef ISECT_HAS_FCL
#include <fcl/narrowphase/detail/primitive_shape_algorithm/capsule_capsule.h>
#endif

#include "bench/sphere_capsule/peers.h"

namespace isect::bench::peers {

template <class S, class Case>
void capsule_capsule([[maybe_unused]] Contest<S, Case>& contest) {
#ifdef ISECT_HAS_FCL
  enter_both(
      contest, "FCL", "capsuleCapsuleDistance", [](const Capsule<S, 3>& c) { return fcl_capsule(c); },
      [](const FclCapsule& a, const FclCapsule& b) {
        double distance = 0;
        fcl::Vector3<double> on_a, on_b;
        fcl::detail::capsuleCapsuleDistance<double>(a.capsule, a.frame, b.capsule, b.frame, &distance, &on_a, &on_b);
        return distance <= 0;
      });
#endif
}

}  // namespace isect::bench::peers
