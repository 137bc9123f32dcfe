#pragma once
// How two oriented boxes lie, in rationals: by projections of all corners, and by the vertices of the common part.

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle::obb {

/// N is deduced from the boxes alone.
template <int N>
using Coordinates = std::type_identity_t<oracle::Coordinates<N>>;

template <int N>
struct Exactly {
  Coordinates<N> center, half;
  std::array<Coordinates<N>, N> axes;
  std::vector<Coordinates<N>> corners;

  static Rational power(int exponent) { return std::ldexp(1.0, exponent); }

  /// The box times 2^(lengths + turns), its axes times 2^turns: so that all may be integers, which are faster.
  template <class S>
  explicit Exactly(const Obb<S, N>& box, int lengths = 0, int turns = 0)
      : center(power(lengths + turns) * rational<S, N>(box.center)), half(power(lengths) * rational<S, N>(box.half)) {
    corners = {center};
    for (int i = 0; i < N; ++i) {
      axes[i] = power(turns) * rational<S, N>(box.axes.col(i));
      std::vector<Coordinates<N>> next;
      for (const Coordinates<N>& c : corners) next.insert(next.end(), {c + half[i] * axes[i], c - half[i] * axes[i]});
      corners = next;
    }
  }
};

/// Solves m x = y by elimination; false when m is singular.
template <int N>
bool solve(std::array<Coordinates<N>, N> rows, Coordinates<N> y, Coordinates<N>& x) {
  for (int column = 0; column < N; ++column) {
    int pivot = column;
    while (pivot < N && rows[pivot][column] == 0) ++pivot;
    if (pivot == N) return false;
    std::swap(rows[column], rows[pivot]), std::swap(y[column], y[pivot]);
    for (int i = 0; i < N; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const Rational factor = rows[i][column] / rows[column][column];
      rows[i] = rows[i] - factor * rows[column];
      y[i] -= factor * y[column];
    }
  }
  for (int i = 0; i < N; ++i) x[i] = y[i] / rows[i][i];
  return true;
}

/// The coordinates of x in the box's frame.
template <int N>
bool coordinates(const Exactly<N>& box, const Coordinates<N>& x, Coordinates<N>& s) {
  std::array<Coordinates<N>, N> rows;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) rows[i][j] = box.axes[j][i];
  return solve<N>(rows, x - box.center, s);
}

template <int N>
bool holds(const Exactly<N>& box, const Exactly<N>& inner) {
  for (const Coordinates<N>& corner : inner.corners) {
    Coordinates<N> s;
    if (!coordinates(box, corner, s)) return false;
    for (int i = 0; i < N; ++i)
      if (abs(s[i]) > box.half[i]) return false;
  }
  return true;
}

/// 1 if the corners' projections onto l are apart, 0 if they touch, -1 if they overlap or are the same point.
template <int N>
int along(const Coordinates<N>& l, const Exactly<N>& a, const Exactly<N>& b) {
  const auto range = [&](const Exactly<N>& box) {
    std::vector<Rational> values;
    for (const Coordinates<N>& c : box.corners) values.push_back(dot(l, c));
    const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
    return std::pair(*lo, *hi);
  };
  const auto [a_lo, a_hi] = range(a);
  const auto [b_lo, b_hi] = range(b);
  if (a_lo == a_hi && b_lo == b_hi && a_lo == b_lo) return -1;
  return std::max(sign(b_lo - a_hi), sign(a_lo - b_hi));
}

template <int N>
std::vector<Coordinates<N>> directions(const Exactly<N>& a, const Exactly<N>& b) {
  std::vector<Coordinates<N>> result;
  if constexpr (N == 2) {
    for (const auto& box : {a, b})
      for (const auto& u : box.axes) result.push_back({-u[1], u[0]});
  } else {
    std::vector<Coordinates<N>> edges(a.axes.begin(), a.axes.end());
    edges.insert(edges.end(), b.axes.begin(), b.axes.end());
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) result.push_back(cross(edges[i], edges[j]));
  }
  return result;
}

template <int N>
bool exists(const Exactly<N>& box) {
  Coordinates<N> s;
  return coordinates(box, box.center, s);
}

template <int N>
Relation relation(int outer, const Exactly<N>& a, const Exactly<N>& b) {
  if (outer > 0) return Relation::disjoint;
  const bool a_in_b = holds(b, a), b_in_a = holds(a, b);
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b || b_in_a) return a_in_b ? Relation::a_inside_b : Relation::b_inside_a;
  return outer == 0 ? Relation::touching : Relation::overlapping;
}

/// Decides by projections onto the cross products of all pairs of edges, in no particular order.
template <int N>
Relation by_projection(const Exactly<N>& a, const Exactly<N>& b) {
  if (!exists(a) || !exists(b)) return Relation::disjoint;
  int outer = -1;
  for (const Coordinates<N>& l : directions(a, b))
    if (l != Coordinates<N>{}) outer = std::max(outer, along(l, a, b));
  return relation(outer, a, b);
}

/// The number of binary places that the numbers have behind the point.
template <class S, int Rows, int Columns>
int bits_behind_point(const Eigen::Matrix<S, Rows, Columns>& numbers) {
  int bits = 0;
  for (const S x : numbers.reshaped())
    if (x != 0) bits = std::max(bits, std::numeric_limits<S>::digits - 1 - std::ilogb(x));
  return bits;
}

/// Whether the boxes have a common point, by projections of all corners onto one direction after another. For finite
/// boxes with independent axes; numbers below 1e-280 are too small for the scaling.
template <class S, int N>
bool meet_by_projection(const Obb<S, N>& a, const Obb<S, N>& b) {
  int lengths = 0, turns = 0;
  for (const Obb<S, N>* box : {&a, &b}) {
    lengths = std::max({lengths, bits_behind_point<S, N, 1>(box->center), bits_behind_point<S, N, 1>(box->half)});
    turns = std::max(turns, bits_behind_point<S, N, N>(box->axes));
  }
  const Exactly<N> exact_a(a, lengths, turns), exact_b(b, lengths, turns);
  for (const Coordinates<N>& l : directions(exact_a, exact_b))
    if (along(l, exact_a, exact_b) > 0) return false;
  return true;
}

/// Decides by the vertices of the common part: points of the frame of A where N of the 4 N faces meet. Without any the
/// boxes are apart; their mean is interior to both, if any point is. No separating axis is used.
template <int N>
Relation by_vertices(const Exactly<N>& a, const Exactly<N>& b) {
  if (!exists(a) || !exists(b)) return Relation::disjoint;
  struct Face {
    Coordinates<N> normal;  // normal.s <= limit
    Rational limit;
  };
  std::vector<Face> faces;
  Coordinates<N> origin;  // of A in the frame of B
  coordinates(b, a.center, origin);
  std::array<Coordinates<N>, N> image;  // the axes of A in the frame of B
  for (int i = 0; i < N; ++i) coordinates(b, b.center + a.axes[i], image[i]);
  for (int i = 0; i < N; ++i)
    for (const int side : {1, -1}) {
      Coordinates<N> unit = {}, row;
      unit[i] = side;
      for (int j = 0; j < N; ++j) row[j] = side * image[j][i];
      faces.push_back({unit, a.half[i]});
      faces.push_back({row, b.half[i] - side * origin[i]});
    }

  std::vector<Coordinates<N>> vertices;
  const auto add = [&](const std::array<int, N>& chosen) {
    std::array<Coordinates<N>, N> rows;
    Coordinates<N> limits, s;
    for (int i = 0; i < N; ++i) rows[i] = faces[chosen[i]].normal, limits[i] = faces[chosen[i]].limit;
    if (!solve<N>(rows, limits, s)) return;
    for (const Face& face : faces)
      if (dot(face.normal, s) > face.limit) return;
    vertices.push_back(s);
  };
  const int count = 4 * N;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) {
      if constexpr (N == 2) {
        add({i, j});
      } else {
        for (int k = 0; k < j; ++k) add({i, j, k});
      }
    }
  if (vertices.empty()) return Relation::disjoint;
  Coordinates<N> middle = {};
  for (const Coordinates<N>& v : vertices) middle = middle + v;
  middle = (Rational(1) / static_cast<int>(vertices.size())) * middle;
  const auto interior = [](const Rational& x, const Rational& half) { return half == 0 ? x == 0 : abs(x) < half; };
  bool inner = true;
  for (int i = 0; i < N; ++i) {
    Rational in_b = origin[i];
    for (int j = 0; j < N; ++j) in_b += image[j][i] * middle[j];
    inner = inner && interior(middle[i], a.half[i]) && interior(in_b, b.half[i]);
  }
  return relation(inner ? -1 : 0, a, b);
}

}  // namespace isect::oracle::obb
