// Hierarchies of boxes: building one, and the closest hit of a ray on a mesh, as the mesh grows; brute force beside
// it. As bvh_peer_speed also Embree, in float, with every answer compared.
//
// 65,536 distinct rays in random order from a sphere around the mesh, about three of four aimed at it.

#include <cstdlib>

#include "bench/brute_force.h"
#include "bench/growth_shapes.h"
#include "bench/measure.h"
#include "core/bvh_pairs.h"
#include "core/ray_mesh.h"
#include "core/triangle_mesh.h"
#ifdef ISECT_PEERS
#include "bench/embree.h"
#endif

using namespace isect;
using namespace isect::bench;

namespace {

/// The slope of log(time) against log(n) by least squares.
double exponent(const std::vector<double>& n, const std::vector<double>& time) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const double count = static_cast<double>(n.size());
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double a = std::log(n[i]), b = std::log(time[i]);
    x += a / count, y += b / count, xx += a * a / count, xy += a * b / count;
  }
  return (xy - x * y) / (xx - x * x);
}

/// Times of one method at all sizes.
struct Growth {
  std::vector<double> n, time;

  void add(double size, const Timing& t) { n.push_back(size), time.push_back(t.least); }
  void print(const char* what) const { std::printf("growth of %-30s n^%.2f\n", what, exponent(n, time)); }
};

template <class S>
void describe(const Bvh<S, 3>& bvh, const TriangleMesh<S>& mesh, const std::vector<Ray<S, 3>>& all) {
  const BvhStatistics s = statistics(bvh);
  bvh_ray::Counts counts;
  for (const Ray<S, 3>& ray : all) closest_hit(bvh, mesh, ray, counts);
  const double rays = static_cast<double>(all.size());
  std::printf(
      "  %d nodes, depth %d, leaves of %d to %d (mean %.2f), cost %.1f, %.1f bytes a primitive;"
      " a ray visits %.1f nodes, tests %.1f triangles\n",
      s.nodes, s.depth, s.least_leaf, s.largest_leaf, double(s.primitives) / s.leaves, s.cost,
      double(s.bytes) / s.primitives, double(counts.visited) / rays, double(counts.tested) / rays);
}

template <class S>
void all_sizes(int passes, int largest) {
  const char* scalar = sizeof(S) == 4 ? " float" : " double";
  Growth build, closest, any, brute, pairs;
  const std::vector<Ray<S, 3>> all = rays_inwards<S>(65536), few(all.begin(), all.begin() + 256);
  for (const int side : {16, 50, 158, 500}) {
    const std::vector<TriangleMesh<S>> one = {bumpy_sphere<S>(side)};
    const TriangleMesh<S>& mesh = one[0];
    const int n = static_cast<int>(mesh.triangles.size());
    if (n > largest) break;
    const std::vector<Aabb<S, 3>> around = boxes(mesh);
    const Bvh<S, 3> bvh = build_bvh(around);
    const std::string size = ", n = " + std::to_string(n) + scalar;

    Table building("build" + size);
    const Timing built =
        timed(one, n > 200'000 ? 3 : passes, [](const auto& m) { return build_bvh(boxes(m)).nodes.size(); });
    building.row("build_bvh (ns a mesh)", built);
    building.row("make_ray_mesh", timed(one, n > 200'000 ? 3 : passes,
                                        [](const auto& m) { return make_ray_mesh(m).nodes.size(); }));

    Table rays("closest hit" + size);
    const Timing hit =
        timed(all, passes, [&](const auto& ray) { return closest_hit(bvh, mesh, ray).has_value(); });
    rays.row("closest_hit", hit);
    const Timing some = timed(all, passes, [&](const auto& ray) { return any_hit(bvh, mesh, ray); });
    rays.row("any_hit", some);
    const RayMesh<S> prepared = make_ray_mesh(mesh);
    rays.row("closest_hit, ray_mesh",
             timed(all, passes, [&](const auto& ray) { return closest_hit(prepared, ray).has_value(); }));
    rays.row("any_hit, ray_mesh",
             timed(all, passes, [&](const auto& ray) { return any_hit(prepared, ray); }));
    if (n < 2000) {
      const Timing slow = timed(few, 3, [&](const auto& ray) { return brute_force(mesh, ray).has_value(); });
      rays.row("brute force (256 rays)", slow);
    }
#ifdef ISECT_PEERS
    embree::rows(building, rays, one, bvh, all, passes);
#endif
    const std::vector<Bvh<S, 3>> trees = {bvh};
    Table colliding("self collision" + size);
    const Timing self = timed(trees, 3, [&](const auto& tree) {
      long count = 0;
      report_pairs(tree, around, [&](int, int) { ++count; });
      return count;
    });
    colliding.row("report_pairs (ns a mesh)", self);
    describe(bvh, mesh, all);
    if (n < 2000) continue;
    build.add(n, built), closest.add(n, hit), any.add(n, some), pairs.add(n, self);
  }
  if (build.n.size() < 2) return;
  build.print("build"), closest.print("closest hit"), any.print("any hit"), pairs.print("self collision");
}

}  // namespace

/// bvh_speed [passes [largest mesh]], 5 and 1,000,000 by default.
int main(int argc, char** argv) {
  const int passes = argc > 1 ? std::atoi(argv[1]) : 5, largest = argc > 2 ? std::atoi(argv[2]) : 1'000'000;
  if (argc > 3 || passes < 1 || largest < 1) {
    std::fprintf(stderr, "usage: %s [passes [largest mesh]]\n", argv[0]);
    return 2;
  }
  Table::head(ISECT_FLAGS, "a bumpy sphere of n triangles; 65,536 rays, seed 1");
  all_sizes<double>(passes, largest);
  all_sizes<float>(passes, largest);
}
