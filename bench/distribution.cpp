#include "bench/distribution.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isect::bench {

Distribution::Distribution(std::vector<double> values) : sorted(std::move(values)) {
  std::sort(sorted.begin(), sorted.end());
}

double Distribution::quantile(double share) const {
  if (sorted.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  return sorted[static_cast<std::size_t>(std::clamp(rank, 0.0, static_cast<double>(sorted.size() - 1)))];
}

std::vector<double> Distribution::curve() const {
  std::vector<double> points;
  for (int i = 0; i <= 40; ++i) points.push_back(quantile(i / 40.0));
  return points;
}

}  // namespace isect::bench
