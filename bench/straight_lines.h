#pragma once
// Rays and segments as most code keeps them, and as oracles do.

#include <limits>

#include "bench/rational.h"

namespace isect::bench {

/// p + t d with t from 0 to `most`, d rounded.
template <int N>
struct Line {
  Point<double, N> p;
  Vector<double, N> d;
  double most;
};
template <int N>
Line<N> line(const Ray<double, N>& ray) {
  return {ray.origin, ray.direction, std::numeric_limits<double>::infinity()};
}
template <int N>
Line<N> line(const Segment<double, N>& s) {
  return {s.p, s.q - s.p, 1};
}

/// p + t d with t in the range; a segment's d is exact.
template <int N>
struct TrueLine {
  oracle::Coordinates<N> p, d;
  Interval<double> range;
};
template <int N>
TrueLine<N> true_line(const Ray<double, N>& ray) {
  return {oracle::rational(ray.origin), oracle::rational(ray.direction), ray.range};
}
template <int N>
TrueLine<N> true_line(const Segment<double, N>& s) {
  using oracle::operator-;
  return {oracle::rational(s.p), oracle::rational(s.q) - oracle::rational(s.p), {0, 1}};
}

}  // namespace isect::bench
