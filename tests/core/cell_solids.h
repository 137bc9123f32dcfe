#pragma once
// Solids of cubic cells on the integer grid: how two of them lie is counted in cells, with no geometry at all. Their
// surfaces touch along faces, edges and at corners more often than not.

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <isect/triangle_mesh.h>

#include "bench/random.h"

namespace isect::tests {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

/// Some of the cells of a cube's grid, of `size` unit cells a side each.
inline Cells random_cells(bench::Random& random, int count, int size, const Cell& from) {
  Cells cells;
  const int one_in = random.integer(1, 4);
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y)
      for (int z = 0; z < count; ++z) {
        if (!random.one_in(one_in)) continue;
        for (int i = 0; i < size * size * size; ++i)
          cells.insert({from[0] + x * size + i % size, from[1] + y * size + i / size % size,
                        from[2] + z * size + i / size / size});
      }
  return cells;
}

/// How two closed solids of cells lie; an empty one is disjoint from all.
inline Relation relation(const Cells& a, const Cells& b) {
  const auto holds = [](const Cells& outer, const Cells& inner) {
    return std::ranges::all_of(inner, [&](const Cell& c) { return outer.contains(c); });
  };
  if (a.empty() || b.empty()) return Relation::disjoint;
  const bool b_in_a = holds(a, b), a_in_b = holds(b, a);
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b) return Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  bool touch = false;
  for (const Cell& c : a) {
    if (b.contains(c)) return Relation::overlapping;
    for (int i = 0; i < 27; ++i) touch |= b.contains({c[0] + i % 3 - 1, c[1] + i / 3 % 3 - 1, c[2] + i / 9 - 1});
  }
  return touch ? Relation::touching : Relation::disjoint;
}

/// The faces between cells of the solid and others, each of two triangles, over squares of `size`, which cells of that
/// size make up; in any order and turned in any way, if `tidy` is false.
inline TriangleMesh<double> surface_of(const Cells& cells, int size, const Cell& from, bench::Random& random,
                                       bool tidy = false) {
  TriangleMesh<double> mesh;
  std::map<Cell, int> known;
  const auto vertex = [&](const Cell& c) {
    const auto [found, is_new] = known.try_emplace(c, static_cast<int>(known.size()));
    if (is_new) mesh.vertices.emplace_back(c[0], c[1], c[2]);
    return found->second;
  };
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int up = 0; up < 2; ++up) {
        Cell beyond = cell;
        beyond[axis] += up ? 1 : -1;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (cells.contains(beyond) || (cell[u] - from[u]) % size != 0 || (cell[v] - from[v]) % size != 0) continue;
        Cell at = cell;
        at[axis] += up;
        std::array<int, 4> corner;
        for (int i = 0; i < 4; ++i) {
          Cell c = at;
          c[u] += size * (i == 1 || i == 2), c[v] += size * (i >= 2);
          corner[i] = vertex(c);
        }
        if (!up) std::swap(corner[1], corner[3]);  // counter-clockwise seen from outside
        std::rotate(corner.begin(), corner.begin() + random.below(4), corner.end());
        for (std::array<int, 3> t : {std::array{corner[0], corner[1], corner[2]}, {corner[0], corner[2], corner[3]}}) {
          if (!tidy && random.one_in(2)) std::swap(t[0], t[1]);
          mesh.triangles.push_back(t);
        }
      }
  if (!tidy)
    for (std::size_t i = mesh.triangles.size(); i > 1; --i)
      std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(static_cast<int>(i))]);
  return mesh;
}

/// The vertices in another frame: sheared and scaled so that no number is rounded.
inline void move(TriangleMesh<double>& mesh, const Eigen::Matrix3d& frame) {
  for (Point<double, 3>& v : mesh.vertices) v = frame * v;
}

}  // namespace isect::tests
