#pragma once
// How a list of numbers is distributed.

#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// Of an unsorted list: its median, 99th percentile and greatest; quantiles by the nearest rank.
struct Distribution {
  explicit Distribution(std::vector<double> values);
  double quantile(double share) const;
  Errors errors() const { return {quantile(0.5), quantile(0.99), quantile(1)}; }
  std::vector<double> curve() const;  ///< 41 quantiles, every 2.5 %
  std::vector<double> sorted;
};

}  // namespace isect::bench
