#pragma once
// The first pass of isect/triangle_aabb.h: the classical test in plain doubles, with a proved margin. Source:
// Akenine-Moller, Fast 3D triangle-box overlap testing, J. Graphics Tools 6 (2001), for the test.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <isect/numbers/arithmetic.h>
#include <isect/shapes.h>

namespace isect {

namespace triangle_aabb {

namespace detail {

/// How far an axis is from separating: the triangle reaches from lo to hi along it, the box to `radius` either side.
inline double gap(double lo, double hi, double radius) { return std::max(lo, -hi) - radius; }

/// The verdicts that plain doubles settle.
struct FirstPass {
  std::optional<int> sign;  ///< 1: some axis separates; -1: along all of them the shapes overlap; else some are open
  unsigned open = ~0u;      ///< bit i: axis i of all_axes may yet separate or touch
};

/// Runs the first pass on finite numbers; the box is not empty.
///
/// Margin. With center c and half-lengths h as rounded, let v be the vertices from c, q the sum over the axes of |c_i|,
/// h_i and the largest |v_i|, and f that of the triangle's extents, and 4 u q. c is off by at most u q, h by u q, each
/// v_i by 2 u q, each edge component by a relative u. The extents of the rounded v are those of the triangle up to 2 u
/// q, so f is at least the sum of the components of any edge. So gaps along the box's normals are off by at most 5 u q,
/// along products with an edge by 14 u f q, along the triangle's normal, whose components are at most f^2 / 2 and off
/// by 8 u f^2, by 60 u f^2 q. As f >= 4 u q, nothing overflows or underflows but what is negligible within the range
/// asked for. Products that vanish say nothing; their components are exactly 0.
template <int N>
FirstPass first_pass(const Triangle<double, N>& triangle, const Aabb<double, N>& box) {
  const Vector<double, N> center = 0.5 * (box.lo + box.hi), half = 0.5 * (box.hi - box.lo);
  std::array<Vector<double, N>, 3> v, edges;
  for (int k = 0; k < 3; ++k)
    v[k] = triangle.vertices[k] - center, edges[k] = triangle.vertices[(k + 1) % 3] - triangle.vertices[k];
  const Vector<double, N> lo = v[0].cwiseMin(v[1]).cwiseMin(v[2]), hi = v[0].cwiseMax(v[1]).cwiseMax(v[2]);
  const double q = center.cwiseAbs().sum() + half.sum() + hi.cwiseMax(-lo).sum(),
               f = (hi - lo).sum() + 4 * unit<double> * q;
  if (!(0x1p-300 < f && q < 0x1p300)) return {};

  unsigned open = 0;
  int place = 0;
  const auto told = [&](double here, double margin) {
    open |= static_cast<unsigned>(!(here < -margin)) << place++;
    return here;
  };
  double widest = -q;
  const double margin = 8 * unit<double> * q;
  for (int i = 0; i < N; ++i) widest = std::max(widest, told(gap(lo[i], hi[i], half[i]), margin));
  if (widest > margin) return {1};

  if constexpr (N == 3) {
    const Vector<double, 3> n = edges[0].cross(edges[1]);
    const double height = n.dot(v[0]), normal_gap = std::abs(height) - half.dot(n.cwiseAbs());
    const double normal_margin = 64 * unit<double> * (f * f) * q;
    if (told(normal_gap, normal_margin) > normal_margin) return {1};
  }

  const double edge_margin = 16 * unit<double> * f * q;
  widest = -f * q;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < (N == 3 ? 3 : 1); ++i) {
      const int x = N == 3 ? (i + 1) % 3 : 0, y = N == 3 ? (i + 2) % 3 : 1;
      const double f_x = edges[k][x], f_y = edges[k][y];
      const double edge = f_x * v[k][y] - f_y * v[k][x];
      const double apex = f_x * v[(k + 2) % 3][y] - f_y * v[(k + 2) % 3][x];
      const double radius = half[x] * std::abs(f_y) + half[y] * std::abs(f_x);
      const bool vanishes = (f_x == 0) & (f_y == 0);
      const double here = gap(std::min(edge, apex), std::max(edge, apex), radius);
      widest = std::max(widest, here);
      open |= static_cast<unsigned>(!(here < -edge_margin) & !vanishes) << place++;
    }
  if (widest > edge_margin) return {1};
  return {open == 0 ? std::optional(-1) : std::nullopt, open};
}

}  // namespace detail

}  // namespace triangle_aabb

}  // namespace isect
