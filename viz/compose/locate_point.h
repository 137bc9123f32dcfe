#pragma once
// Whether a box of a drawing holds a point, its boundary included, and where a point lies in a triangle.

#include <isect/conventions.h>
#include "viz/drawing.h"

namespace isect::viz {

inline bool contains(const TextBox& b, const Vec2& p) {
  return b.left <= p.x() && p.x() <= b.right && b.top <= p.y() && p.y() <= b.bottom;
}

/// Returns where p lies in the triangle a b c, however it turns, rounded: for pictures. Without area it holds nothing.
inline Location locate(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const auto side = [&](const Vec2& from, const Vec2& to) {
    return (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
  };
  const double u = side(a, b), v = side(b, c), w = side(c, a);
  if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) return Location::in;
  return (u >= 0 && v >= 0 && w >= 0) != (u <= 0 && v <= 0 && w <= 0) ? Location::on : Location::out;
}

}  // namespace isect::viz
