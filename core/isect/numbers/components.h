#pragma once
// Vectors of any arithmetic, in as many components as the shape has.

#include <array>
#include <cstddef>

#include <isect/numbers/bounded.h>
#include <isect/shapes.h>

namespace isect {

template <class W, int N>
using Components = std::array<W, N>;

/// x - y, component by component.
template <PolynomialScalar W, int N>
ISECT_INLINE Components<W, N> difference(const Point<double, N>& x, const Point<double, N>& y) {
  Components<W, N> v;
  for (int i = 0; i < N; ++i) v[i] = difference<W>(x[i], y[i]);
  return v;
}

/// x itself in W.
template <PolynomialScalar W, int N>
ISECT_INLINE Components<W, N> exactly(const Vector<double, N>& x) {
  Components<W, N> v;
  for (int i = 0; i < N; ++i) v[i] = W(x[i]);
  return v;
}

template <PolynomialScalar W, std::size_t N>
ISECT_INLINE W dot(const std::array<W, N>& x, const std::array<W, N>& y) {
  W sum = x[0] * y[0];
  for (std::size_t i = 1; i < N; ++i) sum = sum + x[i] * y[i];
  return sum;
}

/// A vector of doubles in W, one of W as it is.
template <PolynomialScalar W, int N>
ISECT_INLINE Components<W, N> in(const Vector<double, N>& x) {
  return exactly<W>(x);
}
template <PolynomialScalar W, int N>
ISECT_INLINE const Components<W, N>& in(const Components<W, N>& x) {
  return x;
}

template <PolynomialScalar W>
ISECT_INLINE std::array<W, 3> cross(const std::array<W, 3>& x, const std::array<W, 3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

}  // namespace isect
