#pragma once
// Random rays for tests that pair them with other shapes.

#include "bench/random_shapes.h"

namespace isect::bench {

/// Rays, segments, lines, ranges from -inf, ranges of one t, and now and then an empty one.
template <class S>
Interval<S> range(Random& random, Numbers numbers) {
  const S a = number<S>(random, numbers), b = number<S>(random, numbers);
  switch (random.below(9)) {
    case 0:
      return infinite<S>;
    case 1:
      return {S(0), S(1)};
    case 2:
      return {a, a};
    case 3:
      return {infinite<S>.lo, a};
    case 4:
      return {a, infinite<S>.hi};
    case 5:
      return {std::min(a, b), std::max(a, b)};
    case 6:
      return random.one_in(8) ? Interval<S>{S(1), S(0)} : Interval<S>{S(-1), S(1)};
    default:
      return semi_infinite<S>;
  }
}

/// A direction that is often parallel to axes, with zeros of either sign, and now and then zero.
template <class S, int N>
Vector<S, N> direction(Random& random, Numbers numbers) {
  Vector<S, N> d = vector<S, N>(random, numbers);
  if (random.one_in(2)) return d;
  for (int i = 0; i < N; ++i)
    if (random.one_in(2)) d[i] = random.one_in(2) ? S(0) : -S(0);
  return d;
}

/// A ray from anywhere, by its direction or through two points.
template <class S, int N>
Ray<S, N> ray(Random& random, Numbers numbers) {
  const Point<S, N> origin = vector<S, N>(random, numbers);
  if (random.one_in(2)) return {origin, direction<S, N>(random, numbers), range<S>(random, numbers)};
  Ray<S, N> through = line_through<S, N>(origin, vector<S, N>(random, numbers));
  if (!finite(through.direction)) through.direction = through.direction.unaryExpr([](S) { return S(1); });
  through.range = range<S>(random, numbers);
  return through;
}

}  // namespace isect::bench
