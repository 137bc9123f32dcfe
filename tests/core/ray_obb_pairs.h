#pragma once
// Rays and oriented boxes that are hard to tell apart, and where they truly meet, in rationals.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "bench/random_obb.h"
#include "bench/random_rays.h"
#include "bench/rational.h"

namespace isect::tests::ray_obb_pairs {

using bench::Numbers, bench::Random;
using oracle::Rational;

template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Obb<S, N> box;
};

/// Any box, and a ray from anywhere or aimed: at a corner, an edge, a face or the center, ending there at times.
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  Case<S, N> c = {bench::ray<S, N>(random, numbers), bench::obb<S, N>(random, numbers)};
  if (random.one_in(40)) c.box.half[0] = -c.box.half[0];
  if (random.one_in(3)) return c;
  Vector<S, N> across;
  for (int i = 0; i < N; ++i) across[i] = c.box.half[i] * static_cast<S>(random.integer(-1, 1));
  const Point<S, N> target = c.box.center + c.box.axes * across;
  const Vector<S, N> d = target - c.ray.origin;
  if (!finite(d)) return c;
  c.ray.direction = d;
  if (random.one_in(4)) c.ray.direction = c.box.axes.col(random.below(N)), c.ray.origin = target;
  if (random.one_in(4)) c.ray.range.hi = S(1), c.ray.range.lo = std::min(c.ray.range.lo, S(1));
  return c;
}

/// The coefficients s of v = sum s_i u_i, by Cramer's rule; nothing for dependent axes.
template <class S, int N>
std::optional<oracle::Coordinates<N>> coordinates(const Eigen::Matrix<S, N, N>& axes, const oracle::Coordinates<N>& v) {
  std::array<oracle::Coordinates<N>, N> u;
  for (int i = 0; i < N; ++i) u[i] = oracle::rational<S, N>(axes.col(i));
  const auto determinant = [](const std::array<oracle::Coordinates<N>, N>& m) -> Rational {
    if constexpr (N == 2)
      return m[0][0] * m[1][1] - m[0][1] * m[1][0];
    else
      return oracle::dot(m[0], oracle::cross(m[1], m[2]));
  };
  const Rational whole = determinant(u);
  if (whole == 0) return {};
  oracle::Coordinates<N> s;
  for (int i = 0; i < N; ++i) {
    std::array<oracle::Coordinates<N>, N> replaced = u;
    replaced[i] = v;
    s[i] = determinant(replaced) / whole;
  }
  return s;
}

/// The feasible t among all candidates for an end, tried one by one in the box's own coordinates.
template <class S, int N>
std::optional<std::pair<Rational, Rational>> truth(const Case<S, N>& c) {
  using oracle::operator-;
  if (empty(c.ray.range) || empty(c.box)) return {};
  const auto o =
      coordinates<S, N>(c.box.axes, oracle::rational<S, N>(c.ray.origin) - oracle::rational<S, N>(c.box.center));
  const auto d = coordinates<S, N>(c.box.axes, oracle::rational<S, N>(c.ray.direction));
  if (!o || !d) return {};
  const auto half = oracle::rational<S, N>(c.box.half);

  std::vector<Rational> candidates;
  for (int i = 0; i < N; ++i)
    if ((*d)[i] != 0)
      for (const int side : {-1, 1}) candidates.push_back((side * half[i] - (*o)[i]) / (*d)[i]);
  const bool is_point = candidates.empty();
  if (is_point) candidates.push_back(0);
  for (const S end : {c.ray.range.lo, c.ray.range.hi})
    if (!std::isinf(end)) candidates.push_back(Rational(end));

  std::optional<std::pair<Rational, Rational>> result;
  for (const Rational& t : candidates) {
    bool inside = is_point || oracle::holds(c.ray.range, t);
    for (int i = 0; inside && i < N; ++i) inside = abs(Rational((*o)[i] + t * (*d)[i])) <= half[i];
    if (!inside) continue;
    if (!result) result = {t, t};
    result = {std::min(result->first, t), std::max(result->second, t)};
  }
  return result;
}

}  // namespace isect::tests::ray_obb_pairs
