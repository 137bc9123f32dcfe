#pragma once
// Convex hulls in rationals, by gift wrapping.

#include <algorithm>
#include <vector>

#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::oracle {

/// Twice the signed area of a b c.
template <class S>
Rational area2(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c) {
  const Coordinates<2> p = rational(a), q = rational(b), r = rational(c);
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// Strict vertices, counter-clockwise, from the lowest x, then y. One or two points where there is no area.
template <class S>
Ring<S, 2> hull(const std::vector<Point<S, 2>>& points) {
  Ring<S, 2> found;
  if (points.empty()) return found;
  const auto before = [](const Point<S, 2>& a, const Point<S, 2>& b) {
    return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
  };
  const auto distance2 = [](const Point<S, 2>& a, const Point<S, 2>& b) {
    const Rational x = Rational(a[0]) - Rational(b[0]), y = Rational(a[1]) - Rational(b[1]);
    return Rational(x * x + y * y);
  };
  Point<S, 2> at = *std::min_element(points.begin(), points.end(), before);
  do {
    found.push_back(at);
    Point<S, 2> next = at;  // the clockwise-most as seen from `at`, the farthest of several
    for (const Point<S, 2>& p : points) {
      if (p == at) continue;
      const int turn = next == at ? -1 : sign(area2(at, next, p));
      if (turn < 0 || (turn == 0 && distance2(at, p) > distance2(at, next))) next = p;
    }
    at = next;
  } while (at != found.front());
  return found;
}

}  // namespace isect::oracle
