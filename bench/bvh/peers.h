#pragma once
// Embree's scene of a mesh, in float and with as many lanes as the machine has.

#include "bench/growth_shapes.h"
#ifdef ISECT_HAS_EMBREE
#include "bench/bvh/embree.h"
#endif

namespace isect::bench::peers {

template <class SideOf>
void bvh([[maybe_unused]] Session& session, [[maybe_unused]] const std::vector<Ray<double, 3>>& rays,
         [[maybe_unused]] const SideOf& side_of) {
#ifdef ISECT_HAS_EMBREE
  Grown build("bvh", "rtcCommitScene", "build", "Embree"), closest("bvh", "rtcIntersect1", "query", "Embree"),
      any("bvh", "rtcOccluded1", "any hit", "Embree");
  for (const int n : sizes(session, 1000)) {
    session.progress("bvh, Embree, " + std::to_string(n));
    const TriangleMesh<double> mesh = bumpy_sphere<double>(side_of(n));
    const double size = static_cast<double>(mesh.triangles.size());
    build.add(size, least_time(session, [&] {
                const embree::Scene scene(mesh);
                return 1;
              }));
    const embree::Scene scene(mesh);
    closest.add(size,
                least_each(session, rays, [&](const auto& r) { return std::isfinite(scene.closest(r).ray.tfar); }));
    any.add(size, least_each(session, rays, [&](const auto& r) { return scene.any(r); }));
  }
  for (Grown* g : {&build, &closest, &any}) g->report(session);
#endif
}

}  // namespace isect::bench::peers
