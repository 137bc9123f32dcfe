#pragma once
// Clouds of points whose hulls and bounding volumes are hard to get.

#include <vector>

#include "bench/random_shapes.h"

namespace isect::tests::clouds {

using bench::Numbers;

enum class Cloud { family, line, near_line, circle, cluster };

/// Points that make hulls hard: on a line up to rounding, on a circle, many equal.
template <class S>
Ring<S, 2> cloud(bench::Random& random, Cloud kind, Numbers numbers, int n) {
  Ring<S, 2> r;
  const Point<S, 2> a = bench::vector<S, 2>(random, numbers), b = bench::vector<S, 2>(random, numbers);
  for (int i = 0; i < n; ++i) {
    const S t = static_cast<S>(random.integer(0, 16)) / 16;
    Point<S, 2> p = a * (S(1) - t) + b * t;  // within the range of both, however large they are
    if (kind == Cloud::near_line) p[random.below(2)] = bench::moved(p[random.below(2)], random.integer(-1, 1));
    if (kind == Cloud::circle) p = random.heading<2>().cast<S>();
    if (kind == Cloud::cluster)
      p = {bench::moved(a[0], random.integer(-2, 2)), bench::moved(a[1], random.integer(-2, 2))};
    if (kind == Cloud::family) p = bench::vector<S, 2>(random, numbers);
    if (i > 0 && random.one_in(6)) p = r[random.below(i)];
    r.push_back(p);
  }
  return r;
}

/// Clouds, and all that is degenerate: one point, duplicates, points on a line or in a plane.
template <class S, int N>
std::vector<Point<S, N>> cloud(bench::Random& random, bench::Numbers numbers) {
  std::vector<Point<S, N>> points(1 + random.below(12));
  for (Point<S, N>& p : points) p = bench::vector<S, N>(random, numbers);
  const int shape = random.below(6);
  const Vector<S, N> u = points[0] / 4, v = points.back() / 4;
  for (Point<S, N>& p : points) {
    if (shape == 0) p = points[0];
    if (shape == 1) p = u + static_cast<S>(random.uniform(-1, 1)) * v;
    if (shape == 2) p = static_cast<S>(random.uniform(-1, 1)) * u + static_cast<S>(random.uniform(-1, 1)) * v;
    if (shape == 3 && random.one_in(2)) p = points[0];
  }
  return points;
}

}  // namespace isect::tests::clouds
