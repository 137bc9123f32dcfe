#pragma once
// Point location by slabs: O(log n) for any polygon, after O(n^2) preparation.
//
// Horizontal lines through all vertices cut the plane into slabs. No edge begins, ends or crosses another within a
// slab, so those that run through it stand in one order from left to right. A point is located by two bisections: its
// y among the heights of the lines, then the point among the edges of its slab, by the side of an edge that it lies
// on. The winding number just left of each edge is known, and it is constant up to the edge before.
//
// A slab has its lower line and not its upper one. On the line itself lie vertices and horizontal edges, which no
// slab holds: they are looked up apart, in a third bisection, only for points on the line.
//
// The order in a slab is that of the slab below without the edges that end, and with those that begin put in their
// places: by orient2d, as are the points. The heights and abscissas of crossings, or of an edge's middle, would be
// rounded, and order close edges wrongly. As n/2 edges may run through n/2 slabs, the slabs may hold n^2/4 entries in
// all.
//
// Source: Dobkin, Lipton, Multidimensional searching problems, SIAM J. Comput. 5 (1976); Preparata, Shamos,
// Computational Geometry (1990), 2.2.2.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <isect/polygon_pieces.h>

namespace isect {

/// A polygon prepared for point location. `make_slab_map` makes it.
struct SlabMap {
  struct Edge {
    int lower, upper;  ///< its ends, as numbers of vertices
    int left;          ///< the winding number just left of it
    PolygonEdge source;
  };
  /// The points with bottom <= y < the bottom of the next one.
  struct Slab {
    double bottom;
    int vertex;         ///< the first vertex at this height
    std::size_t first;  ///< where its edges stand in `order`
  };
  std::vector<Point<double, 2>> vertices;  ///< distinct; by y, then by x
  std::vector<bool> joined;                ///< whether a horizontal edge leads from a vertex to the next one
  std::vector<Edge> edges;                 ///< those that are not horizontal, by their lower ends
  std::vector<Slab> slabs;                 ///< one for each height, and one without points that ends the others
  std::vector<std::int32_t> order;         ///< the edges of each slab, from left to right

  std::size_t bytes() const {
    return vertices.size() * sizeof vertices[0] + joined.size() / 8 + edges.size() * sizeof(Edge) +
           slabs.size() * sizeof(Slab) + order.size() * sizeof order[0];
  }
};

namespace slab_map {

/// The slab of the point, after so many comparisons of heights.
struct SlabFound {
  int slab, steps;
};
/// The point lies at the height of a line: whether on a vertex or a horizontal edge of it.
struct OnLine {
  int slab, steps;
  bool holds;
};
/// The point lies left (1) or right (-1) of an edge, or on it (0).
struct Compared {
  int edge, turn;
};
using Event = std::variant<SlabFound, OnLine, Compared, Fallback>;

/// The bisection behind `locate`: the first of lo, ..., hi - 1 with holds(i), or hi; those after it must hold too.
/// Counts its steps.
template <class Holds>
int bisect(int lo, int hi, int& steps, const Holds& holds) {
  for (steps = 0; lo < hi; ++steps) {
    const int mid = lo + (hi - lo) / 2;
    if (holds(mid))
      hi = mid;
    else
      lo = mid + 1;
  }
  return lo;
}

namespace detail {

template <class Trace>
int turn(const SlabMap& map, int edge, const Point<double, 2>& p, Trace&& trace) {
  const SlabMap::Edge& e = map.edges[edge];
  return orient2d(map.vertices[e.lower], map.vertices[e.upper], p, trace);
}

/// Whether a vertex or a horizontal edge at the height of the point holds it.
template <class Trace>
bool on_line(const SlabMap& map, int slab, const Point<double, 2>& p, Trace&& trace) {
  const int first = map.slabs[slab].vertex, last = map.slabs[static_cast<std::size_t>(slab) + 1].vertex;
  int steps = 0;
  const int right = bisect(first, last, steps, [&](int i) { return map.vertices[i][0] > p[0]; });
  const std::size_t left = static_cast<std::size_t>(right) - 1;
  const bool holds = right > first && (map.joined[left] || map.vertices[left][0] == p[0]);
  trace(OnLine{slab, steps, holds});
  return holds;
}

/// Takes over vertices and edges, by height.
inline void take(SlabMap& map, const PolygonPieces& boundary) {
  const std::vector<Point<double, 2>>& old = boundary.vertices;
  std::vector<std::int32_t> sorted(old.size()), number(old.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = static_cast<std::int32_t>(i);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](int a, int b) { return boundary.vertex(a)[1] < boundary.vertex(b)[1]; });
  for (const int i : sorted) {
    number[i] = static_cast<std::int32_t>(map.vertices.size());
    map.vertices.push_back(boundary.vertex(i));
  }

  map.joined.resize(old.size());
  for (const PolygonPieces::Piece& s : boundary.pieces) {
    const double rise = boundary.vertex(s.high)[1] - boundary.vertex(s.low)[1];
    const int low = number[s.low], high = number[s.high];
    if (rise > 0) map.edges.push_back({low, high, s.above, s.edge});
    if (rise < 0) map.edges.push_back({high, low, s.above - s.times, s.edge});
    if (rise == 0) map.joined[low] = true;
  }
  std::sort(map.edges.begin(), map.edges.end(), [](const auto& a, const auto& b) { return a.lower < b.lower; });
}

/// Puts the edges from, ..., to - 1, which begin in the last slab, in their places among those that run on through it,
/// from `first` in the order on. They are brought into their own order, then all of the slab is merged in one pass.
inline void put_in(SlabMap& map, std::size_t first, int from, int to) {
  const auto edge = [&](int e) -> const SlabMap::Edge& { return map.edges[e]; };
  const auto side = [&](int e, int v) { return turn(map, e, map.vertices[v], NoTrace{}); };
  std::vector<std::int32_t> begun;
  for (int e = from; e < to; ++e) begun.push_back(e);
  std::sort(begun.begin(), begun.end(), [&](int a, int b) {
    if (edge(a).lower != edge(b).lower) return edge(a).lower < edge(b).lower;
    return side(b, edge(a).upper) > 0;
  });

  std::size_t left = map.order.size(),
              place = left + begun.size();  // one past what is to be merged, and its place
  map.order.resize(place);
  const auto order = [&](std::size_t i) { return map.order.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t i = begun.size(); i > 0; --i) {
    const int e = begun[i - 1];
    const auto stays = std::partition_point(order(first), order(left), [&](int standing) {
      const int lower = side(standing, edge(e).lower);
      return (lower != 0 ? lower : side(standing, edge(e).upper)) < 0;
    });
    const std::size_t run = static_cast<std::size_t>(order(left) - stays);
    std::copy_backward(stays, order(left), order(place));
    left -= run, place -= run + 1;
    map.order[place] = e;
  }
}

}  // namespace detail

}  // namespace slab_map

/// The map of a boundary. Throws std::length_error when it would take more than `most_bytes`, before it takes them:
/// they bound the time, too.
inline SlabMap make_slab_map(const PolygonPieces& boundary, std::size_t most_bytes = std::size_t{1} << 30) {
  SlabMap map;
  slab_map::detail::take(map, boundary);

  std::vector<int> slab_of(map.vertices.size());
  for (std::size_t i = 0; i < map.vertices.size(); ++i) {
    const double y = map.vertices[i][1];
    if (map.slabs.empty() || y != map.slabs.back().bottom) map.slabs.push_back({y, static_cast<int>(i), 0});
    slab_of[i] = static_cast<int>(map.slabs.size()) - 1;
  }
  const auto slab = [&](int vertex) { return slab_of[vertex]; };
  std::size_t entries = 0;
  for (const SlabMap::Edge& e : map.edges) entries += static_cast<std::size_t>(slab(e.upper) - slab(e.lower));
  const std::size_t bytes = map.bytes() + sizeof(SlabMap::Slab) * !map.slabs.empty() + entries * sizeof map.order[0];
  if (bytes > most_bytes)
    throw std::length_error("the slabs would take " + std::to_string(bytes) + " bytes, the limit is " +
                            std::to_string(most_bytes));

  map.order.reserve(entries);
  std::size_t below = 0;  // where the edges of the slab below stand
  for (int s = 0, begun = 0; s < static_cast<int>(map.slabs.size()); ++s) {
    const std::size_t first = map.slabs[s].first = map.order.size();
    for (; below < first; ++below)
      if (const int e = map.order[below]; slab(map.edges[e].upper) != s) map.order.push_back(e);

    const int from = begun;
    while (begun < static_cast<int>(map.edges.size()) && slab(map.edges[begun].lower) == s) ++begun;
    slab_map::detail::put_in(map, first, from, begun);
  }
  if (!map.slabs.empty())
    map.slabs.push_back({infinite<double>.hi, static_cast<int>(map.vertices.size()), map.order.size()});
  return map;
}
/// The map of a polygon. Throws std::invalid_argument that names two edges that cross where there is no vertex (a
/// bow-tie): see make_polygon_pieces. Any other polygon will do: several rings, of any orientation, with repeated
/// vertices, spikes, and edges that touch or coincide.
template <class S>
SlabMap make_slab_map(std::span<const Ring<S, 2>> rings, std::size_t most_bytes = std::size_t{1} << 30) {
  return make_slab_map(make_polygon_pieces(rings), most_bytes);
}
template <class S>
SlabMap make_slab_map(const Polygon<S, 2>& polygon, std::size_t most_bytes = std::size_t{1} << 30) {
  return make_slab_map(std::span<const Ring<S, 2>>(polygon.rings), most_bytes);
}
template <class S>
SlabMap make_slab_map(const Ring<S, 2>& ring, std::size_t most_bytes = std::size_t{1} << 30) {
  return make_slab_map(std::span<const Ring<S, 2>>(&ring, 1), most_bytes);
}

/// How often the rings go around the point, counter-clockwise; nothing when it lies on the boundary. Exact, in at
/// most 3 (1 + lg n) comparisons, a third of them orientations. A point with a NaN or infinite coordinate: 0.
template <class S, class Trace = NoTrace>
std::optional<int> winding(const Point<S, 2>& point, const SlabMap& map, Trace&& trace = {}) {
  using namespace slab_map;
  using namespace slab_map::detail;
  if (!finite(point) || map.slabs.empty()) return 0;
  const Point<double, 2> p = point.template cast<double>();

  int steps = 0;
  const int slab =
      bisect(0, static_cast<int>(map.slabs.size()), steps, [&](int i) { return map.slabs[i].bottom > p[1]; }) - 1;
  trace(SlabFound{slab, steps});
  if (slab < 0) return 0;
  const SlabMap::Slab &found = map.slabs[slab], &next = map.slabs[static_cast<std::size_t>(slab) + 1];
  if (p[1] == found.bottom && on_line(map, slab, p, trace)) return {};

  std::size_t lo = found.first, hi = next.first;
  while (lo < hi) {
    const std::size_t mid = lo + (hi - lo) / 2;
    const int edge = map.order[mid], side = turn(map, edge, p, trace);
    trace(Compared{edge, side});
    if (side == 0) return {};
    if (side > 0)
      hi = mid;
    else
      lo = mid + 1;
  }
  return lo < next.first ? map.edges[map.order[lo]].left : 0;
}

/// Where the point lies. Otherwise as `winding`.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const SlabMap& map, FillRule rule = FillRule::even_odd, Trace&& trace = {}) {
  return location(winding(point, map, trace), rule);
}

}  // namespace isect
