#pragma once
// Points that are hard to locate in an oriented box, and their true location, in rationals.

#include <utility>

#include "bench/random_obb.h"
#include "bench/rational.h"

namespace isect::tests::point_obb_pairs {

using oracle::Rational;

/// The location by the point's coordinates in the box's frame, by elimination with pivoting.
template <class S, int N>
Location oracle_locate(const Point<S, N>& point, const Obb<S, N>& box) {
  Rational m[N][N + 1];
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) m[i][j] = Rational(box.axes(i, j));
    m[i][N] = Rational(point[i]) - Rational(box.center[i]);
  }
  for (int column = 0; column < N; ++column) {
    int pivot = column;
    while (pivot < N && m[pivot][column] == 0) ++pivot;
    if (pivot == N) return Location::out;
    for (int j = 0; j <= N; ++j) std::swap(m[column][j], m[pivot][j]);
    for (int i = 0; i < N; ++i) {
      if (i == column) continue;
      const Rational factor = m[i][column] / m[column][column];
      for (int j = 0; j <= N; ++j) m[i][j] -= factor * m[column][j];
    }
  }
  Location location = Location::in;
  for (int i = 0; i < N; ++i) {
    const Rational s = abs(Rational(m[i][N] / m[i][i])), e = Rational(box.half[i]);
    if (s > e) return Location::out;
    if (s == e) location = Location::on;
  }
  return location;
}

/// A point on, near or away from the box, as near as S comes.
template <class S, int N>
Point<S, N> near(bench::Random& random, const Obb<S, N>& box, bench::Numbers numbers) {
  if (random.one_in(8)) return bench::vector<S, N>(random, numbers);
  Vector<S, N> s;
  for (int i = 0; i < N; ++i) {
    const S place[] = {S(-1), S(0), S(1), S(0.5), static_cast<S>(random.uniform(-1.25, 1.25))};
    s[i] = box.half[i] * place[random.below(5)];
  }
  Point<S, N> x = box.center + box.axes * s;
  const int axis = random.below(N);
  if (random.one_in(3)) x[axis] = bench::moved(x[axis], random.integer(-1, 1));
  return x;
}

}  // namespace isect::tests::point_obb_pairs
