#pragma once
// Where a ray meets an oriented box, in rationals.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle {

/// The coefficients s of v = sum s_i u_i, by Cramer's rule; nothing for dependent axes.
template <class S, int N>
std::optional<Coordinates<N>> coordinates(const Eigen::Matrix<S, N, N>& axes, const Coordinates<N>& v) {
  std::array<Coordinates<N>, N> u;
  for (int i = 0; i < N; ++i) u[i] = rational<S, N>(axes.col(i));
  const auto determinant = [](const std::array<Coordinates<N>, N>& m) -> Rational {
    if constexpr (N == 2)
      return m[0][0] * m[1][1] - m[0][1] * m[1][0];
    else
      return dot(m[0], cross(m[1], m[2]));
  };
  const Rational whole = determinant(u);
  if (whole == 0) return {};
  Coordinates<N> s;
  for (int i = 0; i < N; ++i) {
    std::array<Coordinates<N>, N> replaced = u;
    replaced[i] = v;
    s[i] = determinant(replaced) / whole;
  }
  return s;
}

/// The ends of the part of the range in the box: the least and the largest feasible t of all candidates, tried one by
/// one in the box's own coordinates. NaN, an infinite coordinate or dependent axes: nothing.
template <class S, int N>
std::optional<std::pair<Rational, Rational>> ray_obb(const Ray<S, N>& ray, const Obb<S, N>& box) {
  if (!finite(ray) || !finite(box) || empty(ray.range) || empty(box)) return {};
  const auto o = coordinates<S, N>(box.axes, rational<S, N>(ray.origin) - rational<S, N>(box.center));
  const auto d = coordinates<S, N>(box.axes, rational<S, N>(ray.direction));
  if (!o || !d) return {};
  const auto half = rational<S, N>(box.half);

  std::vector<Rational> candidates;
  for (int i = 0; i < N; ++i)
    if ((*d)[i] != 0)
      for (const int side : {-1, 1}) candidates.push_back((side * half[i] - (*o)[i]) / (*d)[i]);
  const bool is_point = candidates.empty();
  if (is_point) candidates.push_back(0);
  for (const S end : {ray.range.lo, ray.range.hi})
    if (!std::isinf(end)) candidates.push_back(Rational(end));

  std::optional<std::pair<Rational, Rational>> result;
  for (const Rational& t : candidates) {
    bool inside = is_point || holds(ray.range, t);
    for (int i = 0; inside && i < N; ++i) inside = abs(Rational((*o)[i] + t * (*d)[i])) <= half[i];
    if (!inside) continue;
    if (!result) result = {t, t};
    result = {std::min(result->first, t), std::max(result->second, t)};
  }
  return result;
}

}  // namespace isect::oracle
