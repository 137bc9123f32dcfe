#pragma once
// How two boxes lie, from the definition: by looking at points, one in each cell that the ends of all sides make.

#include <array>

#include <isect/shapes.h>

namespace isect::oracle {

/// Twice the rank of each number: comparisons stay as they are, and odd numbers stand for what lies between two
/// neighbours.
template <class S, std::size_t K>
std::array<int, K> doubled_ranks(const std::array<S, K>& numbers) {
  std::array<int, K> rank = {};
  for (std::size_t j = 0; j < K; ++j)
    for (std::size_t k = 0; k < K; ++k) {
      bool first = true;  // among equal numbers
      for (std::size_t l = 0; l < k; ++l) first &= numbers[l] != numbers[k];
      rank[j] += first && numbers[k] < numbers[j] ? 2 : 0;
    }
  return rank;
}

/// The relation of the sets of points. Ends may be infinite, but not NaN.
template <class S, int N>
Relation by_points(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  std::array<std::array<int, 4>, N> ends;
  for (int i = 0; i < N; ++i) ends[i] = doubled_ranks<S, 4>({a.lo[i], a.hi[i], b.lo[i], b.hi[i]});

  bool common = false, interiors = false, a_alone = false, b_alone = false;
  int cells = 1;
  for (int i = 0; i < N; ++i) cells *= 7;  // three ends at most behind the first, and what lies between
  for (int cell = 0; cell < cells; ++cell) {
    bool in_a = true, in_b = true, inner = true;
    for (int i = 0, rest = cell; i < N; ++i, rest /= 7) {
      const int x = rest % 7;
      const auto& [a_lo, a_hi, b_lo, b_hi] = ends[i];
      in_a &= a_lo <= x && x <= a_hi;
      in_b &= b_lo <= x && x <= b_hi;
      const auto within = [x](int lo, int hi) { return lo == hi ? x == lo : lo < x && x < hi; };
      inner &= within(a_lo, a_hi) && within(b_lo, b_hi);
    }
    common |= in_a && in_b;
    interiors |= inner;
    a_alone |= in_a && !in_b;
    b_alone |= in_b && !in_a;
  }
  if (!common) return Relation::disjoint;
  if (!a_alone && !b_alone) return Relation::equal;
  if (!a_alone) return Relation::a_inside_b;
  if (!b_alone) return Relation::b_inside_a;
  return interiors ? Relation::overlapping : Relation::touching;
}

}  // namespace isect::oracle
