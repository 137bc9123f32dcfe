#pragma once
// Where a point lies with respect to a cylinder or a cone, in rationals: by the disc at its height.

#include "bench/round_oracle.h"

namespace isect::oracle {

template <class S, Round Solid>
Location locate(const Point<S, 3>& point, const Solid& solid) {
  return finite(point) ? round_solid(solid).locate(rational(point)) : Location::out;
}

}  // namespace isect::oracle
