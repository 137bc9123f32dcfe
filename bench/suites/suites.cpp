#include "bench/suites/suites.h"

namespace isect::bench {

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"sphere-sphere", measure_sphere_sphere},
      {"ray-sphere", measure_ray_sphere},
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
