#pragma once
// Rigid motions and scalings without rounding: axes permuted, mirrored, lengths times a power of two. No verdict may
// change under them. Lengths that overflow are the caller's care.

#include <array>
#include <cmath>
#include <utility>

#include <isect/shapes.h>
#include "bench/random.h"

namespace isect::tests {

template <int N>
struct Motion {
  std::array<int, N> axis;  ///< coordinate i of the image is that of axis[i]
  std::array<int, N> sign;
  int exponent;  ///< lengths times 2^exponent

  template <class S>
  S operator()(S length) const {
    return std::ldexp(length, exponent);
  }
  /// The image of a vector that is not scaled, such as a normal.
  template <class S>
  Vector<S, N> turned(const Vector<S, N>& x) const {
    Vector<S, N> y;
    for (int i = 0; i < N; ++i) y[i] = static_cast<S>(sign[i]) * x[axis[i]];
    return y;
  }
  template <class S>
  Point<S, N> operator()(const Point<S, N>& x) const {
    const Vector<S, N> y = turned(x);
    Point<S, N> scaled;
    for (int i = 0; i < N; ++i) scaled[i] = (*this)(y[i]);
    return scaled;
  }
  template <class S>
  Sphere<S, N> operator()(const Sphere<S, N>& x) const {
    return {(*this)(x.center), (*this)(x.radius)};
  }
  template <class S>
  Capsule<S, N> operator()(const Capsule<S, N>& x) const {
    return {(*this)(x.p), (*this)(x.q), (*this)(x.radius)};
  }
  template <class S>
  Cylinder<S> operator()(const Cylinder<S>& x) const {
    return {(*this)(x.p), (*this)(x.q), (*this)(x.radius)};
  }
  template <class S>
  Cone<S> operator()(const Cone<S>& x) const {
    return {(*this)(x.apex), (*this)(x.base), (*this)(x.radius)};
  }
  template <class S>
  Plane<S, N> operator()(const Plane<S, N>& x) const {
    return {turned(x.normal), (*this)(x.d)};
  }
  template <class S>
  Aabb<S, N> operator()(const Aabb<S, N>& x) const {
    Aabb<S, N> y = {(*this)(x.lo), (*this)(x.hi)};
    for (int i = 0; i < N; ++i)
      if (sign[i] < 0) std::swap(y.lo[i], y.hi[i]);
    return y;
  }
};

template <int N>
Motion<N> motion(bench::Random& random) {
  Motion<N> m;
  for (int i = 0; i < N; ++i) m.axis[i] = i, m.sign[i] = random.one_in(2) ? 1 : -1;
  for (int i = N - 1; i > 0; --i) std::swap(m.axis[i], m.axis[random.below(i + 1)]);
  m.exponent = random.integer(0, 40);  // upwards, as numbers next to 0 are subnormal
  return m;
}

}  // namespace isect::tests
