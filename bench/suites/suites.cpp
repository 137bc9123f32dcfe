#include "bench/suites/suites.h"

namespace isect::bench {

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"point-point", measure_point_point},
      {"interval-interval", measure_interval_interval},
      {"aabb-aabb", measure_aabb_aabb},
      {"sphere-sphere", measure_sphere_sphere},
      {"sphere-aabb", measure_sphere_aabb},
      {"obb-obb", measure_obb_obb},
      {"kdop-kdop", measure_kdop_kdop},
      {"ray-sphere", measure_ray_sphere},
      {"ray-aabb", measure_ray_aabb},
      {"ray-plane", measure_ray_plane},
      {"ray-triangle", measure_ray_triangle},
      {"ray-polygon", measure_ray_polygon},
      {"orient2d", measure_orient},
      {"point-polygon", measure_point_polygon},
      {"convex-polygon", measure_convex_polygon},
      {"point-location", measure_point_location},
      {"all-pairs", measure_all_pairs},
      {"bvh", measure_bvh},
      {"hulls", measure_hulls},
      {"smallest-sphere", measure_smallest_sphere},
  };
  return all;
}

}  // namespace isect::bench
