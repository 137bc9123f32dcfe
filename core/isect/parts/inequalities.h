#pragma once
// Linear inequalities a_i.x + w_i >= 0 in space: do they have a common point, which others follow from them, which are
// the corners of their common part? Signs of determinants answer each.
//
// What follows. An inequality holds wherever all of them do iff it is a sum of them, and of 1 >= 0, with weights that
// are not negative (Farkas; for inequalities that have a common point). There is no common point iff -1 >= 0 is such a
// sum, and one is an equation iff its opposite is. Four rows (a, w) that are independent make a basis: by Cramer a
// row's weight at one of the four is its value at the corner where the other three planes meet, over the value there of
// the one that is weighed. If a weight is negative, that corner, a point or a direction, satisfies all, which tells
// that nothing follows, or it violates some row, which takes the place of the one that is weighed. The first that can
// leaves, the first that can comes: so no basis comes twice (Bland). Source: Schrijver, Theory of Linear and Integer
// Programming (1986), theorem 7.1.

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

template <PolynomialScalar W>
Components<W, 3> normal(const Row<W>& row) {
  return {row[0], row[1], row[2]};
}
template <PolynomialScalar W>
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
  template <PolynomialScalar W>
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

/// The point where three planes meet, times their determinant.
template <PolynomialScalar W>
Components<W, 3> corner(const Row<W>& x, const Row<W>& y, const Row<W>& z) {
  const Components<W, 3> a = normal(x), b = normal(y), c = normal(z);
  const Components<W, 3> bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  Components<W, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = -(x[3] * bc[i] + y[3] * ca[i] + z[3] * ab[i]);
  return at;
}

/// The value of a row where three planes meet, times their determinant.
template <PolynomialScalar W>
W value_at_corner(const Row<W>& row, const Row<W>& x, const Row<W>& y, const Row<W>& z) {
  return dot(normal(row), corner(x, y, z)) + row[3] * determinant(x, y, z);
}

}  // namespace detail

/// A system of inequalities, which tells what follows from them. `text` is operator()<W>(i) -> Row<W>.
template <class Text, class Trace>
class System {
 public:
  System(int count, const Text& text, Trace& trace)
      : count_(count), padded_{text, count}, rows_(count + 1 + 4, padded_), trace_(trace) {
    start();
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// Whether the inequality is a sum of them with weights that are not negative: it holds wherever all of them do, if
  /// they have a common point. `goal` is operator()<W>() -> Row<W>.
  template <class Goal>
  bool implies(const Goal& goal) {
    return follows(goal, first_negative(goal));
  }
  /// Whether inequality i is an equation wherever all hold.
  bool is_equation(int i) {
    if (seen_positive_[static_cast<std::size_t>(i)]) return false;
    const auto opposite = [&]<class W>() -> Row<W> {
      Row<W> row = rows_.template row<W>(i);
      for (W& x : row) x = -x;
      return row;
    };
    const int own = place_of(i);
    return follows(opposite, own < 4 ? own : first_negative(opposite));
  }
  /// Whether they have no common point: then 0 = 1.
  bool contradictory() { return is_equation(count_); }

 private:
  static constexpr int none_negative = -1, out_of_span = -2;

  /// The rows, then 1 >= 0, then the unit vectors, which fill the basis where the rows span less.
  struct Padded {
    const Text& text;
    int count;

    template <class W>
    Row<W> operator()(int i) const {
      if (i < count) return text.template operator()<W>(i);
      Row<W> unit = {W(0), W(0), W(0), W(0)};
      unit[static_cast<std::size_t>(i == count ? 3 : i - count - 1)] = W(1);
      return unit;
    }
  };

  bool is_row(int i) const { return i <= count_; }
  /// The row's place in the basis; 4 if it is not in there.
  int place_of(int i) const { return static_cast<int>(std::ranges::find(basis_, i) - basis_.begin()); }

  /// Decides `implies`. `leaves` is what first_negative(goal) returns.
  template <class Goal>
  bool follows(const Goal& goal, int leaves) {
    for (; leaves >= 0; leaves = first_negative(goal)) {
      const int comes = first_violated(leaves);
      if (comes < 0) return false;
      basis_[static_cast<std::size_t>(leaves)] = comes;
      side_ = -side_;
    }
    return leaves == none_negative;
  }

  /// The corner where the planes of the basis except that at `place` meet, and the number that it is multiplied by.
  template <PolynomialScalar W>
  Row<W> corner_without(std::size_t place) const {
    std::array<Row<W>, 3> other;
    for (std::size_t i = 0; i < 3; ++i) other[i] = rows_.template row<W>(basis_[i < place ? i : i + 1]);
    const Components<W, 3> at = detail::corner(other[0], other[1], other[2]);
    return {at[0], at[1], at[2], detail::determinant(other[0], other[1], other[2])};
  }
  /// The sign of a row at that corner, where the basis' own row at `place` counts as positive.
  template <class Of>
  int sign_without(std::size_t place, const Row<Bounded<double>>& quick, const Of& of) const {
    const int sign = sign_of<long_text>(
        [&]<class W>() -> W {
          const Row<W> row = of.template operator()<W>();
          const auto at = [&]() -> Row<W> {
            if constexpr (std::is_same_v<W, Bounded<double>>)
              return quick;
            else
              return corner_without<W>(place);
          }();
          return (row[0] * at[0] + row[1] * at[1]) + (row[2] * at[2] + row[3] * at[3]);
        },
        trace_);
    return place % 2 == 0 ? -side_ * sign : side_ * sign;
  }
  auto text_of(int i) const {
    return [this, i]<class W>() -> Row<W> { return rows_.template row<W>(i); };
  }

  /// Fills the basis with as many rows as are independent.
  void start() {
    for (int i = 0; i < 4; ++i) basis_[static_cast<std::size_t>(i)] = count_ + 1 + i;
    for (int i = 0; i <= count_; ++i)
      for (std::size_t place = 0; place < 4; ++place) {
        if (is_row(basis_[place]) || sign_without(place, corner_without<Bounded<double>>(place), text_of(i)) == 0)
          continue;
        basis_[place] = i;
        break;
      }
    side_ = sign_without(3, corner_without<Bounded<double>>(3), text_of(basis_[3]));
  }

  /// Returns the place of the basis that has a negative weight in the goal; of several, that of the first row.
  template <class Goal>
  int first_negative(const Goal& goal) const {
    int first = none_negative;
    for (std::size_t place = 0; place < 4; ++place) {
      const int sign = sign_without(place, corner_without<Bounded<double>>(place), goal);
      if (sign != 0 && !is_row(basis_[place])) return out_of_span;
      if (sign < 0 && (first < 0 || basis_[place] < basis_[static_cast<std::size_t>(first)]))
        first = static_cast<int>(place);
    }
    return first;
  }

  /// Returns the first row that is violated at the corner without the basis' row at `leaves`. If there is none, all
  /// hold there, and those that hold strictly are known to be no equations.
  int first_violated(int leaves) {
    const auto place = static_cast<std::size_t>(leaves);
    const Row<Bounded<double>> corner = corner_without<Bounded<double>>(place);
    std::vector<int> positive;
    for (int i = 0; i <= count_; ++i) {
      const int own = place_of(i);
      const int sign = own < 4 ? own == leaves : sign_without(place, corner, text_of(i));
      if (sign < 0) return i;
      if (sign > 0) positive.push_back(i);
    }
    for (const int i : positive) seen_positive_[static_cast<std::size_t>(i)] = 1;
    return -1;
  }

  int count_;
  Padded padded_;
  detail::Rows<Padded> rows_;
  Trace& trace_;
  std::array<int, 4> basis_ = {};
  int side_ = 1;  // of the basis' determinant
  std::vector<char> seen_positive_ = std::vector<char>(static_cast<std::size_t>(count_) + 1);
};

/// Whether they have no common point.
template <class Text, class Trace>
bool contradictory(int count, const Text& text, Trace&& trace) {
  return System(count, text, trace).contradictory();
}

/// 1: they have a common point at which all `strict` ones hold strictly. 0: a common point, but no such one.
/// -1: none. `strict` is i -> bool.
template <class Text, class Strict, class Trace>
int common(int count, const Text& text, const Strict& strict, Trace&& trace) {
  System system(count, text, trace);
  if (system.contradictory()) return -1;
  for (int i = 0; i < count; ++i)
    if (strict(i) && system.is_equation(i)) return 0;
  return 1;
}

/// 1: they have a common interior point. 0: a common point, but no interior one. -1: none.
template <class Text, class Trace>
int common(int count, const Text& text, Trace&& trace) {
  return common(
      count, text, [](int) { return true; }, trace);
}

namespace detail {

/// Calls take(i, j, k, side) for each corner of the rows' common part, until it returns false: there the planes i, j
/// and k meet, and `side` is the sign of their determinant.
template <class Rows, class Take, class Trace>
void each_corner(const Rows& rows, const Take& take, Trace&& trace) {
  for (int i = 0; i < rows.count(); ++i)
    for (int j = i + 1; j < rows.count(); ++j)
      for (int k = j + 1; k < rows.count(); ++k) {
        const auto det = [&]<class W>() -> W {
          return determinant(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
        };
        const int side = sign_of<long_text>(det, trace);
        bool common = side != 0;
        for (int m = 0; m < rows.count() && common; ++m) {
          if (m == i || m == j || m == k) continue;
          const auto value = [&]<class W>() -> W {
            return value_at_corner(rows.template row<W>(m), rows.template row<W>(i), rows.template row<W>(j),
                                   rows.template row<W>(k));
          };
          common = side * sign_of<long_text>(value, trace) >= 0;
        }
        if (common && !take(i, j, k, side)) return;
      }
}

}  // namespace detail

/// Whether their common part has a corner and `holds` is true of each. holds(x, d) gets two texts: the corner times a
/// number, and that number, which is not 0.
template <class Text, class Holds, class Trace>
bool all_corners(int count, const Text& text, const Holds& holds, Trace&& trace) {
  using namespace detail;
  const Rows rows(count, text);
  bool any = false, all = true;
  const auto take = [&](int i, int j, int k, int) {
    const auto det = [&]<class W>() -> W {
      return determinant(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
    };
    const auto at = [&]<class W>() -> Components<W, 3> {
      return corner(rows.template row<W>(i), rows.template row<W>(j), rows.template row<W>(k));
    };
    any = true;
    return all = holds(at, det);
  };
  each_corner(rows, take, trace);
  return any && all;
}

/// Whether no direction leads away for ever, and so their common part, if they have a common point, is bounded.
template <class Text, class Trace>
bool bounded(int count, int dimension, const Text& text, Trace&& trace) {
  const auto direction = [&]<class W>(int i) -> Row<W> {
    Row<W> row = text.template operator()<W>(i);
    row[3] = W(0);
    return row;
  };
  System system(count, direction, trace);
  for (int way = 0; way < 2 * dimension; ++way) {
    const auto no_further = [&]<class W>() -> Row<W> {
      Row<W> row = {W(0), W(0), W(0), W(0)};
      row[static_cast<std::size_t>(way / 2)] = W(way % 2 == 0 ? 1 : -1);
      return row;
    };
    if (!system.implies(no_further)) return false;
  }
  return true;
}

}  // namespace isect::inequalities
