#pragma once
// All overlapping pairs by Embree, Bullet and FCL: those of bench/all_pairs/broad_phases.h.

#include "bench/all_pairs/broad_phases.h"

namespace isect::bench::peers {

template <class Race>
void all_pairs_growth([[maybe_unused]] Race& race) {
#ifdef ISECT_HAS_EMBREE
  RTCDevice device = rtcNewDevice("threads=1");
  race.add(
      "rtcCollide", 1'000'000, [&](const Boxes& boxes) { return embree(device, boxes); }, "Embree");
  rtcReleaseDevice(device);
#endif
#ifdef ISECT_HAS_BULLET
  race.add("btDbvt", 100'000, bullet, "Bullet");
#endif
#ifdef ISECT_HAS_FCL
  race.add("dynamic AABB tree, rounded boxes", 100'000, fcl_tree, "FCL");
#endif
}

}  // namespace isect::bench::peers
