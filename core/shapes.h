#pragma once
// Shapes are plain aggregates over a scalar S and a dimension N.

#include <Eigen/Core>
#include <limits>

#include "core/conventions.h"

namespace isect {

template <class S, int N>
using Vector = Eigen::Matrix<S, N, 1>;
template <class S, int N>
using Point = Eigen::Matrix<S, N, 1>;

/// The closed interval [lo, hi]; empty when lo > hi.
template <class S>
struct Interval {
  S lo, hi;

  bool contains(const S& x) const { return lo <= x && x <= hi; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// All t >= 0.
template <class S>
inline constexpr Interval<S> semi_infinite = {S(0), std::numeric_limits<S>::infinity()};
/// Every t.
template <class S>
inline constexpr Interval<S> infinite = {-std::numeric_limits<S>::infinity(),
                                         std::numeric_limits<S>::infinity()};

/// The points origin + t direction with t in the closed `range`: a ray by default, a segment when both ends
/// are finite, a line when neither is. The direction may have any length; t is measured in it. Source: the
/// note, N16.
template <class S, int N>
struct Ray {
  Point<S, N> origin;
  Vector<S, N> direction;
  Interval<S> range = semi_infinite<S>;

  Point<S, N> at(const S& t) const { return origin + t * direction; }
};

/// The segment from p to q, both included: t = 0 at p, t = 1 at q. The direction q - p is rounded.
template <class S, int N>
Ray<S, N> segment(const Point<S, N>& p, const Point<S, N>& q) {
  return {p, q - p, {S(0), S(1)}};
}

/// The closed ball around `center`; empty when radius < 0. Its surface is the sphere proper.
template <class S, int N>
struct Sphere {
  Point<S, N> center;
  S radius;
};

}  // namespace isect
