#pragma once
// Point location by slabs as it is usually written: edges are ordered, and points compared with them, by the abscissas
// of edges at a height, in plain floating point. What is taught and compared; `locate` of isect/many/slab_map.h is
// right for all input, and orders by orientations.
//
// Naive: edges closer than roundoff are put in the wrong order, or in none; and a point near an edge may be put on its
// other side. On the boundary: anything. The polygon must be simple; no more than a few thousand vertices, as the slabs
// may hold n^2/4 edges.

#include <algorithm>
#include <variant>
#include <vector>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect::slab_map {

/// How the abscissa of an edge at a height is found.
enum class Abscissa {
  line,         ///< x = m y + k, with m and k computed once
  interpolated  ///< from the lower end, by the share of the height
};

/// The slab of the point. The lowest is 0; -1 below all, and the last one above all has no edges.
struct NaiveSlabFound {
  int slab;
};
/// The abscissa of an edge of the slab at the height of the point, and whether it lies left of the point.
template <class S>
struct AbscissaCompared {
  int edge;
  S x;
  bool left;
};
template <class S>
using NaiveEvent = std::variant<NaiveSlabFound, AbscissaCompared<S>>;

/// A polygon cut into slabs at the heights of its vertices.
template <class S>
struct NaiveSlabs {
  struct Edge {
    Point<S, 2> lower, upper;
    S m, k;  ///< x = m y + k

    S at(S y, Abscissa as) const {
      if (as == Abscissa::line) return m * y + k;
      return lower[0] + (y - lower[1]) * (upper[0] - lower[0]) / (upper[1] - lower[1]);
    }
  };
  Abscissa form;
  std::vector<S> heights;               ///< ascending; slab i lies between heights i and i + 1
  std::vector<Edge> edges;              ///< without horizontal ones
  std::vector<std::vector<int>> slabs;  ///< the edges of each from left to right, by their abscissas in its middle
};

template <class S>
NaiveSlabs<S> make_naive_slabs(const Ring<S, 2>& ring, Abscissa form) {
  NaiveSlabs<S> map = {form, {}, {}, {}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    map.heights.push_back(a[1]);
    if (a[1] == b[1]) continue;
    const Point<S, 2>&lower = a[1] < b[1] ? a : b, &upper = a[1] < b[1] ? b : a;
    const S m = (upper[0] - lower[0]) / (upper[1] - lower[1]);
    map.edges.push_back({lower, upper, m, lower[0] - m * lower[1]});
  }
  std::sort(map.heights.begin(), map.heights.end());
  map.heights.erase(std::unique(map.heights.begin(), map.heights.end()), map.heights.end());

  map.slabs.resize(map.heights.size());
  for (std::size_t s = 0; s + 1 < map.heights.size(); ++s) {
    const S middle = map.heights[s] / S(2) + map.heights[s + 1] / S(2);
    std::vector<std::pair<S, int>> order;
    for (std::size_t e = 0; e < map.edges.size(); ++e)
      if (map.edges[e].lower[1] <= map.heights[s] && map.heights[s + 1] <= map.edges[e].upper[1])
        order.emplace_back(map.edges[e].at(middle, form), static_cast<int>(e));
    std::sort(order.begin(), order.end());
    for (const auto& [x, e] : order) map.slabs[s].push_back(e);
  }
  return map;
}

/// Whether the polygon holds the point. Two bisections. Source: the note, N24; Preparata, Shamos, Computational
/// Geometry (1990), 2.2.2.
template <class S, class Trace = NoTrace>
bool slabs_naive(const Point<S, 2>& p, const NaiveSlabs<S>& map, Trace&& trace = {}) {
  const auto above = std::upper_bound(map.heights.begin(), map.heights.end(), p[1]);
  const int slab = static_cast<int>(above - map.heights.begin()) - 1;
  trace(NaiveSlabFound{slab});
  if (slab < 0) return false;

  const std::vector<int>& order = map.slabs[slab];
  std::size_t lo = 0, hi = order.size();
  while (lo < hi) {
    const std::size_t mid = lo + (hi - lo) / 2;
    const S x = map.edges[order[mid]].at(p[1], map.form);
    const bool left = x < p[0];
    trace(AbscissaCompared<S>{order[mid], x, left});
    if (left)
      lo = mid + 1;
    else
      hi = mid;
  }
  return lo % 2 != 0;  // each edge left of the point is a crossing
}

}  // namespace isect::slab_map
