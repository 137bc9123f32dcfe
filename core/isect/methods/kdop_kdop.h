#pragma once
// k-DOPs as they are usually made: normals divided by their lengths, products rounded to the nearest. For lessons and
// comparison; isect/fit.h makes k-DOPs that contain their points.

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect::kdop_kdop {

/// n.p of one point, as rounded, and the slab so far.
template <class S>
struct Projected {
  int slab, point;
  S value;
  Interval<S> so_far;
};
template <class S>
using FitEvent = std::variant<Projected<S>>;

/// Divides each normal by its length, which rounds: (1, 1, 0) becomes one of no exact length and no exact products.
template <class S, int N>
std::vector<Vector<S, N>> unit_normals(std::vector<Vector<S, N>> normals) {
  for (Vector<S, N>& n : normals) n = n / std::sqrt(n.dot(n));
  return normals;
}

/// Makes slabs from the least to the largest n.p over the points, as rounded. Naive: a slab may lack some of its points
/// by rounding, and those of objects that touch may come apart, unless all products and sums are exact, as for small
/// integers. Source: the note, N08.
template <class S, int N, class Trace = NoTrace>
Kdop<S, N> rounded_kdop(const std::vector<Point<S, N>>& points, const std::vector<Vector<S, N>>& normals,
                        Trace&& trace = {}) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  Kdop<S, N> kdop = {normals, std::vector<Interval<S>>(normals.size(), {infinity, -infinity})};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    Interval<S>& slab = kdop.slabs[i];
    for (std::size_t j = 0; j < points.size(); ++j) {
      const S value = normals[i].dot(points[j]);
      slab = {std::min(slab.lo, value), std::max(slab.hi, value)};
      if constexpr (heard<Trace>) trace(Projected<S>{static_cast<int>(i), static_cast<int>(j), value, slab});
    }
  }
  return kdop;
}

}  // namespace isect::kdop_kdop
