#pragma once
// Planes in space for outlines of whole numbers.

#include <isect/shapes.h>

namespace isect::test {

/// A point of one of three planes, in which whole numbers stay whole: any two of these axes.
inline Vector<double, 3> in_space(const Point<double, 2>& p, int pose) {
  using Vec3 = Vector<double, 3>;
  const Vec3 u = pose == 0 ? Vec3(1, 0, 0) : pose == 1 ? Vec3(0, 2, 1) : Vec3(3, -1, 2);
  const Vec3 v = pose == 0 ? Vec3(0, 1, 0) : pose == 1 ? Vec3(1, 0, 0) : Vec3(1, 4, -2);
  return p.x() * u + p.y() * v + Vec3(5, -7, 1);
}

}  // namespace isect::test
