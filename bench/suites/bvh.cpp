// A hierarchy of boxes around a mesh of n triangles: what it costs to build, and the closest hit of a ray, beside brute
// force.

#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/suites/suites.h"
#include "core/bvh_ray.h"
#include "core/triangle_mesh.h"
#ifdef ISECT_PEERS
#include "bench/suites/bvh_peers.h"
#endif

namespace isect::bench {
namespace {

using Mesh = TriangleMesh<double>;

std::optional<double> brute_force(const Mesh& mesh, const Ray<double, 3>& ray) {
  std::optional<double> closest;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const std::optional<double> t = intersect(ray, triangle(mesh, i)).t;
    if (t && (!closest || *t < *closest)) closest = t;
  }
  return closest;
}

/// Half the side of a mesh with about n triangles.
int side_of(int n) { return static_cast<int>(std::lround(std::sqrt(n / 4.0))); }

}  // namespace

void measure_bvh(Session& session) {
  Grown build("bvh", "exact", "build"), closest("bvh", "exact", "query"),
      any("bvh", "exact, any hit", "any hit"), brute("bvh", "brute force", "query");
  const std::vector<Ray<double, 3>> rays = rays_inwards<double>(1 << 16),
                                    few(rays.begin(), rays.begin() + 64);
  for (const int n : sizes(session, 1000)) {
    session.progress("bvh, " + std::to_string(n));
    const Mesh mesh = bumpy_sphere<double>(side_of(n));
    const double size = static_cast<double>(mesh.triangles.size());
    const Bvh<double, 3> bvh = build_bvh(boxes(mesh));
    build.add(size, least_time(session, [&] { return build_bvh(boxes(mesh)); }));
    closest.add(size, least_each(session, rays,
                                 [&](const auto& r) { return closest_hit(bvh, mesh, r).has_value(); }));
    any.add(size, least_each(session, rays, [&](const auto& r) { return any_hit(bvh, mesh, r); }));
    if (n <= 10'000)
      brute.add(size,
                least_each(session, few, [&](const auto& r) { return brute_force(mesh, r).has_value(); }));
  }
  for (Grown* g : {&build, &closest, &any, &brute}) g->report(session);
#ifdef ISECT_PEERS
  peers::bvh(session, rays, side_of);
#endif
}

}  // namespace isect::bench
