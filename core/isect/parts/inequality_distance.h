#pragma once
// How far the common part of linear inequalities (isect/parts/inequalities.h) lies from the origin.
//
// By duality the squared distance is the greatest of all g.G^-1 g over independent sets of at most three a_i, where G
// are their products, g = -w, and G^-1 g >= 0: each such value is a lower bound, so nobody need ask whether the point
// that belongs to it is a common one. Source: Boyd, Vandenberghe, Convex Optimization (2004), 5.8 and 8.1.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <isect/parts/inequalities.h>

namespace isect::inequalities {

namespace detail {

/// The sign of what row i alone says of the distance, less the limit; `excess` is as in `distance`.
template <class Text, class Excess, class Trace>
int excess_of_one(const Rows<Text>& rows, int i, const Excess& excess, Trace&& trace) {
  return sign_of<long_text>(
      [&]<class W>() -> W {
        const Row<W> x = rows.template row<W>(i);
        return excess.template operator()<W>(x[3] * x[3], dot(normal(x), normal(x)));
      },
      trace);
}

/// The sign of what rows i and j say together; nothing where a weight is below 0, or they depend on each other.
template <class Text, class Excess, class Trace>
std::optional<int> excess_of_two(const Rows<Text>& rows, int i, int j, const Excess& excess, Trace&& trace) {
  const auto weight = [&](int p, int q) {
    return sign_of<long_text>(
        [&]<class W>() -> W {
          const Row<W> x = rows.template row<W>(p), y = rows.template row<W>(q);
          return y[3] * dot(normal(x), normal(y)) - x[3] * dot(normal(y), normal(y));
        },
        trace);
  };
  if (weight(i, j) < 0 || weight(j, i) < 0) return {};
  const auto independent = [&]<class W>() -> W {
    const Components<W, 3> n = cross(normal(rows.template row<W>(i)), normal(rows.template row<W>(j)));
    return dot(n, n);
  };
  if (sign_of<long_text>(independent, trace) == 0) return {};
  return sign_of<long_text>(
      [&]<class W>() -> W {
        const Row<W> x = rows.template row<W>(i), y = rows.template row<W>(j);
        const Components<W, 3> a = normal(x), b = normal(y);
        Components<W, 3> foot;  // w_y a - w_x b: its square is the sum that is asked for
        for (std::size_t k = 0; k < 3; ++k) foot[k] = y[3] * a[k] - x[3] * b[k];
        const Components<W, 3> n = cross(a, b);
        return excess.template operator()<W>(dot(foot, foot), dot(n, n));
      },
      trace);
}

/// The sign of what rows i, j and k say together; nothing as for two.
template <class Text, class Excess, class Trace>
std::optional<int> excess_of_three(const Rows<Text>& rows, int i, int j, int k, const Excess& excess, Trace&& trace) {
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
  if (weight(j, k) < 0 || weight(k, i) < 0 || weight(i, j) < 0) return {};
  if (sign_of<long_text>(det, trace) == 0) return {};
  return sign_of<long_text>(
      [&]<class W>() -> W {
        const Components<W, 3> x = at.template operator()<W>();
        const W d = det.template operator()<W>();
        return excess.template operator()<W>(dot(x, x), d * d);
      },
      trace);
}

}  // namespace detail

/// The sign of the origin's distance from the common points less a limit; there is a common point, and the limit is
/// above 0 iff `above_0`, else 0. `excess` is operator()<W>(square, scale) -> W: square / scale less the limit's
/// square, times a positive number. With `dimension` 2 all is in a plane, as the rows' normals are.
template <class Text, class Excess, class Trace>
int distance(int count, int dimension, const Text& text, bool above_0, const Excess& excess, Trace&& trace) {
  using namespace detail;
  const Rows rows(count, text);
  std::vector<char> is_beyond;  // those that do not hold at the origin
  for (int i = 0; i < count; ++i)
    is_beyond.push_back(sign_of<long_text>([&]<class W>() -> W { return rows.template row<W>(i)[3]; }, trace) < 0);
  const auto beyond = [&](int i) { return is_beyond[static_cast<std::size_t>(i)] != 0; };

  int most = above_0 ? -1 : 0;
  const auto take = [&](std::optional<int> sign) { most = std::max(most, sign.value_or(most)); };
  for (int i = 0; i < count && most < 1; ++i)
    if (beyond(i)) take(excess_of_one(rows, i, excess, trace));
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count && most < 1; ++j)
      if (beyond(i) || beyond(j)) take(excess_of_two(rows, i, j, excess, trace));
  for (int i = 0; i < count && dimension == 3; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count && most < 1; ++k)
        if (beyond(i) || beyond(j) || beyond(k)) take(excess_of_three(rows, i, j, k, excess, trace));
  return most;
}

/// The sign of d - r, where d is the origin's distance from the common points, of which there is one; r >= 0.
template <class Text, class Trace>
int distance(int count, const Text& text, double r, Trace&& trace) {
  const auto excess = [r]<class W>(const W& square, const W& scale) -> W { return square - W(r) * W(r) * scale; };
  return distance(count, 3, text, r > 0, excess, trace);
}

}  // namespace isect::inequalities
