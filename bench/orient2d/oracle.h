#pragma once
// The true orientation of three points, in rationals.

#include <isect/shapes.h>
#include "bench/rational.h"

namespace isect::oracle {

/// +1 when a, b, c turn counter-clockwise, -1 clockwise, 0 on one line.
template <class S>
int orientation(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c) {
  const auto p = rational<S, 2>(a), u = rational<S, 2>(b) - p, v = rational<S, 2>(c) - p;
  return sign(u[0] * v[1] - u[1] * v[0]);
}

}  // namespace isect::oracle
