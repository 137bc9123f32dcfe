#pragma once
// Where a point truly lies in a polygon, in rationals.

#include <algorithm>

#include <isect/conventions.h>
#include <isect/shapes.h>
#include "bench/rational.h"

namespace isect::oracle {

/// Where a point lies by the even-odd rule. The ray runs downwards, where the core's runs to the right: it meets an
/// edge that has its ends on both sides of the point's abscissa (a vertex below the point counts as on its left), at a
/// height found by division. Coordinates are compared as they are, which is exact.
template <class S>
Location location(const Point<S, 2>& p, const Ring<S, 2>& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const auto [left, right] = std::minmax(a[0], b[0]);
    if (right < p[0] || left > p[0]) continue;
    if (left == right) {
      const auto [low, high] = std::minmax(a[1], b[1]);
      if (low <= p[1] && p[1] <= high) return Location::on;
      continue;
    }
    const Rational x0 = a[0], y0 = a[1], across = Rational(b[0]) - x0, rise = Rational(b[1]) - y0;
    const Rational height = y0 + rise * (Rational(p[0]) - x0) / across;
    if (height == Rational(p[1])) return Location::on;
    if ((a[0] > p[0]) != (b[0] > p[0]) && height < Rational(p[1])) inside = !inside;
  }
  return inside ? Location::in : Location::out;
}

}  // namespace isect::oracle
