#pragma once
// Boxes by Eigen, CGAL, Bullet and FCL: all compare ends, Bullet in float.

#include <Eigen/Geometry>

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Bbox_3.h>
#endif
#ifdef ISECT_HAS_BULLET
#include <LinearMath/btAabbUtil2.h>
#endif
#ifdef ISECT_HAS_FCL
#include <fcl/math/bv/AABB.h>
#endif

namespace isect::bench::peers {

template <class S, class Case>
void eigen_aabb_aabb(Contest<S, Case>& contest) {
  using Box = Eigen::AlignedBox<S, 3>;
  enter_both(
      contest, "Eigen", "AlignedBox::intersects", [](const Aabb<S, 3>& b) { return Box(b.lo, b.hi); },
      [](const Box& a, const Box& b) { return a.intersects(b); });
}

template <class S, class Case>
void aabb_aabb(Contest<S, Case>& contest) {
  using Box = Aabb<S, 3>;
  eigen_aabb_aabb(contest);
#ifdef ISECT_HAS_CGAL
  enter_both(
      contest, "CGAL", "Bbox_3, do_overlap",
      [](const Box& b) { return CGAL::Bbox_3(b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]); },
      [](const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) { return CGAL::do_overlap(a, b); });
#endif
#ifdef ISECT_HAS_BULLET
  struct Bullet {
    btVector3 lo, hi;
  };
  enter_both(
      contest, "Bullet", "TestAabbAgainstAabb2 (float)",
      [](const Box& b) {
        return Bullet{bullet(b.lo), bullet(b.hi)};
      },
      [](const Bullet& a, const Bullet& b) { return TestAabbAgainstAabb2(a.lo, a.hi, b.lo, b.hi); });
#endif
#ifdef ISECT_HAS_FCL
  using Fcl = fcl::AABB<double>;
  enter_both(
      contest, "FCL", "AABB::overlap",
      [](const Box& b) {
        Fcl box;  // its constructor of two points sorts them
        box.min_ = b.lo.template cast<double>(), box.max_ = b.hi.template cast<double>();
        return box;
      },
      [](const Fcl& a, const Fcl& b) { return a.overlap(b); });
#endif
}

}  // namespace isect::bench::peers
