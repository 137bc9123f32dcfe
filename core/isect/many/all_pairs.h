#pragma once
// All pairs of n axis-aligned boxes that have a common point: three ways to find them, for reading and counting.
//
// Brute force tests every pair: n (n - 1) / 2 tests. The note's loop lets j run from i, which tests each box with
// itself. It must start at i + 1.
//
// Sweep and prune sorts the boxes by their lower ends along one axis. A plane that sweeps along it holds the boxes
// that it cuts; one that begins can meet only these, as the others have ended before, or begin later.
//
// A grid tests only boxes that share a cell. Two boxes may share many cells; the pair counts in the one cell that has
// the lower corner of their common box, max(lo): it lies in both boxes, and so in a cell of both. Boxes that would
// cover too many cells are swept instead.
//
// All find the same pairs, each once, i < j, each method in its own order, and return the number of tests. Exact: only
// comparisons of inputs decide. A box that is empty, NaN or infinite meets nothing. For speed take overlapping_pairs
// (isect/many/overlapping_pairs.h). Source: the note, N25 (corrected), N03, N09; Cohen, Lin, Manocha, Ponamgi,
// I-COLLIDE, Symposium on Interactive 3D Graphics (1995).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/parts/index_pair.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace all_pairs {

/// Every method: a pair of boxes compared.
struct Tested {
  int i, j;
  bool overlap;
};
/// sweep_and_prune: the axis swept along.
struct Axis {
  int axis;
};
/// sweep_and_prune: the plane reaches the lower end of a box, or it has passed the upper end.
struct Enters {
  int box;
};
struct Leaves {
  int box;
};
/// grid: the boxes in one cell. The first cell is (0, 0, 0).
template <int N>
struct Cell {
  std::array<int, N> at;
  std::vector<int> boxes;
};
template <int N>
using Event = std::variant<Tested, Axis, Enters, Leaves, Cell<N>>;

namespace detail {

/// The boxes that have a point and finite coordinates, in order.
template <class S, int N>
std::vector<int> with_points(const std::vector<Aabb<S, N>>& boxes) {
  std::vector<int> members;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (!empty(boxes[i]) && finite(boxes[i])) members.push_back(i);
  return members;
}

/// Tests one pair, and reports it if it meets.
template <class S, int N, class Report, class Trace>
void test(const std::vector<Aabb<S, N>>& boxes, int i, int j, Report&& report, Trace&& trace) {
  if (i > j) std::swap(i, j);
  const bool overlap = intersects(boxes[i], boxes[j]);
  trace(Tested{i, j, overlap});
  if (overlap) report(i, j);
}

/// The axis along which the centers have the largest variance. A guess: rounding and overflow do no harm.
template <class S, int N>
int widest_axis(const std::vector<Aabb<S, N>>& boxes, const std::vector<int>& members) {
  Vector<double, N> mean = Vector<double, N>::Zero(), variance = Vector<double, N>::Zero();
  double count = 0;
  for (const int i : members) {  // Welford's update
    const Aabb<double, N> box = cast<double>(boxes[i]);
    const Vector<double, N> step = box.lo / 2 + box.hi / 2 - mean;
    mean += step / ++count;
    variance += step.cwiseProduct(box.lo / 2 + box.hi / 2 - mean);
  }
  int widest = 0;
  for (int axis = 1; axis < N; ++axis)
    if (variance[axis] > variance[widest]) widest = axis;
  return widest;
}

/// Sweeps over the members and tests the pairs with at least one large box.
template <class S, int N, class Large, class Report, class Trace>
std::int64_t sweep(const std::vector<Aabb<S, N>>& boxes, std::vector<int> members, const Large& large, Report&& report,
                   Trace&& trace) {
  const int axis = widest_axis(boxes, members);
  trace(Axis{axis});
  std::sort(members.begin(), members.end(), [&](int i, int j) { return boxes[i].lo[axis] < boxes[j].lo[axis]; });

  std::int64_t tests = 0;
  std::vector<int> cut_large, cut_small;  // by the plane
  const auto meet = [&](std::vector<int>& cut, int box) {
    std::erase_if(cut, [&](int other) {
      if (boxes[other].hi[axis] >= boxes[box].lo[axis]) return false;
      trace(Leaves{other});
      return true;
    });
    for (const int other : cut) {
      ++tests;
      test(boxes, other, box, report, trace);
    }
  };
  for (const int box : members) {
    trace(Enters{box});
    meet(cut_large, box);
    if (large(box)) meet(cut_small, box);
    (large(box) ? cut_large : cut_small).push_back(box);
  }
  return tests;
}

/// Numbers the cells of a uniform grid. Lengths are halved, so that none overflows; larger coordinates never get
/// smaller numbers, as every rounded step keeps the order: that is all that the grid relies on.
template <int N>
struct Cells {
  Point<double, N> half_origin;
  double half_size;

  template <class S>
  std::array<int, N> operator()(const Point<S, N>& p) const {
    std::array<int, N> cell;
    for (int i = 0; i < N; ++i) cell[i] = static_cast<int>((double(p[i]) / 2 - half_origin[i]) / half_size);
    return cell;
  }
};

/// Returns cells of the median box's size, at least a 2^-30th of the widest extent of all: so int can number them.
template <class S, int N>
Cells<N> cells(const std::vector<Aabb<S, N>>& boxes, const std::vector<int>& members) {
  Aabb<double, N> all = cast<double>(boxes[members[0]]);
  std::vector<double> sizes;
  for (const int i : members) {
    const Aabb<double, N> box = cast<double>(boxes[i]);
    all = {all.lo.cwiseMin(box.lo), all.hi.cwiseMax(box.hi)};
    sizes.push_back((box.hi / 2 - box.lo / 2).maxCoeff());
  }
  std::nth_element(sizes.begin(), sizes.begin() + sizes.size() / 2, sizes.end());
  const double least = (all.hi / 2 - all.lo / 2).maxCoeff() * 0x1p-30;
  return {all.lo / 2, std::max({sizes[sizes.size() / 2], least, std::numeric_limits<double>::denorm_min()})};
}

}  // namespace detail

/// Tests every pair: n (n - 1) / 2 tests.
template <class S, int N, class Report, class Trace = NoTrace>
std::int64_t brute_force(const std::vector<Aabb<S, N>>& boxes, Report&& report, Trace&& trace = {}) {
  std::int64_t tests = 0;
  const int n = static_cast<int>(boxes.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      ++tests;
      detail::test(boxes, i, j, report, trace);
    }
  return tests;
}

/// Sweeps along the axis on which the boxes are spread most.
template <class S, int N, class Report, class Trace = NoTrace>
std::int64_t sweep_and_prune(const std::vector<Aabb<S, N>>& boxes, Report&& report, Trace&& trace = {}) {
  return detail::sweep(
      boxes, detail::with_points(boxes), [](int) { return true; }, report, trace);
}

/// Tests pairs in cells of the median box's size. Memory: 4 (N + 1) bytes for each cell that a box covers, at most 3^N.
template <class S, int N, class Report, class Trace = NoTrace>
std::int64_t grid(const std::vector<Aabb<S, N>>& boxes, Report&& report, Trace&& trace = {}) {
  const std::vector<int> members = detail::with_points(boxes);
  if (members.empty()) return 0;
  const detail::Cells<N> cell_of = detail::cells(boxes, members);

  struct Entry {
    std::array<int, N> cell;
    int box;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  std::vector<char> large(boxes.size(), 0);
  for (const int box : members) {
    const std::array<int, N> first = cell_of(boxes[box].lo), last = cell_of(boxes[box].hi);
    for (int i = 0; i < N; ++i) large[box] |= last[i] - first[i] > 2;
    if (large[box]) continue;
    for (std::array<int, N> cell = first;;) {
      entries.push_back({cell, box});
      int i = 0;
      while (i < N && ++cell[i] > last[i]) cell[i] = first[i], ++i;  // counts like an odometer
      if (i == N) break;
    }
  }
  std::sort(entries.begin(), entries.end());

  std::int64_t tests = 0;
  for (auto begin = entries.begin(), end = begin; begin != entries.end(); begin = end) {
    end = std::find_if(begin, entries.end(), [&](const Entry& e) { return e.cell != begin->cell; });
    if constexpr (heard<Trace>) {
      std::vector<int> inside;
      for (auto e = begin; e != end; ++e) inside.push_back(e->box);
      trace(Cell<N>{begin->cell, inside});
    }
    for (auto a = begin; a != end; ++a)
      for (auto b = a + 1; b != end; ++b) {
        const Point<S, N> corner = boxes[a->box].lo.cwiseMax(boxes[b->box].lo);
        if (cell_of(corner) != begin->cell) continue;  // the pair of another cell
        ++tests;
        detail::test(boxes, a->box, b->box, report, trace);
      }
  }

  if (std::find(large.begin(), large.end(), 1) == large.end()) return tests;
  return tests + detail::sweep(
                     boxes, members, [&](int box) { return large[box] != 0; }, report, trace);
}

}  // namespace all_pairs

}  // namespace isect
