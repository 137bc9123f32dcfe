#pragma once
// The boxes of one size in the cells of a grid. isect/many/overlapping_pairs.h says how and why.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <isect/parts/overlapping_pairs_corners.h>

namespace isect {

namespace detail::overlapping_pairs {

/// Integer coordinates of cells.
template <int N>
using CellOf = std::array<int, N>;

/// The cells of a level, and their slots.
///
/// Adjacent cells. A coordinate x has the number floor(f), f the rounded (x - origin) / size <= 2^30, off by less
/// than 2^-20. Two boxes of the level that meet have lower ends at most one box apart, which is at most size / (1 +
/// 2^-9): their f differ by less than 1, their cells by at most 1.
template <int N>
struct Grid {
  Point<double, N> origin, last;  ///< of the lower corners
  Vector<double, N> inverse;      ///< 1 / size
  std::array<std::uint32_t, N> stride;
  std::uint32_t mask;
  bool scattered;  ///< whether far cells may share a slot

  template <class S>
  CellOf<N> cell(const Point<S, N>& p) const {
    CellOf<N> c;
    for (int i = 0; i < N; ++i) {
      const double x = std::min(std::max(double(p[i]), origin[i]), last[i]);
      c[i] = static_cast<int>((x - origin[i]) * inverse[i]);
    }
    return c;
  }
  std::uint32_t slot(const CellOf<N>& c) const {
    std::uint32_t sum = 0;
    for (int i = 0; i < N; ++i) sum += static_cast<std::uint32_t>(c[i]) * stride[i];
    return sum & mask;
  }
};

/// Slots for n boxes in cells of these sizes. Lower corners beyond origin or last count as if there.
template <int N>
Grid<N> make_grid(const Point<double, N>& origin, const Point<double, N>& last, const Vector<double, N>& size, int n) {
  Grid<N> grid = {origin, last, {}, {}, 0, false};
  double cells = 1;
  for (int i = 0; i < N; ++i) {
    grid.stride[i] = static_cast<std::uint32_t>(std::min(cells, 0x1p31));
    grid.inverse[i] = size[i] > 0x1p-1000 ? 1 / size[i] : 0;           // 0: a single cell
    cells *= std::floor((last[i] - origin[i]) * grid.inverse[i]) + 4;  // 3 to spare, so that rows do not run together
  }
  const std::uint32_t slots = std::bit_ceil(std::max(2u * static_cast<std::uint32_t>(n), 256u));
  grid.mask = slots - 1;
  grid.scattered = cells > slots;
  if (!grid.scattered) return grid;

  // Fractions whose multiples are spread evenly (Roberts, Quasirandom sequences, 2018). With these the 3^N cells
  // around a cell have slots of their own in a table of any size from 2^8 to 2^31: tests/core/many/all_pairs_test.cpp.
  constexpr double fraction[] = {0, 0.7548776662466927, 0.5698402909980532};
  for (int i = 1; i < N; ++i) grid.stride[i] = static_cast<std::uint32_t>(fraction[i] * slots) | 1;
  return grid;
}

/// The boxes of a level, cell by cell.
template <class S, int N>
class Level {
 public:
  Level(const std::vector<Aabb<S, N>>& boxes, const std::vector<int>& members) : boxes_(boxes) {
    const int n = static_cast<int>(members.size());
    Point<double, N> first = boxes[members[0]].lo.template cast<double>(), last = first;
    Vector<double, N> size = Vector<double, N>::Zero();
    for (const int i : members) {
      const Aabb<double, N> box = cast<double>(boxes[i]);
      first = first.cwiseMin(box.lo), last = last.cwiseMax(box.lo), size = size.cwiseMax(box.hi - box.lo);
    }
    const Vector<double, N> world = last - first, least = size * (1 + 0x1p-8);
    const Vector<double, N> even = least.cwiseMax(spacing(world, least, n)).cwiseMax(world * 0x1p-30);
    sort(members, make_grid<N>(first, last, even, n));
    if (crowding() <= 8.0 * n) return;

    // they are not spread evenly: the smallest cells, of which 2^30 lie around the middle of most boxes
    const Point<double, N> center = middle(members);
    for (int i = 0; i < N; ++i) {
      const double cell = least[i] > 0 ? least[i] : world[i] * 0x1p-30;
      first[i] = std::max(first[i], center[i] - cell * 0x1p+29),
      last[i] = std::min(last[i], center[i] + cell * 0x1p+29);
      size[i] = cell;
    }
    sort(members, make_grid<N>(first, last, size, n));
  }

  int size() const { return static_cast<int>(index_.size()) - 3; }

  /// Finds all pairs of the level.
  template <class Report>
  void pairs_within(Pairs<Report>& pairs) const {
    // the rows ahead, which run along x: (0, 1), or (0, 1, 0), (0, -1, 1), (0, 0, 1), (0, 1, 1)
    std::vector<std::uint32_t> rows = {grid_.stride[1]};
    if constexpr (N == 3)
      for (const std::uint32_t y : {-1u, 0u, 1u}) rows.push_back(y * grid_.stride[1] + grid_.stride[2]);

    for (std::uint32_t slot = 0; slot <= grid_.mask; ++slot) {
      const int begin = start_[slot], end = start_[slot + 1];
      if (begin == end) continue;
      const Runs two = runs(slot, 2);
      for (int k = begin; k < end; ++k) {
        Runs later = two;
        later[0].first = k + 1;
        look(pairs, index_[k], reach(corners_[k]), later);
      }
      for (const std::uint32_t row : rows) {
        const Runs three = runs(slot + row - 1, 3);
        if (three[0].first == three[0].second && three[1].first == three[1].second) continue;
        for (int k = begin; k < end; ++k) look(pairs, index_[k], reach(corners_[k]), three);
      }
    }
  }

  /// Finds all pairs of a box of another level, at least as large as this one's boxes, with the boxes of this one.
  template <class Report>
  void pairs_with(int box, Pairs<Report>& pairs) const {
    const Corners<S, N> reached = reach(corners(boxes_[box]));
    CellOf<N> lo = grid_.cell(boxes_[box].lo);
    const CellOf<N> hi = grid_.cell(boxes_[box].hi);
    for (int& c : lo) c = std::max(c - 1, 0);

    double rows = 1;
    for (int i = 1; i < N; ++i) rows *= 1.0 + hi[i] - lo[i];
    const std::uint32_t along = static_cast<std::uint32_t>(hi[0] - lo[0]) + 1;
    if (4 * rows > size() || along > grid_.mask) {
      pairs.test(box, reached, corners_.data(), index_.data(), 0, size());
      return;
    }
    for (CellOf<N> cell = lo; cell[N - 1] <= hi[N - 1];) {
      const Runs row = runs(grid_.slot(cell), along);
      if (!grid_.scattered) {
        look(pairs, box, reached, row);
      } else {
        const auto of_row = [&](int other) {
          const CellOf<N> c = grid_.cell(boxes_[other].lo);
          return std::equal(c.begin() + 1, c.end(), cell.begin() + 1);
        };
        for (const auto& [begin, end] : row)
          pairs.test(box, reached, corners_.data(), index_.data(), begin, end, of_row);
      }
      int i = 1;
      while (++cell[i] > hi[i] && i < N - 1) cell[i] = lo[i], ++i;
    }
  }

 private:
  /// Two runs of boxes from begin to end, as the slots are a ring.
  using Runs = std::array<std::pair<int, int>, 2>;

  /// Cell sizes for about one box a cell, if the boxes are spread evenly over the axes that are longer than a cell.
  static Vector<double, N> spacing(const Vector<double, N>& world, const Vector<double, N>& least, int n) {
    double log_volume = 0, axes = 0;
    for (int i = 0; i < N; ++i)
      if (world[i] > 2 * least[i]) log_volume += std::log(world[i]), ++axes;
    const double side = axes > 0 ? std::exp((log_volume - std::log(n)) / axes) : 0;
    Vector<double, N> size = Vector<double, N>::Zero();
    for (int i = 0; i < N; ++i)
      if (world[i] > 2 * least[i]) size[i] = side;
    return size;
  }

  /// The median lower corner of some of the boxes.
  Point<double, N> middle(const std::vector<int>& members) const {
    Point<double, N> center;
    for (int i = 0; i < N; ++i) {
      std::vector<S> some;
      for (std::size_t k = 0; k < members.size(); k += 1 + members.size() / 1024)
        some.push_back(boxes_[members[k]].lo[i]);
      std::nth_element(some.begin(), some.begin() + some.size() / 2, some.end());
      center[i] = double(some[some.size() / 2]);
    }
    return center;
  }

  /// Counting sort by slot.
  void sort(const std::vector<int>& members, const Grid<N>& grid) {
    grid_ = grid;
    start_.assign(std::size_t(grid.mask) + 2, 0);
    std::vector<std::uint32_t> slots(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
      slots[k] = grid.slot(grid.cell(boxes_[members[k]].lo));
      ++start_[slots[k]];
    }
    std::partial_sum(start_.begin(), start_.end(),
                     start_.begin());  // the end of each slot, until it is filled

    index_.assign(members.size() + 3, 0), corners_.resize(members.size() + 3);
    for (std::size_t k = members.size(); k-- > 0;) {
      const int place = --start_[slots[k]];
      index_[place] = members[k], corners_[place] = corners(boxes_[members[k]]);
    }
  }

  /// About twice the number of tests within cells.
  double crowding() const {
    double sum = 0;
    for (std::size_t slot = 0; slot <= grid_.mask; ++slot) {
      const double count = start_[slot + 1] - start_[slot];
      sum += count * count;
    }
    return sum;
  }

  /// The boxes of `count` slots from `slot` on.
  Runs runs(std::uint32_t slot, std::uint32_t count) const {
    const std::uint32_t first = slot & grid_.mask, end = first + count, all = grid_.mask + 1;
    if (end <= all) return {{{start_[first], start_[end]}, {0, 0}}};
    return {{{start_[first], start_[all]}, {0, start_[end - all]}}};
  }

  template <class Report>
  void look(Pairs<Report>& pairs, int box, const Corners<S, N>& reached, const Runs& runs) const {
    for (const auto& [begin, end] : runs) pairs.test(box, reached, corners_.data(), index_.data(), begin, end);
  }

  const std::vector<Aabb<S, N>>& boxes_;
  Grid<N> grid_;
  std::vector<int> start_;  ///< of each slot's boxes, in the next two; their number at the end
  std::vector<int> index_;  ///< 3 longer, as tests go by fours
  std::vector<Corners<S, N>> corners_;
};

}  // namespace detail::overlapping_pairs

}  // namespace isect
