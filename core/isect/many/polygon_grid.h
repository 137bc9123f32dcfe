#pragma once
// Point location by a grid: the fast way to ask many points of one polygon, whatever it looks like.
//
// Each cell knows the edges that touch it and the winding number at its lower left corner r. A point p of the cell is
// reached from r by going up to m = (r.x, p.y) and then right. Only the cell's own edges can cross that way, and each
// changes the winding number by one: up or down by the direction of the edge. Most cells of most polygons have no
// edge; there the corner answers.
//
//       m ------> p
//       |
//       r                    m has coordinates of r and of p: nothing is rounded, orient2d decides exactly.
//
// Where r or m lies on an edge, or level with a vertex, all three points are thought to be moved to the right by d,
// and up by much less than d. That is the half-open rule of point_polygon.h: on an edge counts as right of it, level
// with a vertex as above it. The left-most column begins left of the polygon, so there r and m are outside.
//
// The way works for any polygon, one that crosses itself too. A query costs O(1 + edges in its cell). The grid is as
// fine as 4 n cells and 12 n entries allow. Most cells of smooth polygons are empty, and those on their boundary
// hold O(sqrt n) edges; n long spikes leave O(n / 100) in every cell.
//
// Source: E. Haines, Point in polygon strategies, Graphics Gems IV (1994), for grids with corners.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include <isect/orient.h>
#include <isect/point_polygon.h>

namespace isect {

/// A polygon prepared for point location. `make_polygon_grid` makes it.
struct PolygonGrid {
  /// The lines of one axis. Cell i reaches from line i to line i + 1, without that; the last one for ever.
  struct Axis {
    double lo = 0, step = 0, per_step = 0;
    int cells = 1;

    double line(int i) const { return lo + i * step; }
    /// The last cell that begins at x or before; the first for x before all.
    int cell(double x) const {
      if (cells == 1) return 0;
      int i = std::clamp(static_cast<int>((x - lo) * per_step), 0, cells - 1);
      while (i > 0 && x < line(i)) --i;
      while (i + 1 < cells && x >= line(i + 1)) ++i;
      return i;
    }
  };
  struct Cell {
    std::uint32_t first;   ///< where its edges stand in `edges`
    std::int32_t winding;  ///< at its lower left corner
  };
  Axis axes[2];
  Point<double, 2> lo, hi;                 ///< the bounding box
  std::vector<Point<double, 2>> vertices;  ///< ring by ring, the first one repeated at the end
  std::vector<Cell> cells;                 ///< row by row, and one that ends the others
  std::vector<std::uint32_t> edges;        ///< of each cell, each the number of its first vertex

  std::size_t bytes() const {
    return vertices.size() * sizeof vertices[0] + cells.size() * sizeof(Cell) + edges.size() * sizeof edges[0];
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(axes[0].cells) + static_cast<std::size_t>(column);
  }
};

namespace polygon_grid {

/// The cell of the point, how many edges touch it, and the winding number at its corner.
struct CellFound {
  int column, row, edges, winding;
};
/// The way to the point crosses the edge that begins at this vertex.
struct Crossed {
  int vertex, change;
};
using Event = std::variant<CellFound, Crossed, Fallback>;

namespace detail {

/// What an edge adds to the winding number on the way from m to the right, to p at the same height; nothing when it
/// holds p. `m_x` is the x of m, or nothing when m lies left of all edges.
template <class Trace>
std::optional<int> rightwards(const Point<double, 2>& a, const Point<double, 2>& b, const double* m_x,
                              const Point<double, 2>& p, Trace&& trace) {
  const bool up = b[1] > p[1];
  if ((a[1] > p[1]) == up) {
    const bool level = a[1] == p[1] && b[1] == p[1];
    if (a == p || b == p || (level && (a[0] < p[0]) != (b[0] < p[0]))) return {};
    return 0;
  }
  if (a[0] > p[0] && b[0] > p[0]) return 0;
  if (m_x && a[0] < *m_x && b[0] < *m_x) return 0;

  const Point<double, 2>&lower = up ? a : b, &upper = up ? b : a;
  const int turn = orient2d(lower, upper, p, trace);
  if (turn == 0) return {};
  const bool p_left = turn > 0, m_left = !m_x || orient2d(lower, upper, Point<double, 2>(*m_x, p[1]), trace) > 0;
  return (p_left - m_left) * (up ? 1 : -1);
}

/// What an edge adds on the way to the next corner. A corner on the edge counts as right of it.
inline int corner_step(const Point<double, 2>& a, const Point<double, 2>& b, const double* from,
                       const Point<double, 2>& corner) {
  const bool up = b[1] > corner[1];
  if ((a[1] > corner[1]) == up) return 0;
  const Point<double, 2>&lower = up ? a : b, &upper = up ? b : a;
  const auto left = [&](const Point<double, 2>& q) { return orient2d(lower, upper, q) > 0; };
  return (left(corner) - (!from || left({*from, corner[1]}))) * (up ? 1 : -1);
}

/// What an edge adds on the way up from r to m, at the height `m_y`.
template <class Trace>
int upwards(const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& r, double m_y,
            Trace&& trace) {
  const bool right = b[0] > r[0];
  if ((a[0] > r[0]) == right) return 0;
  if ((a[1] > m_y && b[1] > m_y) || (a[1] < r[1] && b[1] < r[1])) return 0;

  const Point<double, 2>&first = right ? a : b, &last = right ? b : a;
  // a point on the edge moves to the right: below the edge iff that rises
  const auto above = [&](const Point<double, 2>& q) {
    const int turn = orient2d(first, last, q, trace);
    return turn != 0 ? turn > 0 : last[1] <= first[1];
  };
  return (above({r[0], m_y}) - above(r)) * (right ? 1 : -1);
}

/// Calls visit(column, row) for all cells that an edge touches, and perhaps for neighbours of them.
template <class Visit>
void touched(const PolygonGrid& grid, const Point<double, 2>& a, const Point<double, 2>& b, const Visit& visit) {
  const auto& [columns, rows] = grid.axes;
  const Point<double, 2>&lower = a[1] <= b[1] ? a : b, &upper = a[1] <= b[1] ? b : a;
  const double left = std::min(a[0], b[0]), right = std::max(a[0], b[0]);
  // x at a height, clamped to the edge, errs by 5 roundings of numbers up to 2 size
  const double size = std::max(std::abs(grid.lo[0]), std::abs(grid.hi[0])), slack = 0x1p-48 * size + 0x1p-1000;
  const Point<double, 2> extent = upper - lower;
  const auto x_at = [&](double y) { return lower[0] + (y - lower[1]) / extent[1] * extent[0]; };

  const int first_row = rows.cell(lower[1]), last_row = rows.cell(upper[1]);
  for (int row = first_row; row <= last_row; ++row) {
    double from = row == first_row ? lower[0] : x_at(rows.line(row)),
           to = row == last_row ? upper[0] : x_at(rows.line(row + 1));
    if (!std::isfinite(from) || !std::isfinite(to)) from = left, to = right;
    const int first = columns.cell(std::max(left, std::min(from, to)) - slack),
              last = columns.cell(std::min(right, std::max(from, to)) + slack);
    for (int column = first; column <= last; ++column) visit(column, row);
  }
}

/// Makes `wanted` cells, or fewer, so that none is thinner than a few representable numbers.
inline PolygonGrid::Axis axis(double lo, double hi, double wanted) {
  const double size = std::max(std::abs(lo), std::abs(hi)), most = (hi - lo) / (0x1p-46 * size);
  PolygonGrid::Axis axis;
  axis.lo = std::nextafter(lo, infinite<double>.lo);
  if (!(size < 0x1p996 && size > 0x1p-900 && std::min(most, wanted) >= 2)) return axis;
  axis.cells = static_cast<int>(std::min(most, wanted));
  axis.step = (hi - lo) / axis.cells;
  axis.per_step = 1 / axis.step;
  return axis;
}

/// Chooses cells of equal sides: 4 n or so, fewer where the edges would touch more than 12 n of them.
template <class Edges>
void choose_lines(PolygonGrid& grid, std::size_t n, const Edges& each_edge) {
  double wide = 0, high = 0;  // of all edges
  each_edge([&](std::uint32_t, const Point<double, 2>& a, const Point<double, 2>& b) {
    wide += std::abs(b[0] - a[0]), high += std::abs(b[1] - a[1]);
  });
  const Point<double, 2> extent = grid.hi - grid.lo;
  const double edges = static_cast<double>(n), area = extent[0] * extent[1];
  const double side = std::max(std::sqrt(area / (4 * (edges + 64))), (wide + high) / (11 * (edges + 64)));
  const bool usable = side > 0 && std::isfinite(side);
  for (int k = 0; k < 2; ++k)
    grid.axes[k] = axis(grid.lo[k], grid.hi[k], usable ? std::min(extent[k] / side, 0x1p15) : 1);
}

}  // namespace detail

}  // namespace polygon_grid

/// The grid of any polygon: see `winding`. Throws std::length_error for 2^31 vertices or more.
template <class S>
PolygonGrid make_polygon_grid(std::span<const Ring<S, 2>> rings) {
  using namespace polygon_grid;
  using namespace polygon_grid::detail;
  PolygonGrid grid;
  std::vector<std::uint32_t> ends;  // the repeated vertices, where no edge begins
  for (const Ring<S, 2>& ring : rings) {
    if (!finite(ring)) return {};
    if (ring.empty()) continue;
    for (const Point<S, 2>& v : ring) grid.vertices.push_back(v.template cast<double>());
    grid.vertices.push_back(ring[0].template cast<double>());
    if (grid.vertices.size() >= std::size_t{1} << 31) throw std::length_error("a polygon of 2^31 vertices or more");
    ends.push_back(static_cast<std::uint32_t>(grid.vertices.size()) - 1);
  }
  if (ends.empty()) return {};
  grid.lo = grid.hi = grid.vertices[0];
  for (const Point<double, 2>& v : grid.vertices) grid.lo = grid.lo.cwiseMin(v), grid.hi = grid.hi.cwiseMax(v);

  const auto each_edge = [&](const auto& visit) {
    std::uint32_t i = 0;
    for (const std::uint32_t end : ends) {
      for (; i < end; ++i) visit(i, grid.vertices[i], grid.vertices[i + 1]);
      ++i;
    }
  };
  choose_lines(grid, grid.vertices.size(), each_edge);

  const auto& [columns, rows] = grid.axes;
  grid.cells.resize(grid.index(0, rows.cells) + 1);
  each_edge([&](std::uint32_t, const auto& a, const auto& b) {
    touched(grid, a, b, [&](int column, int row) { ++grid.cells[grid.index(column, row)].first; });
  });
  std::uint64_t entries = 0;
  for (PolygonGrid::Cell& cell : grid.cells) {
    entries += cell.first;
    cell.first = static_cast<std::uint32_t>(entries);  // the end, until the cell is filled
  }
  if (entries >= std::uint64_t{1} << 32) throw std::length_error("a grid of 2^32 entries or more");
  grid.edges.resize(entries);
  each_edge([&](std::uint32_t i, const auto& a, const auto& b) {
    touched(grid, a, b, [&](int column, int row) { grid.edges[--grid.cells[grid.index(column, row)].first] = i; });
  });

  for (int row = 0; row < rows.cells; ++row)
    for (int column = 0, sum = 0; column < columns.cells; ++column) {
      PolygonGrid::Cell* cell = &grid.cells[grid.index(column, row)];
      cell->winding = sum;
      if (column + 1 == columns.cells) break;
      const double from = columns.line(column);
      const Point<double, 2> corner = {columns.line(column + 1), rows.line(row)};
      for (std::uint32_t k = cell[0].first; k < cell[1].first; ++k)
        sum += polygon_grid::detail::corner_step(grid.vertices[grid.edges[k]], grid.vertices[grid.edges[k] + 1],
                                                 column > 0 ? &from : nullptr, corner);
    }
  return grid;
}
template <class S>
PolygonGrid make_polygon_grid(const Polygon<S, 2>& polygon) {
  return make_polygon_grid(std::span<const Ring<S, 2>>(polygon.rings));
}
template <class S>
PolygonGrid make_polygon_grid(const Ring<S, 2>& ring) {
  return make_polygon_grid(std::span<const Ring<S, 2>>(&ring, 1));
}

/// How often the rings go around the point, counter-clockwise; nothing when it lies on the boundary. Exact, for rings
/// that cross too. A point with a NaN or infinite coordinate: 0; and so for all points when one of the rings has one.
template <class S, class Trace = NoTrace>
std::optional<int> winding(const Point<S, 2>& point, const PolygonGrid& grid, Trace&& trace = {}) {
  using namespace polygon_grid;
  using namespace polygon_grid::detail;
  if (grid.cells.empty()) return 0;
  const Point<double, 2> p = point.template cast<double>();
  const bool within = p[0] >= grid.lo[0] && p[0] <= grid.hi[0] && p[1] >= grid.lo[1] && p[1] <= grid.hi[1];
  if (!within) return 0;  // for NaN, too

  const auto& [columns, rows] = grid.axes;
  const int column = columns.cell(p[0]), row = rows.cell(p[1]);
  const PolygonGrid::Cell* cell = &grid.cells[grid.index(column, row)];
  int sum = cell->winding;
  trace(CellFound{column, row, static_cast<int>(cell[1].first - cell[0].first), sum});

  const Point<double, 2> r = {columns.line(column), rows.line(row)};
  for (std::uint32_t k = cell[0].first; k < cell[1].first; ++k) {
    const std::uint32_t i = grid.edges[k];
    const Point<double, 2>&a = grid.vertices[i], &b = grid.vertices[i + 1];
    const std::optional<int> right = rightwards(a, b, column > 0 ? &r[0] : nullptr, p, trace);
    if (!right) return {};
    const int up = column > 0 ? upwards(a, b, r, p[1], trace) : 0;
    sum += *right + up;
    if constexpr (heard<Trace>) {
      if (*right + up == 0) continue;
      trace(Crossed{static_cast<int>(i), *right + up});
    }
  }
  return sum;
}

/// Where the point lies. Otherwise as `winding`.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const PolygonGrid& grid, FillRule rule = FillRule::even_odd,
                Trace&& trace = {}) {
  const std::optional<int> w = winding(point, grid, trace);
  if (!w) return Location::on;
  return (rule == FillRule::even_odd ? *w % 2 != 0 : *w != 0) ? Location::in : Location::out;
}

}  // namespace isect
