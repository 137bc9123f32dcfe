#pragma once
// Point against oriented box.
//
// The box is { c + sum s_i u_i, |s_i| <= e_i }. Let n_i be orthogonal to all axes but u_i: n_i = u_j x u_k in 3D, the
// other axis turned by a right angle in 2D. Then n_i.(x - c) = s_i n_i.u_i, where n_i.u_i = +-det u =: D is the same
// for every i, so that x lies between the faces of pair i iff
//
//   |n_i.(x - c)| <= e_i |D|.
//
// For orthonormal axes that is |u_i.(x - c)| <= e_i. Rounded axes are neither quite orthogonal nor of unit length;
// the form above is right for any that are independent. Source: the note, N07, for the box.

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace point_obb {

/// The sign of |n_i.(x - c)| - e_i |D|: -1 between the faces of pair `axis`, 0 on one, 1 beyond.
struct Slab {
  int axis, sign;
};
using Event = std::variant<Slab, Fallback>;

namespace detail {

/// n_i, up to its sign.
template <PolynomialScalar W, int N>
Components<W, N> normal(const Eigen::Matrix<double, N, N>& axes, int i) {
  const Vector<double, N> u = axes.col((i + 1) % N);
  if constexpr (N == 2) {
    return {W(-u[1]), W(u[0])};
  } else {
    const Vector<double, N> v = axes.col((i + 2) % N);
    return cross(exactly<W>(u), exactly<W>(v));
  }
}

/// n_i.u_i: the determinant of the axes, up to its sign.
template <PolynomialScalar W, int N>
W volume(const Eigen::Matrix<double, N, N>& axes, int i) {
  const Vector<double, N> u = axes.col(i);
  return dot(normal<W>(axes, i), exactly<W>(u));
}

/// Whether the axes are independent: the box exists. Exact; finite arguments.
template <int N, class Trace = NoTrace>
bool independent(const Eigen::Matrix<double, N, N>& axes, Trace&& trace = {}) {
  return sign_of([&]<class W>() -> W { return volume<W>(axes, 0); }, trace) != 0;
}

/// |n_i.(x - c)| - e_i |D|
template <PolynomialScalar W, int N>
W beyond(const Point<double, N>& x, const Obb<double, N>& box, int i) {
  const W along = dot(normal<W>(box.axes, i), difference<W>(x, box.center));
  return abs(along) - W(box.half[i]) * abs(volume<W>(box.axes, i));
}

/// Column i of x times column j of y.
template <class X, class Y>
typename X::Scalar dot_columns(const X& x, int i, const Y& y, int j) {
  typename X::Scalar sum = x(0, i) * y(0, j);
  for (int k = 1; k < X::RowsAtCompileTime; ++k) sum += x(k, i) * y(k, j);
  return sum;
}

/// A bound of |U^T U - 1| (its spectral norm), up to 20 u: the sum of its entries on and above the diagonal.
template <class S, int N>
S skew(const Eigen::Matrix<S, N, N>& u) {
  S sum = 0;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j) sum += std::abs(dot_columns(u, i, u, j) - S(i == j));
  return sum;
}

}  // namespace detail

}  // namespace point_obb

/// Whether the point lies in the box's interior, on its boundary, or outside. Exact. A flat box, some half_i = 0, has
/// no interior: its points lie on it. Out for an empty box, one with dependent axes (there is no such box), NaN or an
/// infinite coordinate.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& point, const Obb<S, N>& box, Trace&& trace = {}) {
  if (empty(box) || !finite(box) || !finite(point)) return Location::out;
  const Point<double, N> x = point.template cast<double>();
  const Obb<double, N> wide = cast<double>(box);
  if (!point_obb::detail::independent(wide.axes, trace)) return Location::out;

  Location location = Location::in;
  for (int i = 0; i < N; ++i) {
    const int sign = sign_of([&]<class W>() -> W { return point_obb::detail::beyond<W>(x, wide, i); }, trace);
    if constexpr (heard<Trace>) trace(point_obb::Slab{i, sign});
    if (sign > 0) return Location::out;
    if (sign == 0) location = Location::on;
  }
  return location;
}

}  // namespace isect
