#pragma once
// How far the common part of linear inequalities (isect/parts/inequalities.h) lies from the origin.
//
// By duality the squared distance is the greatest of all g.G^-1 g over independent sets of at most three a_i, where G
// are their products, g = -w, and G^-1 g >= 0: each such value is a lower bound, so nobody need ask whether the point
// that belongs to it is a common one. Source: Boyd, Vandenberghe, Convex Optimization (2004), 5.8 and 8.1.

#include <algorithm>
#include <cstddef>
#include <vector>

#include <isect/parts/inequalities.h>

namespace isect::inequalities {

/// The sign of the origin's distance from the common points less a limit; there is a common point, and the limit is
/// above 0 iff `above_0`, else 0. `excess` is operator()<W>(square, scale) -> W: square / scale less the limit's
/// square, times a positive number. With `dimension` 2 all is in a plane, as the rows' normals are.
template <class Text, class Excess, class Trace>
int distance(int count, int dimension, const Text& text, bool above_0, const Excess& excess, Trace&& trace) {
  using namespace detail;
  const Rows rows(count, text);
  std::vector<char> beyond;  // those that do not hold at the origin
  for (int i = 0; i < count; ++i)
    beyond.push_back(sign_of<long_text>([&]<class W>() -> W { return rows.template row<W>(i)[3]; }, trace) < 0);

  int most = above_0 ? -1 : 0;
  const auto take = [&](int sign) { most = std::max(most, sign); };
  for (int i = 0; i < count && most < 1; ++i) {
    if (!beyond[static_cast<std::size_t>(i)]) continue;
    take(sign_of<long_text>(
        [&]<class W>() -> W {
          const Row<W> x = rows.template row<W>(i);
          return excess.template operator()<W>(x[3] * x[3], dot(normal(x), normal(x)));
        },
        trace));
  }
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count && most < 1; ++j) {
      if (!beyond[static_cast<std::size_t>(i)] && !beyond[static_cast<std::size_t>(j)]) continue;
      const auto weight = [&](int p, int q) {
        return sign_of<long_text>(
            [&]<class W>() -> W {
              const Row<W> x = rows.template row<W>(p), y = rows.template row<W>(q);
              return y[3] * dot(normal(x), normal(y)) - x[3] * dot(normal(y), normal(y));
            },
            trace);
      };
      if (weight(i, j) < 0 || weight(j, i) < 0) continue;
      const auto independent = [&]<class W>() -> W {
        const Components<W, 3> n = cross(normal(rows.template row<W>(i)), normal(rows.template row<W>(j)));
        return dot(n, n);
      };
      if (sign_of<long_text>(independent, trace) == 0) continue;
      take(sign_of<long_text>(
          [&]<class W>() -> W {
            const Row<W> x = rows.template row<W>(i), y = rows.template row<W>(j);
            const Components<W, 3> a = normal(x), b = normal(y);
            Components<W, 3> foot;  // w_y a - w_x b: its square is the sum that is asked for
            for (std::size_t k = 0; k < 3; ++k) foot[k] = y[3] * a[k] - x[3] * b[k];
            const Components<W, 3> n = cross(a, b);
            return excess.template operator()<W>(dot(foot, foot), dot(n, n));
          },
          trace));
    }
  for (int i = 0; i < count && dimension == 3; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count && most < 1; ++k) {
        if (!beyond[static_cast<std::size_t>(i)] && !beyond[static_cast<std::size_t>(j)] &&
            !beyond[static_cast<std::size_t>(k)])
          continue;
        const auto det = [&]<class W>() -> W {
          return determinant(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
        };
        const auto at = [&]<class W>() -> Components<W, 3> {
          return corner(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
        };
        const auto weight = [&](int p, int q) {
          return sign_of<long_text>(
              [&]<class W>() -> W {
                return dot(at.template operator()<W>(),
                           cross(normal(rows.template row<W>(p)), normal(rows.template row<W>(q))));
              },
              trace);
        };
        if (weight(j, k) < 0 || weight(k, i) < 0 || weight(i, j) < 0) continue;
        if (sign_of<long_text>(det, trace) == 0) continue;
        take(sign_of<long_text>(
            [&]<class W>() -> W {
              const Components<W, 3> x = at.template operator()<W>();
              const W d = det.template operator()<W>();
              return excess.template operator()<W>(dot(x, x), d * d);
            },
            trace));
      }
  return most;
}

/// The sign of d - r, where d is the origin's distance from the common points, of which there is one; r >= 0.
template <class Text, class Trace>
int distance(int count, const Text& text, double r, Trace&& trace) {
  const auto excess = [r]<class W>(const W& square, const W& scale) -> W { return square - W(r) * W(r) * scale; };
  return distance(count, 3, text, r > 0, excess, trace);
}

}  // namespace isect::inequalities
