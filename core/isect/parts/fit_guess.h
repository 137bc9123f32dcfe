#pragma once
// Where to put the bounding volumes of isect/fit.h, and how to turn them: rounded numbers, which need not be right.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <isect/shapes.h>

namespace isect {

namespace fit {

namespace detail {

/// The points relative to `origin` and at a scale near 1, rounded: p = origin + 2^exponent q. For heuristics.
template <int N>
struct Scaled {
  Point<double, N> origin;
  int exponent = 0;
  std::vector<Point<double, N>> q;

  /// The finite point of S nearest to the original of x, up to rounding.
  template <class S>
  Point<S, N> original(const Point<double, N>& x) const {
    constexpr double most = std::numeric_limits<S>::max();
    Point<S, N> p;
    for (int k = 0; k < N; ++k) p[k] = static_cast<S>(std::clamp(origin[k] + std::ldexp(x[k], exponent), -most, most));
    return p;
  }
};

/// Scales the points around the center of their box.
template <class S, int N>
Scaled<N> scaled(const std::vector<Point<S, N>>& points, const Aabb<S, N>& box) {
  const Aabb<double, N> wide = cast<double>(box);
  Scaled<N> result;
  result.origin = wide.lo / 2 + wide.hi / 2;
  std::frexp((wide.hi / 2 - wide.lo / 2).maxCoeff(), &result.exponent);
  result.q.reserve(points.size());
  for (const Point<S, N>& p : points) {
    const Point<double, N> from_origin = p.template cast<double>() - result.origin;
    result.q.push_back(from_origin.unaryExpr([&](double x) { return std::ldexp(x, -result.exponent); }));
  }
  return result;
}

/// Finds a center near that of the smallest ball: it moves towards the farthest point, by ever shorter steps.
/// Source: Badoiu, Clarkson, Smaller core-sets for balls, SODA 2003.
template <int N>
Point<double, N> ball_center(const std::vector<Point<double, N>>& q) {
  Point<double, N> center = Point<double, N>::Zero(), best = center;
  double least2 = std::numeric_limits<double>::infinity();
  constexpr int rounds = 32;
  for (int round = 1; round <= rounds; ++round) {
    const auto nearer = [&](const auto& x, const auto& y) {
      return (x - center).squaredNorm() < (y - center).squaredNorm();
    };
    const Point<double, N> farthest = *std::max_element(q.begin(), q.end(), nearer);
    const double distance2 = (farthest - center).squaredNorm();
    if (distance2 < least2) least2 = distance2, best = center;
    center += (farthest - center) / (round + 1);
  }
  return best;
}

/// The box of the points in the frame of these orthonormal axes, rounded.
template <int N>
Aabb<double, N> along(const Eigen::Matrix<double, N, N>& axes, const std::vector<Point<double, N>>& q) {
  const auto coordinate = [](const double* axis, const double* x) {
    double sum = axis[0] * x[0];
    for (int k = 1; k < N; ++k) sum += axis[k] * x[k];
    return sum;
  };
  Aabb<double, N> box;
  for (int i = 0; i < N; ++i) {
    const double* const axis = axes.data() + i * N;  // a column
    double lo = coordinate(axis, q[0].data()), hi = lo;
    for (const Point<double, N>& x : q) {
      const double at = coordinate(axis, x.data());
      lo = std::min(lo, at), hi = std::max(hi, at);
    }
    box.lo[i] = lo, box.hi[i] = hi;
  }
  return box;
}

/// Unit eigenvectors of a symmetric matrix, a column each, by ascending eigenvalues: Jacobi's rotations, each of which
/// makes one entry beside the diagonal 0. Needs no more than a square root, so that all machines find the same.
/// Source: Golub, Van Loan, Matrix computations, 4th ed., 8.5.
template <int N>
Eigen::Matrix<double, N, N> eigenvectors(Eigen::Matrix<double, N, N> m) {
  Eigen::Matrix<double, N, N> v = Eigen::Matrix<double, N, N>::Identity();
  constexpr int rounds = 12;  // the entries fall quadratically at last: after five or six rounds all are 0
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < N; ++i)
      for (int j = i + 1; j < N; ++j) {
        if (m(i, j) == 0) continue;
        const double cot2 = (m(j, j) - m(i, i)) / (2 * m(i, j));
        const double tan = std::copysign(1 / (std::abs(cot2) + std::sqrt(cot2 * cot2 + 1)), cot2);
        const double cos = 1 / std::sqrt(tan * tan + 1), sin = tan * cos;
        for (int k = 0; k < N; ++k) {
          const double x = m(k, i), y = m(k, j), vx = v(k, i), vy = v(k, j);
          m(k, i) = cos * x - sin * y, m(k, j) = sin * x + cos * y;
          v(k, i) = cos * vx - sin * vy, v(k, j) = sin * vx + cos * vy;
        }
        for (int k = 0; k < N; ++k) {
          const double x = m(i, k), y = m(j, k);
          m(i, k) = cos * x - sin * y, m(j, k) = sin * x + cos * y;
        }
        m(i, j) = m(j, i) = 0;
      }

  for (int i = 0; i < N; ++i) {
    int least = i;
    for (int j = i + 1; j < N; ++j)
      if (m(j, j) < m(least, least)) least = j;
    std::swap(m(i, i), m(least, least));
    v.col(i).swap(v.col(least));
  }
  return v;
}

/// The eigenvectors of the points' covariance.
template <int N>
Eigen::Matrix<double, N, N> principal_axes(const std::vector<Point<double, N>>& q) {
  Point<double, N> mean = Point<double, N>::Zero();
  for (const Point<double, N>& x : q) mean += x / static_cast<double>(q.size());
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();
  for (const Point<double, N>& x : q) {
    const Vector<double, N> d = x - mean;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) covariance(i, j) += d[i] * d[j];
  }
  return eigenvectors<N>(covariance);
}

}  // namespace detail

}  // namespace fit

}  // namespace isect
