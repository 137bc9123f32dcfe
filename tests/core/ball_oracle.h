#pragma once
// The smallest ball of a few points, in rationals: the least of all balls through N + 1 of them or fewer that hold the
// rest.

#include <algorithm>
#include <optional>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle {

template <int N>
struct Ball {
  Coordinates<N> center;
  Rational radius2;
};

/// The center in the affine hull of the points that is equally far from all; nothing when they are dependent. Gram's
/// matrix is eliminated, where the core uses Cramer's rule.
template <int N>
std::optional<Coordinates<N>> circumcenter(const std::vector<Coordinates<N>>& p) {
  const std::size_t m = p.size() - 1;
  std::vector<std::vector<Rational>> rows(m, std::vector<Rational>(m + 1));
  for (std::size_t i = 0; i < m; ++i) {
    const auto u = p[i + 1] - p[0];
    for (std::size_t j = 0; j < m; ++j) rows[i][j] = dot(u, p[j + 1] - p[0]);
    rows[i][m] = dot(u, u) / 2;
  }
  for (std::size_t c = 0; c < m; ++c) {
    if (rows[c][c] == 0) return {};  // Gram's matrix is positive definite, or the points dependent
    for (std::size_t r = 0; r < m; ++r) {
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= m && r != c; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  Coordinates<N> center = p[0];
  for (std::size_t i = 0; i < m; ++i) center = center + Rational(rows[i][m] / rows[i][i]) * (p[i + 1] - p[0]);
  return center;
}

template <class S, int N>
Ball<N> smallest_ball(const std::vector<Point<S, N>>& points) {
  std::vector<Coordinates<N>> p;
  for (const Point<S, N>& x : points) p.push_back(rational<S, N>(x));
  std::sort(p.begin(), p.end());
  p.erase(std::unique(p.begin(), p.end()), p.end());
  std::optional<Ball<N>> least;
  for (unsigned subset = 1; subset < 1u << p.size(); ++subset) {
    std::vector<Coordinates<N>> through;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (subset >> i & 1) through.push_back(p[i]);
    if (through.size() > N + 1) continue;
    const auto c = circumcenter<N>(through);
    if (!c) continue;
    const Rational r2 = dot(through[0] - *c, through[0] - *c);
    if (least && r2 >= least->radius2) continue;
    if (std::all_of(p.begin(), p.end(), [&](const auto& x) { return dot(x - *c, x - *c) <= r2; }))
      least = Ball<N>{*c, r2};
  }
  return *least;
}

}  // namespace isect::oracle
