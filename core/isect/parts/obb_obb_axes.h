#pragma once
// The axes that can separate two oriented boxes, and the polynomials that tell: see isect/obb_obb.h.
//
// Box A is a + sum s_k A_k, |s_k| <= e_k, box B is b + sum s_k B_k, |s_k| <= h_k. Along a direction l they reach
// r_A = sum e_k |l.A_k| and r_B = sum h_k |l.B_k| to either side of their centers, so l separates them iff
//
//   gap(l) = |l.(b - a)| - (r_A + r_B) > 0.
//
// Which l must be tried? The boxes meet iff 0 lies in their Minkowski difference, a zonotope with the edges e_k A_k
// and h_k B_k. In space its facets are spanned by two edges each, so their normals are among the 3 + 3 face normals
// A_i x A_j and B_i x B_j and the 9 products A_i x B_j; in the plane they are the 2 + 2 edge normals. A product that
// vanishes has gap 0 and says nothing. A lies in B iff |l.(b - a)| + r_A <= r_B for each face normal l of B.
//
// With flat boxes, some e_k or h_k = 0, the difference may itself be flat, a segment or a polygon, or a point. The
// same axes do. Let g = e_i A_i be one of its edges (or h_i B_i). The two face normals of A orthogonal to A_i span
// all directions orthogonal to A_i, and the third is not orthogonal to it. So if the difference is a segment along g,
// the two tell whether 0 lies on its line, the third whether between its ends; if it is a polygon, one of the two is
// not normal to its plane, so that it serves as the edge's normal, and a product of two edges is normal to the plane.
// If it is a point, the normals of A tell whether that is 0.
//
// The interiors, of flat boxes within the plane or line that each spans, have no common point iff 0 lies on the rim of
// the difference: iff some gap is 0 along a direction in which the difference reaches anywhere, r_A + r_B > 0.

#include <array>
#include <optional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/point_obb.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace obb_obb {

enum class Kind {
  face_of_a,  ///< normal i of A
  face_of_b,  ///< normal i of B
  edges       ///< axis i of A times axis j of B
};
struct Axis {
  Kind kind;
  int i, j = 0;

  friend bool operator==(const Axis&, const Axis&) = default;
};

/// One axis, its rounded numbers: |l.(b - a)| against r_A + r_B, all in units of |l|. The sign of the gap: 1
/// separates, 0 touches or says nothing, -1 overlaps; none where doubles leave it open.
template <int N>
struct Tested {
  Axis axis;
  Vector<double, N> l;
  double distance, radius_a, radius_b;
  std::optional<int> sign;
};
/// A trivial accept: a common point, as rounded.
template <int N>
struct Witness {
  Point<double, N> p;
};
template <int N>
using Event = std::variant<Tested<N>, Witness<N>, Fallback>;

namespace detail {

/// The face normals of A and B, then the products of edges.
template <int N>
constexpr auto all_axes() {
  std::array<Axis, N == 3 ? 15 : 4> axes = {};
  int count = 0;
  for (const Kind kind : {Kind::face_of_a, Kind::face_of_b})
    for (int i = 0; i < N; ++i) axes[count++] = {kind, i, 0};
  if constexpr (N == 3)
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) axes[count++] = {Kind::edges, i, j};
  return axes;
}

/// Where an axis stands among all of them.
template <int N>
constexpr int place(const Axis& axis) {
  return axis.kind == Kind::face_of_a   ? axis.i
         : axis.kind == Kind::face_of_b ? N + axis.i
                                        : 2 * N + N * axis.i + axis.j;
}

template <PolynomialScalar W, int N>
Components<W, N> direction(const Obb<double, N>& a, const Obb<double, N>& b, const Axis& axis) {
  if constexpr (N == 3) {
    const Vector<double, 3> edge_a = a.axes.col(axis.i), edge_b = b.axes.col(axis.j);
    if (axis.kind == Kind::edges) return cross(exactly<W>(edge_a), exactly<W>(edge_b));
  }
  return point_obb::detail::normal<W>(axis.kind == Kind::face_of_a ? a.axes : b.axes, axis.i);
}

/// How far the box reaches from its center along l.
template <PolynomialScalar W, int N>
W radius(const Components<W, N>& l, const Obb<double, N>& box) {
  W sum = 0;
  for (int k = 0; k < N; ++k) {
    const Vector<double, N> u = box.axes.col(k);
    sum = sum + W(box.half[k]) * abs(dot(l, exactly<W>(u)));
  }
  return sum;
}

template <PolynomialScalar W, int N>
W distance(const Components<W, N>& l, const Obb<double, N>& a, const Obb<double, N>& b) {
  return abs(dot(l, difference<W>(b.center, a.center)));
}

template <PolynomialScalar W, int N>
W gap(const Obb<double, N>& a, const Obb<double, N>& b, const Axis& axis) {
  const Components<W, N> l = direction<W>(a, b, axis);
  return distance<W, N>(l, a, b) - (radius<W, N>(l, a) + radius<W, N>(l, b));
}

/// How far A reaches beyond face pair i of B.
template <PolynomialScalar W, int N>
W beyond(const Obb<double, N>& a, const Obb<double, N>& b, int i) {
  const Components<W, N> l = point_obb::detail::normal<W>(b.axes, i);
  return distance<W, N>(l, a, b) + radius<W, N>(l, a) - W(b.half[i]) * abs(point_obb::detail::volume<W>(b.axes, i));
}

}  // namespace detail

/// The rounded numbers of one axis, to show them; `sign` is passed on. Finite arguments.
template <int N>
Tested<N> tested(const Obb<double, N>& a, const Obb<double, N>& b, const Axis& axis, std::optional<int> sign) {
  using B = Bounded<double>;
  const Components<B, N> l = detail::direction<B>(a, b, axis);
  const B apart = detail::distance<B, N>(l, a, b), radius_a = detail::radius<B, N>(l, a),
          radius_b = detail::radius<B, N>(l, b);
  Tested<N> event = {axis, {}, apart.value(), radius_a.value(), radius_b.value(), sign};
  for (int k = 0; k < N; ++k) event.l[k] = l[k].value();
  return event;
}

}  // namespace obb_obb

}  // namespace isect
