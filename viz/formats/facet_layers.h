#pragma once
// The painting order of facets as far as it is visible, for pictures of paths: facets of one layer may be drawn in any
// order, so that those of one colour are one path.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Returns the layer of each facet, from 0 at the bottom: it is above that of every earlier facet that it partly
/// covers. Facets of a closed mesh seen from outside have few layers. Above `most_layered` facets each has its own.
/// Time O(n^2), some 0.1 ms for 450.
std::vector<int> layers(const Facets&);

constexpr std::size_t most_layered = 1000;

}  // namespace isect::viz
