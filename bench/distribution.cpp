#include "bench/distribution.h"

#include <algorithm>
#include <cmath>
#include <random>
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

Range median_interval(const std::vector<double>& values) {
  constexpr int resamples = 400;
  std::mt19937_64 random(1);  // the standard fixes its numbers
  std::vector<double> medians;
  for (int k = 0; k < resamples; ++k) {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < values.size(); ++i) drawn.push_back(values[random() % values.size()]);
    medians.push_back(Distribution(std::move(drawn)).quantile(0.5));
  }
  const Distribution all(std::move(medians));
  return {all.quantile(0.025), all.quantile(0.975)};
}

}  // namespace isect::bench
