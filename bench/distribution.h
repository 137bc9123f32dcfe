#pragma once
// How a list of numbers is distributed.

#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// The median, 99th percentile and maximum of an unsorted list; quantiles are by the nearest rank.
struct Distribution {
  explicit Distribution(std::vector<double> values);
  double quantile(double share) const;
  Errors errors() const { return {quantile(0.5), quantile(0.99), quantile(1)}; }
  std::vector<double> curve() const;  ///< 41 quantiles, every 2.5 %
  std::vector<double> sorted;
};

struct Range {
  double lo, hi;
};

/// A 95 % confidence interval of the median, by the bootstrap: the middle 95 % of the medians of 400 samples drawn from
/// the values with replacement. The same values in the same order give the same interval; no values give [0, 0]. It
/// doesn't show what all values have in common, such as where the compiler put a loop.
/// Source: Efron, Tibshirani, An introduction to the bootstrap, 1993, ch. 13.
Range median_interval(const std::vector<double>& values);

}  // namespace isect::bench
