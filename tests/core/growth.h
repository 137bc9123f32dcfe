#pragma once
// How a cost grows with the size of the input.

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/growth.h"

namespace isect::tests {

/// k, where the time of run(make(n)) grows like n^k from n to 8 n. An n lg n comes out as 1.1 or a little more, for
/// memory is slower than caches; an n^2 as 2. Processor time, the least of three: what else runs hardly counts.
template <class Make, class Run>
double growth(int n, const Make& make, const Run& run) {
  const auto least_time = [&](int size) {
    const auto input = make(size);
    double least = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < 3; ++pass) {
      const double start = bench::processor_time();
      run(input);
      least = std::min(least, bench::processor_time() - start);
    }
    return least;
  };
  const double first = least_time(n);
  return std::log2(least_time(8 * n) / first) / 3;
}

}  // namespace isect::tests
