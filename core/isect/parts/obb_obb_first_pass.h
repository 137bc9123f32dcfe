#pragma once
// The first pass of isect/obb_obb.h: the classical test in the scalar itself, with a proved margin for an epsilon.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <isect/parts/obb_obb_axes.h>

namespace isect {

namespace obb_obb {

namespace detail {

/// The verdicts that plain doubles settle.
struct FirstPass {
  std::optional<Axis> separating;  ///< this axis does
  bool overlap = false;            ///< the interiors of unflat boxes meet; if neither holds, some axes are open
  unsigned open = ~0u;             ///< bit i: axis i of all_axes may yet separate or touch
};

/// The classical test in S, r_ij = A_i.B_j, with a margin; axes that are not orthonormal within 2^-10 stay open.
///
/// Margin. Let d <= 2^-10 be the sum of |U^T U - 1| over both boxes. U = V (U^T U)^1/2 with an orthonormal V (the polar
/// decomposition), so |U - V| <= d: each box is within d |half|_1 of one whose axes are exactly orthonormal. For those
/// two the classical gaps are the true ones, for directions l with |l| <= 1. Let q = |b - a|_1 + |e|_1 + |h|_1. The
/// computed r_ij are off theirs by at most 1.01 d + 3.1 u, the A_i.(b - a) by (1.01 d + 4.1 u) q, so all gaps by (4.1 d
/// + 24 u) q; the boxes themselves by d q. So a gap beyond (5.1 d + 24 u) q separates; where all are below its
/// negative, the difference of the orthonormal boxes holds a ball around 0 of more than d q; and a point of A that lies
/// so deep in B is common. The axis itself, a product of two edges of the boxes, differs from the orthonormal ones' by
/// at most 2.1 d, and its gap by as much of q: one below -(7.3 d + 24 u) q neither separates nor touches. The computed
/// d lacks up to 40 u, and q and the margin are rounded in their turn.
template <class S, int N, class Trace>
[[gnu::flatten]] FirstPass first_pass(const Obb<S, N>& a, const Obb<S, N>& b, Trace&& trace) {
  using Limits = std::numeric_limits<S>;
  constexpr S u = static_cast<S>(unit<S>), least = Limits::min() / (u * u), most = Limits::max() * (u * u);
  const Vector<S, N> t = b.center - a.center;
  const S reach = t.cwiseAbs().sum() + (a.half.sum() + b.half.sum()),
          d = point_obb::detail::skew(a.axes) + point_obb::detail::skew(b.axes);
  if (!(d <= S(0x1p-10) && least < reach && reach < most)) return {};  // or NaN
  const S margin = (8 * d + 384 * u) * reach;
  unsigned open = 0;
  const auto told = [&](const Axis& axis, S gap) {
    open |= static_cast<unsigned>(!(gap < -margin)) << place<N>(axis);
    std::optional<int> sign;
    if (std::abs(gap) > margin) sign = gap > 0 ? 1 : -1;
    if constexpr (heard<Trace>) trace(tested(a, b, axis, sign));
    return gap > margin;
  };

  Eigen::Matrix<S, N, N> r, size;
  Vector<S, N> along_a, along_b;
  for (int i = 0; i < N; ++i) {
    along_a[i] = point_obb::detail::dot_columns(a.axes, i, t, 0);
    S radius_b = 0;
    for (int j = 0; j < N; ++j) {
      r(i, j) = point_obb::detail::dot_columns(a.axes, i, b.axes, j);
      size(i, j) = std::abs(r(i, j));
      radius_b += b.half[j] * size(i, j);
    }
    const S gap = std::abs(along_a[i]) - (a.half[i] + radius_b);
    if (told({Kind::face_of_a, i}, gap)) return {Axis{Kind::face_of_a, i}};
  }
  for (int j = 0; j < N; ++j) {
    along_b[j] = point_obb::detail::dot_columns(b.axes, j, t, 0);
    S radius_a = 0;
    for (int i = 0; i < N; ++i) radius_a += a.half[i] * size(i, j);
    const S gap = std::abs(along_b[j]) - (radius_a + b.half[j]);
    if (told({Kind::face_of_b, j}, gap)) return {Axis{Kind::face_of_b, j}};
  }

  // The point of A nearest to b: does it lie in B? |x + e| - |x - e| is twice x clamped to [-e, e], without branches.
  Vector<S, N> s;
  for (int i = 0; i < N; ++i) s[i] = S(0.5) * (std::abs(along_a[i] + a.half[i]) - std::abs(along_a[i] - a.half[i]));
  bool inside = true;
  for (int j = 0; j < N; ++j)
    inside &= std::abs(point_obb::detail::dot_columns(r, j, s, 0) - along_b[j]) - b.half[j] < -margin;
  if (inside) {
    if constexpr (heard<Trace>) trace(Witness<N>{a.center + a.axes * s});
    return {{}, true};
  }

  if constexpr (N == 3) {
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) {
        const int i1 = (i + 1) % N, i2 = (i + 2) % N, j1 = (j + 1) % N, j2 = (j + 2) % N;
        const S radius_a = a.half[i1] * size(i2, j) + a.half[i2] * size(i1, j);
        const S radius_b = b.half[j1] * size(i, j2) + b.half[j2] * size(i, j1);
        const S gap = std::abs(along_a[i2] * r(i1, j) - along_a[i1] * r(i2, j)) - (radius_a + radius_b);
        if (told({Kind::edges, i, j}, gap)) return {Axis{Kind::edges, i, j}};
      }
  }
  return {{}, open == 0, open};
}

}  // namespace detail

}  // namespace obb_obb

}  // namespace isect
