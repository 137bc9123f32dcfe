#pragma once
// Random oriented boxes: proper rotations as they come out of rounding, axes that touch and align, and skew ones.

#include <Eigen/Geometry>

#include "bench/random_shapes.h"

namespace isect::bench {

/// A rotation by an angle of [0, most], rounded to S.
template <class S, int N>
Eigen::Matrix<S, N, N> rotation(Random& random, double most) {
  const double angle = random.uniform(-most, most);
  if constexpr (N == 2) {
    return Eigen::Rotation2D<double>(angle).toRotationMatrix().template cast<S>();
  } else {
    const Vector<double, 3> axis = random.heading<3>();
    return Eigen::AngleAxis<double>(angle, axis).toRotationMatrix().template cast<S>();
  }
}

/// A signed permutation matrix: the axes of the frame in another order.
template <class S, int N>
Eigen::Matrix<S, N, N> permutation(Random& random) {
  Eigen::Matrix<S, N, N> m = Eigen::Matrix<S, N, N>::Identity();
  for (int i = 0; i < N; ++i) {
    m.col(i).swap(m.col(random.integer(i, N - 1)));
    m.col(i) *= static_cast<S>(random.sign());
  }
  return m;
}

template <class S, int N>
Eigen::Matrix<S, N, N> axes(Random& random, Numbers numbers) {
  Eigen::Matrix<S, N, N> m;
  switch (random.below(5)) {
    case 0:
      return permutation<S, N>(random);
    case 1:
      return rotation<S, N>(random, 3);
    case 2:
      return permutation<S, N>(random) * rotation<S, N>(random, random.magnitude(-16, -5));
    case 3:
      for (int i = 0; i < N; ++i) m.col(i) = vector<S, N>(random, Numbers::grid) / 2;
      return m;
    default:
      for (int i = 0; i < N; ++i) m.col(i) = vector<S, N>(random, numbers);
      return m;
  }
}

/// Center and half-lengths from `numbers`, one half-length in eight 0. The axes may be dependent, seldom.
template <class S, int N>
Obb<S, N> obb(Random& random, Numbers numbers) {
  Obb<S, N> box = {vector<S, N>(random, numbers), axes<S, N>(random, numbers), vector<S, N>(random, numbers)};
  for (int i = 0; i < N; ++i) box.half[i] = random.one_in(8) ? S(0) : std::abs(box.half[i]);
  return box;
}

}  // namespace isect::bench
