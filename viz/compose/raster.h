#pragma once
// The outlines of equal cells in a raster.

#include <Eigen/Core>
#include <map>
#include <vector>

namespace isect::viz {

/// A corner of cells, columns to the right and rows down from the raster's own.
using Corner = Eigen::Vector2i;

/// Returns borders of cells that equal `wanted`, as closed rings without corners on a straight line, for the even-odd
/// rule: outer borders and holes. Cells that share only a corner share only a point. Cells come row by row.
template <class Look>
std::vector<std::vector<Corner>> outlines(const std::vector<Look>& cells, int columns, const Look& wanted) {
  const int rows = static_cast<int>(cells.size()) / columns;
  const auto inside = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < columns && y < rows && cells[y * columns + x] == wanted;
  };

  // Each border edge, with the cell on its right hand (y runs down). At most two leave a corner.
  const auto less = [](const Corner& a, const Corner& b) { return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x(); };
  std::map<Corner, std::vector<Corner>, decltype(less)> edges(less);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (!inside(x, y)) continue;
      if (!inside(x, y - 1)) edges[{x, y}].push_back({x + 1, y});
      if (!inside(x + 1, y)) edges[{x + 1, y}].push_back({x + 1, y + 1});
      if (!inside(x, y + 1)) edges[{x + 1, y + 1}].push_back({x, y + 1});
      if (!inside(x - 1, y)) edges[{x, y + 1}].push_back({x, y});
    }
  }

  std::vector<std::vector<Corner>> rings;
  while (!edges.empty()) {
    const Corner start = edges.begin()->first;
    std::vector<Corner> ring;
    Corner at = start, way = {0, 0};
    do {
      const auto found = edges.find(at);
      std::vector<Corner>& next = found->second;
      std::size_t chosen = 0;  // where two cells touch in a corner, turn right: stay with this cell
      for (std::size_t i = 0; i < next.size(); ++i) {
        const Corner turn = next[i] - at;
        if (way.x() * turn.y() - way.y() * turn.x() > 0) chosen = i;
      }
      const Corner to = next[chosen], step = to - at;
      next.erase(next.begin() + static_cast<std::ptrdiff_t>(chosen));
      if (next.empty()) edges.erase(found);
      if (step != way) ring.push_back(at);
      at = to, way = step;
    } while (at != start);
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace isect::viz
