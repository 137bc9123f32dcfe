#pragma once
// Oriented box against oriented box by the classical method, as it is taught and compared. `intersects` in
// isect/obb_obb.h is right for all input.

#include <isect/parts/obb_obb_axes.h>

namespace isect {

namespace obb_obb {

/// One axis of the classical method, its rounded numbers.
template <class S>
struct Compared {
  Axis axis;
  S distance, radius_a, radius_b;
  bool separates;
};

/// Whether no axis separates, by the classical test for orthonormal axes. `epsilon` widens the radii against products
/// of parallel edges, which rounding leaves not quite 0; it is absolute in the r_ij, so that it fails slender boxes.
/// Naive: rounding and epsilon may decide. Source: Gottschalk, Lin, Manocha (1996); so in Ericson (2005), 4.4.1.
template <class S, class Trace = NoTrace>
bool gottschalk(const Obb<S, 3>& a, const Obb<S, 3>& b, const S& epsilon, Trace&& trace = {}) {
  const auto size = [](const S& x) -> S { return x < S(0) ? -x : x; };
  const Vector<S, 3> t = a.axes.transpose() * (b.center - a.center);  // in the frame of A, like all that follows
  const Eigen::Matrix<S, 3, 3> r = a.axes.transpose() * b.axes;
  Eigen::Matrix<S, 3, 3> q;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) q(i, j) = size(r(i, j)) + epsilon;
  const auto separates = [&](const Axis& axis, const S& distance, const S& radius_a, const S& radius_b) {
    const bool apart = distance > radius_a + radius_b;
    trace(Compared<S>{axis, distance, radius_a, radius_b, apart});
    return apart;
  };

  for (int i = 0; i < 3; ++i)
    if (separates({Kind::face_of_a, i}, size(t[i]), a.half[i], b.half.dot(q.row(i)))) return false;
  for (int j = 0; j < 3; ++j)
    if (separates({Kind::face_of_b, j}, size(t.dot(r.col(j))), a.half.dot(q.col(j)), b.half[j])) return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const S radius_a = a.half[i1] * q(i2, j) + a.half[i2] * q(i1, j);
      const S radius_b = b.half[j1] * q(i, j2) + b.half[j2] * q(i, j1);
      if (separates({Kind::edges, i, j}, size(t[i2] * r(i1, j) - t[i1] * r(i2, j)), radius_a, radius_b)) return false;
    }
  return true;
}

}  // namespace obb_obb

}  // namespace isect
