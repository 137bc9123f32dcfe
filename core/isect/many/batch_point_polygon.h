#pragma once
// One polygon against many points: isect/point_polygon.h, whose answers these are. See isect/many/batch.h.
//
// An edge counts for a point only if it reaches the point's height and doesn't lie on its left. The box of a run of
// consecutive edges can rule out all of them at once; the boxes of all runs stand in columns. The edges of the other
// runs are walked. A run's length of sqrt(n) / 8 edges balances the two, by measurement.

#include <algorithm>
#include <cmath>

#include <isect/many/batch.h>
#include <isect/point_polygon.h>

namespace isect {

namespace batch {

namespace detail {

/// A few edges of a ring.
struct Run {
  std::size_t ring, first, last;
};

/// A polygon's runs, and the columns of their boxes.
template <class S>
struct Runs {
  std::vector<Run> runs;
  std::vector<S> low, high, right;

  explicit Runs(std::span<const Ring<S, 2>> rings) {
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      const std::size_t size = rings[ring].size();
      const std::size_t length = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(size)) / 8));
      for (std::size_t first = 0; first < size; first += length)
        add(rings[ring], {ring, first, std::min(first + length, size)});
    }
  }
  Columns<S, 3> columns() const { return {low.data(), high.data(), right.data()}; }

 private:
  void add(const Ring<S, 2>& vertices, const Run& run) {
    Point<S, 2> lo = vertices[run.last < vertices.size() ? run.last : 0], hi = lo;
    for (std::size_t i = run.first; i < run.last; ++i) lo = lo.cwiseMin(vertices[i]), hi = hi.cwiseMax(vertices[i]);
    runs.push_back(run);
    low.push_back(lo[1]), high.push_back(hi[1]), right.push_back(hi[0]);
  }
};

/// Whether a run lies above, below or on the left of p; always sure, as all numbers are finite.
template <class S>
struct MayCount {
  Point<S, 2> p;

  template <class V>
  [[gnu::always_inline]] void operator()(const std::array<V, 3>& run, FilterSigns<V>& f) const {
    f.no = run[0] - p[1];
    simd::raise(f.no, p[1] - run[1]);
    simd::raise(f.no, p[0] - run[2]);
    f.sure = f.no;
  }
};

/// Counts what the ray to the right from p meets of all rings.
template <class S>
point_polygon::Crossings crossings(const Point<S, 2>& p, std::span<const Ring<S, 2>> rings, const Runs<S>& runs,
                                   InstructionSet set) {
  const auto height = [&](const Point<S, 2>& v) { return (v[1] > p[1]) - (v[1] < p[1]); };
  const auto abscissa = [&](const Point<S, 2>& v) { return (v[0] > p[0]) - (v[0] < p[0]); };
  const auto side = [&](const Point<S, 2>& a, const Point<S, 2>& b) {
    return orient2d(a.template cast<double>(), b.template cast<double>(), p.template cast<double>());
  };
  point_polygon::Crossings sum;
  each_block<S>(runs.columns(), runs.runs.size(), set, MayCount<S>{p}, [&](std::size_t first, const Bits& bits) {
    for (std::uint64_t open = bits.yes; open != 0; open &= open - 1) {
      const Run& run = runs.runs[first + static_cast<std::size_t>(std::countr_zero(open))];
      const std::span<const Point<S, 2>> vertices(rings[run.ring]);
      const point_polygon::Crossings part =
          point_polygon::detail::walk(vertices, run.first, run.last, height, abscissa, side);
      sum.crossings += part.crossings, sum.winding += part.winding, sum.on |= part.on;
    }
  });
  return sum;
}

template <class S>
std::vector<Location> locate(const PointBatch<S, 2>& points, std::span<const Ring<S, 2>> rings, FillRule rule,
                             InstructionSet set) {
  std::vector<Location> where(points.size(), Location::out);
  if (!std::all_of(rings.begin(), rings.end(), [](const Ring<S, 2>& r) { return finite(r); })) return where;

  const Runs<S> runs(rings);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point<S, 2> p = points[i];
    if (!finite(p)) continue;
    const point_polygon::Crossings t = crossings(p, rings, runs, set);
    const bool inside = rule == FillRule::even_odd ? t.crossings % 2 != 0 : t.winding != 0;
    where[i] = t.on ? Location::on : inside ? Location::in : Location::out;
  }
  return where;
}

}  // namespace detail

}  // namespace batch

/// Entry i: locate(points[i], polygon, rule). Exact. `set` is one that the machine has.
template <class S>
std::vector<Location> locate(const PointBatch<S, 2>& points, const Polygon<S, 2>& polygon,
                             FillRule rule = FillRule::even_odd, InstructionSet set = widest()) {
  return batch::detail::locate(points, std::span<const Ring<S, 2>>(polygon.rings), rule, set);
}
template <class S>
std::vector<Location> locate(const PointBatch<S, 2>& points, const Ring<S, 2>& ring, FillRule rule = FillRule::even_odd,
                             InstructionSet set = widest()) {
  return batch::detail::locate(points, std::span<const Ring<S, 2>>(&ring, 1), rule, set);
}

}  // namespace isect
