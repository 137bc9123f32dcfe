#pragma once
// Oriented boxes by Bullet, in float, and by FCL; both widen by an epsilon of 1e-6.

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"
#ifdef ISECT_HAS_BULLET
#include <BulletCollision/Gimpact/btBoxCollision.h>
#endif
#ifdef ISECT_HAS_FCL
#include <fcl/math/bv/OBB.h>
#endif

namespace isect::bench::peers {

template <class S, class Case>
void obb_obb([[maybe_unused]] Contest<S, Case>& contest) {
  using Box = Obb<S, 3>;
#ifdef ISECT_HAS_BULLET
  struct Framed {
    btAABB box;
    btTransform frame;
  };
  const auto framed = [](const Box& b) {
    const auto& u = b.axes;
    const btMatrix3x3 turn(u(0, 0), u(0, 1), u(0, 2), u(1, 0), u(1, 1), u(1, 2), u(2, 0), u(2, 1), u(2, 2));
    btAABB box;
    box.m_max = bullet(b.half), box.m_min = -box.m_max;
    return Framed{box, btTransform(turn, bullet(b.center))};
  };
  enter_both(contest, "Bullet", "gimpact, overlapping_trans_cache (float)", framed,
             [](const Framed& a, const Framed& b) {
               BT_BOX_BOX_TRANSFORM_CACHE cache;
               cache.calc_from_homogenic(a.frame, b.frame);
               return a.box.overlapping_trans_cache(b.box, cache, true);
             });
#endif
#ifdef ISECT_HAS_FCL
  using Fcl = fcl::OBB<double>;
  enter_both(
      contest, "FCL", "OBB::overlap",
      [](const Box& b) {
        return Fcl(b.axes.template cast<double>(), b.center.template cast<double>(), b.half.template cast<double>());
      },
      [](const Fcl& a, const Fcl& b) { return a.overlap(b); });
#endif
}

}  // namespace isect::bench::peers
