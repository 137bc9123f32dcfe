#pragma once
// Triangle against axis-aligned box by the classical method, as it is taught and compared. `intersects` in
// isect/triangle_aabb.h is right for all input.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace triangle_aabb {

/// One axis, relative to the box's center: the triangle's interval against +-radius.
template <class S>
struct Compared {
  Vector<S, 3> l;
  Interval<S> triangle;
  S radius;
  bool separates;
};

/// Whether no axis separates, by the classical test, which moves the box's center to the origin. Naive: rounding may
/// decide, already in center and half-lengths. Source: Akenine-Moller (2001).
template <class S, class Trace = NoTrace>
bool akenine_moller(const Triangle<S, 3>& triangle, const Aabb<S, 3>& box, Trace&& trace = {}) {
  const auto size = [](const S& x) -> S { return x < S(0) ? -x : x; };
  const Vector<S, 3> center = (box.lo + box.hi) / S(2), half = (box.hi - box.lo) / S(2);
  std::array<Vector<S, 3>, 3> v;
  for (int k = 0; k < 3; ++k) v[k] = triangle.vertices[k] - center;

  const auto separates = [&](const Vector<S, 3>& l) {
    const S p[3] = {l.dot(v[0]), l.dot(v[1]), l.dot(v[2])};
    const S lo = std::min(std::min(p[0], p[1]), p[2]), hi = std::max(std::max(p[0], p[1]), p[2]);
    const S radius = half[0] * size(l[0]) + half[1] * size(l[1]) + half[2] * size(l[2]);
    const bool apart = lo > radius || -radius > hi;
    trace(Compared<S>{l, {lo, hi}, radius, apart});
    return apart;
  };

  const Eigen::Matrix<S, 3, 3> unit = Eigen::Matrix<S, 3, 3>::Identity();
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      if (separates(unit.col(i).cross(v[(j + 1) % 3] - v[j]))) return false;
  for (int i = 0; i < 3; ++i)
    if (separates(unit.col(i))) return false;
  return !separates((v[1] - v[0]).cross(v[2] - v[0]));
}

}  // namespace triangle_aabb

}  // namespace isect
