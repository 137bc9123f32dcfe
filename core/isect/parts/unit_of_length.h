#pragma once
// Shapes in another unit of length, a power of two: how they lie stays the same, but squares and products neither
// overflow nor vanish, and all arithmetic that is faster than big numbers serves. For the core's own use.

#include <algorithm>
#include <cmath>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>

namespace isect {

/// Lengths divided by 2^exponent; `exact` stays true as long as none of them loses a bit.
class UnitOfLength {
 public:
  explicit UnitOfLength(int the_exponent) : exponent_(the_exponent) {}

  double operator()(double x) {
    const double y = std::ldexp(x, -exponent_);
    exact_ &= std::ldexp(y, exponent_) == x;
    return y;
  }
  template <int N>
  Vector<double, N> operator()(const Vector<double, N>& x) {
    Vector<double, N> y;
    for (int i = 0; i < N; ++i) y[i] = (*this)(x[i]);
    return y;
  }
  template <int N>
  Sphere<double, N> operator()(const Sphere<double, N>& x) {
    return {(*this)(x.center), (*this)(x.radius)};
  }
  template <int N>
  Capsule<double, N> operator()(const Capsule<double, N>& x) {
    return {(*this)(x.p), (*this)(x.q), (*this)(x.radius)};
  }
  template <int N>
  Triangle<double, N> operator()(const Triangle<double, N>& x) {
    return {{(*this)(x.vertices[0]), (*this)(x.vertices[1]), (*this)(x.vertices[2])}};
  }
  template <int N>
  Aabb<double, N> operator()(const Aabb<double, N>& x) {
    return {(*this)(x.lo), (*this)(x.hi)};
  }
  /// The axes are numbers without a unit, and stay.
  template <int N>
  Obb<double, N> operator()(const Obb<double, N>& x) {
    return {(*this)(x.center), x.axes, (*this)(x.half)};
  }
  /// The direction changes its unit as the origin does, so that t stays what it was.
  template <int N>
  Ray<double, N> operator()(const Ray<double, N>& x) {
    return {(*this)(x.origin), (*this)(x.direction), x.range};
  }

  bool exact() const { return exact_; }

 private:
  int exponent_;
  bool exact_ = true;
};

// The largest length of a shape, without sign.

template <int N>
double largest_length(const Vector<double, N>& x) {
  double most = 0;
  for (int i = 0; i < N; ++i) most = std::max(most, std::abs(x[i]));
  return most;
}
template <int N>
double largest_length(const Sphere<double, N>& x) {
  return std::max(largest_length(x.center), x.radius);
}
template <int N>
double largest_length(const Capsule<double, N>& x) {
  return std::max({largest_length(x.p), largest_length(x.q), x.radius});
}
template <int N>
double largest_length(const Triangle<double, N>& x) {
  double most = 0;
  for (const Point<double, N>& v : x.vertices) most = std::max(most, largest_length(v));
  return most;
}
template <int N>
double largest_length(const Aabb<double, N>& x) {
  return std::max(largest_length(x.lo), largest_length(x.hi));
}
template <int N>
double largest_length(const Obb<double, N>& x) {
  return std::max(largest_length(x.center), largest_length(x.half));
}
template <int N>
double largest_length(const Ray<double, N>& x) {
  return largest_length(x.origin);
}

/// answer(a, b); shapes that are very large or very small are first given a unit in which they are neither, unless that
/// would lose a bit.
template <class A, class B, class Answer>
auto in_own_unit(const A& a, const B& b, const Answer& answer) {
  const double size = std::max(largest_length(a), largest_length(b));
  if (size > 0 && !(0x1p-100 < size && size < 0x1p100)) {
    UnitOfLength unit(std::ilogb(size));
    const A own_a = unit(a);
    const B own_b = unit(b);
    if (unit.exact()) return answer(own_a, own_b);
  }
  return answer(a, b);
}

/// Calls in_own_unit, unless the algorithm runs in doubles first or is listened to: then shapes stay as they are.
template <class Trace, class A, class B, class Answer>
auto settled_in_own_unit(const A& a, const B& b, const Answer& answer) {
  if constexpr (doubles_only<Trace> || heard<Trace>)
    return answer(a, b);
  else
    return in_own_unit(a, b, answer);
}

}  // namespace isect
