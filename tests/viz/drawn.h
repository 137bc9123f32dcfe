#pragma once
// Helpers of tests that look at flat shapes.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

inline bool meet(const TextBox& a, const TextBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The shapes of one kind.
template <class T>
std::vector<T> all(const std::vector<Shape>& shapes) {
  std::vector<T> found;
  for (const Shape& s : shapes)
    if (const T* t = std::get_if<T>(&s)) found.push_back(*t);
  return found;
}

}  // namespace isect::viz
