#include "bench/suites/suites.h"

namespace isect::bench {

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"ray-sphere", measure_ray_sphere},
      {"orient2d", measure_orient},
  };
  return all;
}

}  // namespace isect::bench
