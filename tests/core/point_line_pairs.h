#pragma once
// Points and rays that are hard to tell apart, of any numbers, and the truth in rationals: by the foot of the point on
// the line, which is found by a division.

#include "bench/random_rays.h"
#include "bench/rational.h"

#include <isect/point_line.h>

namespace isect::tests::point_line_pairs {

using bench::Numbers, bench::Random;

template <class S, int N>
struct Case {
  Point<S, N> point;
  Ray<S, N> ray;
};

/// A point anywhere, or a few steps along the ray, up to rounding.
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  Case<S, N> c = {bench::vector<S, N>(random, numbers), bench::ray<S, N>(random, numbers)};
  if (random.one_in(2)) {
    const S t = static_cast<S>(random.integer(-8, 8)) / 4;
    c.point = c.ray.origin + t * c.ray.direction;
    if (random.one_in(2)) c.ray.range = {std::min(t, S(0)), random.one_in(2) ? t : S(1)};
    if (random.one_in(4)) c.point[0] = bench::moved(c.point[0], random.integer(-1, 1));
  }
  return c;
}

template <class S, int N>
Beside truth(const Point<S, N>& point, const Point<S, N>& origin, const oracle::Coordinates<N>& d,
             const Interval<double>& range) {
  using oracle::operator-, oracle::operator+, oracle::operator*;
  using oracle::Rational;
  const auto x = oracle::rational(point), o = oracle::rational(origin);
  const Rational dd = oracle::dot(d, d);
  if (dd == 0)
    return x == o && oracle::holds(range, std::isfinite(range.lo) ? range.lo : std::min(0.0, range.hi)) ? Beside::on
                                                                                                        : Beside::aside;
  const Rational t = oracle::dot(x - o, d) / dd;
  const auto off = x - (o + t * d);
  if (oracle::dot(off, off) != 0) {
    if constexpr (N == 2) return d[0] * off[1] > d[1] * off[0] ? Beside::left : Beside::right;
    return Beside::aside;
  }
  if (range.lo == infinite<double>.hi || (std::isfinite(range.lo) && t < Rational(range.lo))) return Beside::before;
  if (range.hi == infinite<double>.lo || (std::isfinite(range.hi) && t > Rational(range.hi))) return Beside::beyond;
  return Beside::on;
}

}  // namespace isect::tests::point_line_pairs
