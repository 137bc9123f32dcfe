#pragma once
// Points on and beside the edges of random polygons, and how often each method is wrong about them. Nothing is timed:
// the numbers are the same on every machine.
//
// Source of the experiment: S. Schirra, How reliable are practical point-in-polygon strategies? (ESA 2008), whose
// queries lie near and on edges, and who counts false positives and false negatives apart.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <isect/shapes.h>

namespace isect::bench::near_edges {

/// The rows: on an edge, then so many doubles to its left and right, at one height.
inline constexpr std::array<int, 7> steps = {0, 1, 2, 4, 8, 16, 32};

/// A point of one of the rows. Whether it is inside is known from the edge beside it, by the exact sign of a
/// determinant. A point on an edge counts as in the half-open rule of the naive methods: inside on a left edge, outside
/// on a right one.
struct Query {
  int row;
  const Ring<double, 2>& ring;
  Point<double, 2> point;
  bool inside;
};
/// Calls visit(query) for all of them, always the same.
void each_query(const std::function<void(const Query&)>& visit);

/// Points of one side, and how many of them a method takes for those of the other.
struct Count {
  int points = 0, wrong = 0;
  double percent() const { return points > 0 ? 100.0 * wrong / points : 0; }
};
struct Row {
  Count outside, inside;  ///< the wrong ones: false positives, false negatives
};
struct Method {
  std::string name;
  std::array<Row, steps.size()> rows;
};
/// Each method over all queries: the naive ones, and last the exact call, which is right on an edge if it says so.
const std::vector<Method>& methods();

}  // namespace isect::bench::near_edges
