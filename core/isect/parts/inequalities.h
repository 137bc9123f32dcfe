#pragma once
// Linear inequalities a_i.x + w_i >= 0 in space: have they a common point, how far is it from the origin, which are its
// corners? Each by signs of determinants.
//
// Common point. There is none iff the inequalities contradict each other: for some weights l_i >= 0 the sum of l_i a_i
// is 0 and that of l_i w_i negative (Farkas). They have no common interior point iff the latter is at most 0 for some
// that are not all 0 (Gordan). By Caratheodory four of the a_i do, linearly independent but for one relation between
// them; that relation, by Cramer, has the weights
//
//   [jkl], -[ikl], [ijl], -[ijk],   [ijk] being the determinant of a_i, a_j, a_k.
//
// Fewer than four are found with weights of 0 for others. So that there always are four, the unit vectors are added,
// whose weights must be 0.
//
// Distance. By duality the squared distance of the origin from what they have in common is the greatest of all
// g.G^-1 g over independent sets of at most three a_i, where G are their products, g = -w, and G^-1 g >= 0: each such
// value is a lower bound, so nobody need ask whether the point belonging to it is a common one. Source: Boyd,
// Vandenberghe, Convex Optimization (2004), 5.8 and 8.1.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <isect/numbers/predicate.h>
#include <isect/trace.h>

namespace isect::inequalities {

/// a, then w.
template <class W>
using Row = std::array<W, 4>;

namespace detail {

template <Filtered W>
Components<W, 3> normal(const Row<W>& row) {
  return {row[0], row[1], row[2]};
}
template <Filtered W>
W determinant(const Row<W>& x, const Row<W>& y, const Row<W>& z) {
  return dot(normal(x), cross(normal(y), normal(z)));
}

/// A text's rows, with those in doubles worked out once.
template <class Text>
class Rows {
 public:
  Rows(int count, const Text& text) : text_(text) {
    for (int i = 0; i < count; ++i) quick_.push_back(text.template operator()<Bounded<double>>(i));
  }
  int count() const { return static_cast<int>(quick_.size()); }
  template <Filtered W>
  Row<W> row(int i) const {
    if constexpr (std::is_same_v<W, Bounded<double>>)
      return quick_[static_cast<std::size_t>(i)];
    else
      return text_.template operator()<W>(i);
  }

 private:
  const Text& text_;
  std::vector<Row<Bounded<double>>> quick_;
};

/// Row i of the text, the unit vectors behind the last.
template <Filtered W, class Text>
Row<W> row_or_unit(const Text& text, int count, int i) {
  if (i < count) return text.template operator()<W>(i);
  Row<W> unit = {W(0), W(0), W(0), W(0)};
  unit[static_cast<std::size_t>(i - count)] = W(1);
  return unit;
}

/// The point where three planes meet, times their determinant.
template <Filtered W>
Components<W, 3> corner(const Row<W>& x, const Row<W>& y, const Row<W>& z) {
  const Components<W, 3> a = normal(x), b = normal(y), c = normal(z);
  const Components<W, 3> bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  Components<W, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = -(x[3] * bc[i] + y[3] * ca[i] + z[3] * ab[i]);
  return at;
}

}  // namespace detail

/// 1: they have a common point at which none of the `strict` ones is an equation. 0: a common point, but no such one.
/// -1: none. `text` is operator()<W>(i) -> Row<W>, `strict` i -> bool. With `last` asked only for contradictions in
/// which the last row has a weight.
template <class Text, class Strict, class Trace>
int common(int count, const Text& text, bool last, const Strict& strict, Trace&& trace) {
  using namespace detail;
  const auto padded = [&]<class W>(int i) -> Row<W> { return row_or_unit<W>(text, count, i); };
  const Rows rows(count + 3, padded);
  const int n = rows.count();
  const auto place = [n](int i, int j, int k) { return (static_cast<std::size_t>(i) * n + j) * n + k; };
  std::vector<signed char> signs(static_cast<std::size_t>(n) * n * n);
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k)
        signs[place(i, j, k)] = static_cast<signed char>(sign_of_long(
            [&]<class W>() -> W {
              return determinant(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
            },
            trace));

  int least = 1;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k)
        for (int l = k + 1; l < n; ++l) {
          const std::array<int, 4> of = {i, j, k, l};
          const std::array<int, 4> weight = {signs[place(j, k, l)], -signs[place(i, k, l)], signs[place(i, j, l)],
                                             -signs[place(i, j, k)]};
          const auto [lo, hi] = std::minmax_element(weight.begin(), weight.end());
          if (*lo == *hi ? *lo == 0 : *lo < 0 && *hi > 0) continue;
          bool counts = !last;
          bool idle = true;    // the unit vectors
          bool parts = false;  // some strict one has a weight, so that a sum of 0 contradicts it
          for (std::size_t m = 0; m < 4; ++m) {
            if (of[m] >= count) idle &= weight[m] == 0;
            if (of[m] == count - 1) counts |= weight[m] != 0;
            if (of[m] < count && weight[m] != 0) parts |= strict(of[m]);
          }
          if (!counts || !idle) continue;
          const int sum = sign_of_long(
              [&]<class W>() -> W {
                const Row<W> a = rows.template row<W>(i), b = rows.template row<W>(j), c = rows.template row<W>(k),
                             d = rows.template row<W>(l);
                return (a[3] * determinant(b, c, d) - b[3] * determinant(a, c, d)) +
                       (c[3] * determinant(a, b, d) - d[3] * determinant(a, b, c));
              },
              trace);
          if (sum != 0 || parts) least = std::min(least, *hi > 0 ? sum : -sum);
          if (least < 0) return least;
        }
  return least;
}

/// 1: they have a common interior point. 0: a common point, but no interior one. -1: none.
template <class Text, class Trace>
int common(int count, const Text& text, bool last, Trace&& trace) {
  return common(
      count, text, last, [](int) { return true; }, trace);
}

/// The sign of d - r, where d is the origin's distance from the common points, of which there is one; r >= 0.
template <class Text, class Trace>
int distance(int count, const Text& text, double r, Trace&& trace) {
  using namespace detail;
  const Rows rows(count, text);
  std::vector<char> beyond;  // those that the origin doesn't keep
  for (int i = 0; i < count; ++i)
    beyond.push_back(sign_of_long([&]<class W>() -> W { return rows.template row<W>(i)[3]; }, trace) < 0);

  int most = r > 0 ? -1 : 0;
  const auto take = [&](int sign) { most = std::max(most, sign); };
  for (int i = 0; i < count && most < 1; ++i) {
    if (!beyond[static_cast<std::size_t>(i)]) continue;
    take(sign_of_long(
        [&]<class W>() -> W {
          const Row<W> x = rows.template row<W>(i);
          return x[3] * x[3] - W(r) * W(r) * dot(normal(x), normal(x));
        },
        trace));
  }
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count && most < 1; ++j) {
      if (!beyond[static_cast<std::size_t>(i)] && !beyond[static_cast<std::size_t>(j)]) continue;
      const auto weight = [&](int p, int q) {
        return sign_of_long(
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
      if (sign_of_long(independent, trace) == 0) continue;
      take(sign_of_long(
          [&]<class W>() -> W {
            const Row<W> x = rows.template row<W>(i), y = rows.template row<W>(j);
            const Components<W, 3> a = normal(x), b = normal(y);
            Components<W, 3> foot;  // w_y a - w_x b: its square is the sum that is asked for
            for (std::size_t k = 0; k < 3; ++k) foot[k] = y[3] * a[k] - x[3] * b[k];
            const Components<W, 3> n = cross(a, b);
            return dot(foot, foot) - W(r) * W(r) * dot(n, n);
          },
          trace));
    }
  for (int i = 0; i < count; ++i)
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
          return sign_of_long(
              [&]<class W>() -> W {
                return dot(at.template operator()<W>(),
                           cross(normal(rows.template row<W>(p)), normal(rows.template row<W>(q))));
              },
              trace);
        };
        if (weight(j, k) < 0 || weight(k, i) < 0 || weight(i, j) < 0) continue;
        if (sign_of_long(det, trace) == 0) continue;
        take(sign_of_long(
            [&]<class W>() -> W {
              const Components<W, 3> x = at.template operator()<W>();
              const W d = det.template operator()<W>();
              return dot(x, x) - W(r) * W(r) * (d * d);
            },
            trace));
      }
  return most;
}

/// Whether there is a corner of what they have in common and `holds` says yes of each. holds(x, d) gets two texts: the
/// corner times a number, and that number, which is not 0.
template <class Text, class Holds, class Trace>
bool all_corners(int count, const Text& text, const Holds& holds, Trace&& trace) {
  using namespace detail;
  const Rows rows(count, text);
  bool any = false;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k) {
        const auto det = [&]<class W>() -> W {
          return determinant(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
        };
        const auto at = [&]<class W>() -> Components<W, 3> {
          return corner(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
        };
        const int side = sign_of_long(det, trace);
        bool common = side != 0;
        for (int m = 0; m < count && common; ++m) {
          if (m == i || m == j || m == k) continue;
          common =
              side * sign_of_long(
                         [&]<class W>() -> W {
                           const Row<W> row = rows.template row<W>(m);
                           return dot(normal(row), at.template operator()<W>()) + row[3] * det.template operator()<W>();
                         },
                         trace) >=
              0;
        }
        if (!common) continue;
        any = true;
        if (!holds(at, det)) return false;
      }
  return any;
}

/// Whether no direction leads away for ever: from what they have in common, if they have a common point.
template <class Text, class Trace>
bool bounded(int count, int dimension, const Text& text, Trace&& trace) {
  for (int way = 0; way < 2 * dimension; ++way) {
    const auto receding = [&]<class W>(int i) -> Row<W> {
      if (i < count) {
        Row<W> row = text.template operator()<W>(i);
        row[3] = W(0);
        return row;
      }
      Row<W> row = {W(0), W(0), W(0), W(-1)};
      row[static_cast<std::size_t>(way / 2)] = W(way % 2 == 0 ? 1 : -1);
      return row;
    };
    if (common(count + 1, receding, false, trace) >= 0) return false;
  }
  return true;
}

}  // namespace isect::inequalities
