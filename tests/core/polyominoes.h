#pragma once
// Polygons of unit squares, anywhere in space: how two of them lie is counted in squares, with no geometry at all.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include <isect/half_spaces.h>
#include <isect/shapes.h>

#include "bench/random.h"

namespace isect::tests {

using Square = std::array<int, 2>;
using Squares = std::set<Square>;

/// The outline of squares, counter-clockwise, with each point of the grid that it passes; empty where they are not
/// simply connected by their sides, or meet at a corner alone.
inline std::vector<Square> outline_of(const Squares& squares) {
  std::map<Square, Square> next;
  for (const auto& [x, y] : squares) {
    const std::array<Square, 4> corner = {Square{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    const std::array<Square, 4> beyond = {Square{x, y - 1}, {x + 1, y}, {x, y + 1}, {x - 1, y}};
    for (std::size_t i = 0; i < 4; ++i)
      if (!squares.contains(beyond[i]) && !next.emplace(corner[i], corner[(i + 1) % 4]).second) return {};
  }
  std::vector<Square> ring = {next.begin()->first};
  while (ring.size() <= next.size() && next.at(ring.back()) != ring.front()) ring.push_back(next.at(ring.back()));
  return ring.size() == next.size() ? ring : std::vector<Square>();
}

/// Some of the squares from (0, 0) to (n, n).
inline Squares random_squares(bench::Random& random, int n) {
  for (;;) {
    Squares squares;
    Square at = {random.below(n), random.below(n)};
    for (int steps = random.integer(1, 3 * n); steps > 0; --steps) {
      squares.insert(at);
      at[static_cast<std::size_t>(random.below(2))] += random.one_in(2) ? 1 : -1;
      for (int& x : at) x = std::clamp(x, 0, n - 1);
    }
    if (!outline_of(squares).empty()) return squares;
  }
}

/// The location of (x, y).
inline Location locate(double x, double y, const Squares& squares) {
  int around = 0, held = 0;
  for (int i = -1; i <= static_cast<int>(x) + 1; ++i)
    for (int k = -1; k <= static_cast<int>(y) + 1; ++k) {
      if (x < i || x > i + 1 || y < k || y > k + 1) continue;
      ++around, held += squares.contains({i, k});
    }
  return held == 0 ? Location::out : held == around ? Location::in : Location::on;
}

/// Where such squares lie in space: whole numbers times a power of two.
struct Frame {
  Vector<double, 3> origin;
  std::array<Vector<double, 3>, 3> axes;
  double unit;

  static Frame draw(bench::Random& random) {
    using Vec3 = Vector<double, 3>;
    Frame f = {Vec3(random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)), {}, 1};
    const int pose = random.below(3);
    if (pose == 0)
      f.axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    else if (pose == 1)
      f.axes = {Vec3(0, 2, 1), Vec3(-1, 0, 0), Vec3(1, 1, 3)};
    else
      f.axes = {Vec3(3, -1, 2), Vec3(1, 4, -2), Vec3(0, 1, 1)};
    if (random.one_in(3)) std::swap(f.axes[0], f.axes[1]);
    if (random.one_in(3)) f.unit = random.one_in(2) ? 0x1p-1040 : 0x1p1000;
    return f;
  }
  Vector<double, 3> at(double x, double y, double z = 0) const {
    return unit * (origin + x * axes[0] + y * axes[1] + z * axes[2]);
  }
  /// The box from lo to hi along the axes.
  HalfSpaces box(const std::array<double, 3>& lo, const std::array<double, 3>& hi) const {
    const bool left = axes[0].cross(axes[1]).dot(axes[2]) < 0;
    HalfSpaces solid;
    for (std::size_t i = 0; i < 3; ++i)
      for (const bool up : {false, true}) {
        const std::array<double, 3>& from = up ? hi : lo;
        const auto beside = [&](std::size_t k) {
          std::array<double, 3> x = from;
          ++x[k];
          return at(x[0], x[1], x[2]);
        };
        solid.faces.push_back(
            {half_spaces::Behind{at(from[0], from[1], from[2]), beside((i + 1) % 3), beside((i + 2) % 3)}, up == left});
      }
    return solid;
  }
};

/// An outline in the plane of a frame's first two axes, or of others; it may have points within its sides, repeat
/// corners, and run clockwise.
inline Ring<double, 3> outline_in(const Frame& frame, const Squares& squares, bench::Random& random) {
  const std::vector<Square> ring = outline_of(squares);
  const std::size_t n = ring.size();
  Ring<double, 3> all;
  for (std::size_t i = 0; i < n; ++i) {
    const Square &before = ring[(i + n - 1) % n], &p = ring[i], &after = ring[(i + 1) % n];
    const bool straight = after[0] - p[0] == p[0] - before[0] && after[1] - p[1] == p[1] - before[1];
    if (straight && random.one_in(2)) continue;
    for (int times = random.one_in(9) ? 2 : 1; times > 0; --times) all.push_back(frame.at(p[0], p[1]));
  }
  std::rotate(all.begin(), all.begin() + random.below(static_cast<int>(all.size())), all.end());
  if (random.one_in(2)) std::ranges::reverse(all);
  return all;
}

}  // namespace isect::tests
