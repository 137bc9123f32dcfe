#pragma once
// All pairs of n axis-aligned boxes that have a common point, fast: near-equal boxes, or a few far larger ones among
// them.
//
// Boxes of similar size form a level. Each lies in one cell of its level's grid, that of its lower corner; cells are
// a little larger than the level's largest box, so two boxes of the level that meet lie in the same or adjacent
// cells. Only half of the neighbours are looked at, for each pair once. A box of a larger level looks at the cells of
// each smaller level from one before its lower corner's to its upper corner's.
//
// A level's boxes are stored cell by cell, rows of cells along x, so that a search is a few runs through memory:
//
//   slot of cell (x, y, z) = x + a y + b z  mod 2^k,    2^k >= twice the number of boxes.
//
// With a, b the row lengths of the grid that is the usual numbering. Where the grid has more cells than that, as
// boxes are few and far between, a and b scatter the rows over the slots: far cells share slots, but the 3^N around a
// cell do not. Boxes that meet by slot alone fail the comparison.
//
// Exact: comparisons of inputs decide; rounding only chooses cells. Same pairs as all_pairs::brute_force. Memory
// beside the list of pairs: at most 64 bytes a box for float in 3D, 80 for double. Time: O(n + pairs) unless boxes of
// one level crowd without meeting, as sticks in many directions do.
//
// Source: Teschner et al., Optimized spatial hashing for collision detection of deformable objects, VMV (2003);
// Mirtich, Impulse-based dynamic simulation (1996), for levels of size.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <isect/many/all_pairs.h>
#include <isect/parts/overlapping_pairs_level.h>

namespace isect {

namespace detail::overlapping_pairs {

/// The binary exponent of a box's size: 0 to 2046, 2047 where the size overflows.
template <class S, int N>
int octave(const Aabb<S, N>& box) {
  const Aabb<double, N> wide = cast<double>(box);
  const double size = (wide.hi - wide.lo).maxCoeff();
  return static_cast<int>(std::bit_cast<std::uint64_t>(size) >> 52 & 2047);
}

/// The level of each octave, 0 that of the largest boxes. A level spans two octaves, one where the next is far more
/// numerous, more where the rest are few.
inline std::vector<int> levels(const std::vector<int>& count) {
  std::vector<int> level(count.size(), 0);
  int rest = 0, inside = 0, top = 0, current = 0;
  for (const int c : count) rest += c;
  for (int o = static_cast<int>(count.size()) - 1; o >= 0; --o) {
    if (count[o] > 0) {
      if (inside == 0) top = o;
      const bool far = top - o >= 2 && rest > inside, many = top > o && rest / 8 > inside;
      if (far || many) top = o, inside = 0, ++current;
    }
    level[o] = current;
    inside += count[o], rest -= count[o];
  }
  return level;
}

}  // namespace detail::overlapping_pairs

/// Calls report(i, j), i < j, once for each two boxes that have a common point, in any order. Exact. A box that is
/// empty, NaN or infinite meets nothing.
template <class S, int N, class Report>
void overlapping_pairs(const std::vector<Aabb<S, N>>& boxes, Report&& report) {
  using namespace detail::overlapping_pairs;
  std::vector<int> members = all_pairs::detail::with_points(boxes);
  if (members.empty()) return;

  std::vector<int> count(2048, 0);
  double largest = 0;
  for (const int i : members) {
    ++count[octave(boxes[i])];
    largest = std::max({largest, double(boxes[i].lo.cwiseAbs().maxCoeff()), double(boxes[i].hi.cwiseAbs().maxCoeff())});
  }
  if (largest > 0x1p+1000 || largest < 0x1p-900) {  // cells would overflow or underflow
    all_pairs::sweep_and_prune(boxes, report);
    return;
  }

  const std::vector<int> level_of = levels(count);
  std::vector<int> sizes(level_of[0] + 1, 0);
  for (int o = 0; o < 2048; ++o) sizes[level_of[o]] += count[o];
  std::vector<std::vector<int>> of_level(sizes.size());
  for (std::size_t l = 0; l < sizes.size(); ++l) of_level[l].reserve(sizes[l]);
  for (const int i : members) of_level[level_of[octave(boxes[i])]].push_back(i);

  Pairs<std::remove_reference_t<Report>> pairs(report);
  for (std::size_t l = 0; l < of_level.size(); ++l) {
    const Level<S, N> level(boxes, of_level[l]);
    level.pairs_within(pairs);
    for (std::size_t larger = 0; larger < l; ++larger)
      for (const int box : of_level[larger]) level.pairs_with(box, pairs);
  }
  pairs.flush();
}

/// The pairs as a list.
template <class S, int N>
std::vector<IndexPair> overlapping_pairs(const std::vector<Aabb<S, N>>& boxes) {
  std::vector<IndexPair> pairs;
  overlapping_pairs(boxes, [&](int i, int j) { pairs.push_back({i, j}); });
  return pairs;
}

}  // namespace isect
