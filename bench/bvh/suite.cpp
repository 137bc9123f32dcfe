// A hierarchy of boxes around a mesh of n triangles: what it costs to build, and the closest hit of a ray, beside brute
// force.

#include <isect/many/bvh_ray.h>
#include <isect/many/ray_mesh.h>
#include <isect/triangle_mesh.h>
#include "bench/brute_force.h"
#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/bvh/peers.h"
#endif

namespace isect::bench::bvh_suite {
namespace {

using Mesh = TriangleMesh<double>;

/// Half the side of a mesh with about n triangles.
int side_of(int n) { return static_cast<int>(std::lround(std::sqrt(n / 4.0))); }

/// Building, the closest hit and any hit of one kind of hierarchy.
struct Curves {
  Grown build, closest, any;
  explicit Curves(const std::string& method)
      : build("bvh", method, "build"), closest("bvh", method, "query"), any("bvh", method, "any hit") {}

  template <class Rays, class Make, class Closest, class Any>
  void add(const Session& session, double size, const Rays& rays, const Make& make, const Closest& closest_of,
           const Any& any_of) {
    build.add(size, least_time(session, make));
    closest.add(size, least_each(session, rays, [&](const auto& ray) { return closest_of(ray).has_value(); }));
    any.add(size, least_each(session, rays, any_of));
  }

  void report(Session& session) {
    for (Grown* g : {&build, &closest, &any}) g->report(session);
  }
};

/// Measures the prepared mesh, the form meant for many rays.
template <class S>
void grow_prepared(Session& session, const std::string& method) {
  Curves curves(method);
  const std::vector<Ray<S, 3>> rays = rays_inwards<S>(1 << 16);
  for (const int n : sizes(session, 1000)) {
    session.progress("bvh, " + method + ", " + std::to_string(n));
    const TriangleMesh<S> mesh = bumpy_sphere<S>(side_of(n));
    const double size = static_cast<double>(mesh.triangles.size());
    const RayMesh<S> prepared = make_ray_mesh(mesh);
    curves.add(
        session, size, rays, [&] { return make_ray_mesh(mesh); },
        [&](const auto& ray) { return closest_hit(prepared, ray); },
        [&](const auto& ray) { return any_hit(prepared, ray); });
  }
  curves.report(session);
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "building a hierarchy of 10^6 triangles",
       .kind = Target::growth,
       .test = "bvh",
       .theirs = "Embree",
       .n = 1e6,
       .unit = "build",
       .at_most = 1.2,
       .limit = "Boxes of doubles are binned, as any x86-64 can; Embree bins boxes of floats by AVX. Four fifths of it "
                "are bins and splits."});
  session.aim(
      {.work = "closest hit among 10^6 triangles",
       .kind = Target::growth,
       .test = "bvh",
       .theirs = "Embree",
       .n = 1e6,
       .unit = "query",
       .at_most = 1.5,
       .limit = "Embree asks eight boxes at a time and triangles of floats, by AVX, and errs at edges. Here it is four "
                "boxes, as any x86-64 can, and triangles of doubles, 72 bytes each, settled by exact signs."});
  session.aim({.work = "closest hit among 10^6 triangles, float",
               .kind = Target::growth,
               .test = "bvh",
               .ours = "exact, float",
               .theirs = "Embree",
               .n = 1e6,
               .unit = "query",
               .at_most = 1,
               .limit = "Embree asks eight boxes at a time, by AVX, and errs at edges. Here it is four boxes, as any "
                        "x86-64 can, and triangles are settled by exact signs."});
  grow_prepared<double>(session, "exact");
  grow_prepared<float>(session, "exact, float");
  Curves plain("hierarchy");
  Grown brute("bvh", "brute force", "query");
  const std::vector<Ray<double, 3>> rays = rays_inwards<double>(1 << 16), few(rays.begin(), rays.begin() + 64);
  for (const int n : sizes(session, 1000)) {
    session.progress("bvh, " + std::to_string(n));
    const Mesh mesh = bumpy_sphere<double>(side_of(n));
    const double size = static_cast<double>(mesh.triangles.size());

    const Bvh<double, 3> bvh = build_bvh(boxes(mesh));
    plain.add(
        session, size, rays, [&] { return build_bvh(boxes(mesh)); },
        [&](const auto& ray) { return closest_hit(bvh, mesh, ray); },
        [&](const auto& ray) { return any_hit(bvh, mesh, ray); });

    if (n <= 10'000)
      brute.add(size, least_each(session, few, [&](const auto& r) { return brute_force(mesh, r).has_value(); }));
  }
  plain.report(session), brute.report(session);
#ifdef ISECT_PEERS
  peers::bvh(session, rays, side_of);
#endif
}

}  // namespace isect::bench::bvh_suite
