#pragma once
// Names that many tests of the core share.

#include <limits>

#include <isect/shapes.h>

namespace isect::tests {

inline constexpr double inf = std::numeric_limits<double>::infinity(),
                        not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The point or vector (x, y), in space (x, y, 0).
template <class S, int N>
Vector<S, N> at(double x, double y = 0) {
  Vector<S, N> v = Vector<S, N>::Zero();
  v[0] = static_cast<S>(x), v[1] = static_cast<S>(y);
  return v;
}

}  // namespace isect::tests
