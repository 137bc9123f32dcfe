#pragma once
// What a half-space leaves of a ring, in rationals: edge by edge, by heights and parameters.

#include <vector>

#include "bench/clip_segment/oracle.h"

namespace isect::oracle {

template <class S, int N>
std::vector<Coordinates<N>> clipped(const Ring<S, N>& ring, const Plane<S, N>& plane) {
  std::vector<Coordinates<N>> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto x = rational<S, N>(ring[i]), y = rational<S, N>(ring[(i + 1) % ring.size()]);
    const Rational from = height<S, N>(plane, x), to = height<S, N>(plane, y);
    if (from >= 0) kept.push_back(x);
    if (from != 0 && to != 0 && (from > 0) != (to > 0)) kept.push_back(x + Rational(from / (from - to)) * (y - x));
  }
  return kept;
}

}  // namespace isect::oracle
