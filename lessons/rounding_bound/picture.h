#pragma once
// What the steps draw: the points, numbers between their bounds, and which sizes a stage leaves open.

#include <cstddef>
#include <string>
#include <vector>

#include "lessons/rounding_bound/setup.h"

namespace isect::lessons::rounding_bound_lesson {

/// The three points, and the line through b and c.
viz::Scene points(const Setup&);

/// A computed number in the middle of what it may truly be.
struct Row {
  std::string name;  ///< markup
  double truth;      ///< where the truth lies: from the computed number, in units of its bound; NaN: unknown
  std::string told;  ///< markup, at the right end
};
/// The rows one below the other; `bound`: what their ends stand for.
viz::Scene bounds(const std::vector<Row>&, const std::string& bound);
/// The determinant between its bounds, taken times the factor; and 0, if it lies near.
viz::Scene decision(const Setup&, const Run&);

/// The first `count` stages: how large a determinant may be whose sign each of them leaves open.
viz::Scene ladder(const Run&, std::size_t count);

}  // namespace isect::lessons::rounding_bound_lesson
