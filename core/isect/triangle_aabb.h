#pragma once
// Triangle against axis-aligned box: separating axes, exactly.
//
// A direction l separates the two iff all corners c of the box lie beyond all vertices v of the triangle along l or
// along -l. Which corner comes first, the signs of l's components tell: it has lo_k where l_k > 0 and hi_k where
// l_k < 0. So with that corner c and its opposite c' one asks whether l.(c - v) > 0 for all v, or l.(v - c') > 0 for
// all v: polynomials in the coordinates as given. The usual form with center and half-lengths rounds both first.
//
// The axes are the box's normals e_i, the triangle's normal, and the products of e_i with the triangle's edges; in
// the plane the e_i and the normals of the edges. Products that vanish say nothing. These do for degenerate shapes as
// well, whose difference (see isect/parts/obb_obb_axes.h) may be flat. Its edges are those of the triangle and the box:
// the products of a triangle's edge with all e_i span the directions orthogonal to it, and so do the e_j for a box's
// edge e_i; so some is the edge's normal within the flat. Source: Akenine-Moller, Fast 3D triangle-box overlap testing,
// J. Graphics Tools 6 (2001).

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/triangle_aabb_first_pass.h>
#include <isect/parts/unit_of_length.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace triangle_aabb {

enum class Kind {
  box_normal,       ///< e_i
  triangle_normal,  ///< in space
  edge              ///< e_i times edge j, from vertex j to the next; in the plane its normal, and i is 0
};
struct Axis {
  Kind kind;
  int i, j = 0;

  friend bool operator==(const Axis&, const Axis&) = default;
};

/// One axis, its rounded numbers, and its exact verdict: 1 separates, 0 touches, -1 overlaps, none for l = 0.
template <int N>
struct Tested {
  Axis axis;
  Vector<double, N> l;
  Interval<double> triangle, box;
  std::optional<int> sign;
};
template <int N>
using Event = std::variant<Tested<N>, Fallback>;

namespace detail {

template <int N>
constexpr auto all_axes() {
  std::array<Axis, N == 3 ? 13 : 5> axes = {};
  int count = 0;
  for (int i = 0; i < N; ++i) axes[count++] = {Kind::box_normal, i};
  if constexpr (N == 3) axes[count++] = {Kind::triangle_normal, 0};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < (N == 3 ? 3 : 1); ++i) axes[count++] = {Kind::edge, i, j};
  return axes;
}

template <PolynomialScalar W, int N>
Components<W, N> direction(const Triangle<double, N>& triangle, const Axis& axis) {
  Components<W, N> l;
  l.fill(W(0));
  const Point<double, N>&p = triangle.vertices[axis.j], &q = triangle.vertices[(axis.j + 1) % 3];
  if (axis.kind == Kind::box_normal) {
    l[axis.i] = W(1);
  } else if constexpr (N == 2) {
    l = {difference<W>(p[1], q[1]), difference<W>(q[0], p[0])};
  } else if (axis.kind == Kind::edge) {
    const int i1 = (axis.i + 1) % 3, i2 = (axis.i + 2) % 3;
    l[i1] = difference<W>(p[i2], q[i2]), l[i2] = difference<W>(q[i1], p[i1]);
  } else {
    l = cross(difference<W>(q, p), difference<W>(triangle.vertices[2], p));
  }
  return l;
}

template <int N>
Tested<N> tested(const Triangle<double, N>& triangle, const Aabb<double, N>& box, const Axis& axis,
                 std::optional<int> sign) {
  const Components<Bounded<double>, N> l = direction<Bounded<double>>(triangle, axis);
  Tested<N> event = {axis, {}, {}, {0, 0}, sign};
  for (int k = 0; k < N; ++k) {
    event.l[k] = l[k].value();
    const auto [lo, hi] = std::minmax({event.l[k] * box.lo[k], event.l[k] * box.hi[k]});
    event.box = {event.box.lo + lo, event.box.hi + hi};
  }
  const auto& v = triangle.vertices;
  const auto [lo, hi] = std::minmax({event.l.dot(v[0]), event.l.dot(v[1]), event.l.dot(v[2])});
  event.triangle = {lo, hi};
  return event;
}

/// 1 where the axis separates, 0 where the shapes touch along it, -1 where they overlap; nothing for l = 0.
template <int N, class Trace>
std::optional<int> gap(const Triangle<double, N>& triangle, const Aabb<double, N>& box, const Axis& axis,
                       Trace&& trace) {
  const Components<Bounded<double>, N> rounded = direction<Bounded<double>>(triangle, axis);  // once for all signs
  const auto l = [&]<class W>() -> Components<W, N> {
    if constexpr (std::is_same_v<W, Bounded<double>>)
      return rounded;
    else
      return direction<W>(triangle, axis);
  };

  Point<double, N> first = box.lo, last = box.hi;  // corners along l
  bool vanishes = true;
  for (int k = 0; k < N; ++k) {
    const int sign = sign_of([&]<class W>() -> W { return l.template operator()<W>()[k]; }, trace);
    if (sign < 0) std::swap(first[k], last[k]);
    vanishes &= sign == 0;
  }
  if (vanishes) return {};

  int before = 1, behind = 1;  // the triangle, of the box
  for (int k = 0; k < 3; ++k) {
    if (axis.kind == Kind::triangle_normal && k > 0) break;          // l.v is the same for all vertices
    if (axis.kind == Kind::edge && k == (axis.j + 1) % 3) continue;  // and for the two of the edge
    const Point<double, N>& v = triangle.vertices[k];
    const auto apart = [&](const Point<double, N>& x, const Point<double, N>& y) {
      return sign_of([&]<class W>() -> W { return dot(l.template operator()<W>(), difference<W, N>(x, y)); }, trace);
    };
    if (before >= 0) before = std::min(before, apart(first, v));
    if (behind >= 0) behind = std::min(behind, apart(v, last));
    if (before < 0 && behind < 0) return -1;
  }
  if (before == 0 && behind == 0) return -1;  // both lie in one plane across the axis, which parts no interiors
  return std::max(before, behind);
}

/// Asks the axes that the first pass left open, or all where somebody listens, and returns what all say together: 1
/// some separates, 0 some touches, -1 all overlap.
template <int N, class Trace>
[[gnu::noinline, gnu::cold]] int settle(const Triangle<double, N>& triangle, const Aabb<double, N>& box, unsigned open,
                                        Trace&& trace) {
  int most = -1;
  for (const Axis& axis : all_axes<N>()) {
    const bool ask = heard<Trace> || (open & 1) != 0;
    open >>= 1;
    if (!ask) continue;
    const std::optional<int> sign = gap(triangle, box, axis, trace);
    if constexpr (heard<Trace>) trace(tested(triangle, box, axis, sign));
    most = std::max(most, sign.value_or(-1));
    if (most > 0) break;
  }
  return most;
}

/// Returns what `settle` does; plain doubles answer most cases. A listener hears all axes.
template <int N, class Trace>
int outer(const Triangle<double, N>& triangle, const Aabb<double, N>& box, Trace&& trace) {
  if constexpr (heard<Trace>) {
    return settle(triangle, box, ~0u, trace);
  } else {
    const FirstPass first = first_pass(triangle, box);
    if (first.sign) [[likely]]
      return *first.sign;
    if (first.open != ~0u) return settle(triangle, box, first.open, trace);
    return in_own_unit(triangle, box, [&](const Triangle<double, N>& t, const Aabb<double, N>& b) {
      const FirstPass own = first_pass(t, b);
      return own.sign ? *own.sign : settle(t, b, own.open, trace);
    });
  }
}

template <class S, int N>
bool meaningless(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  return empty(box) || !finite(box) || !finite(triangle);
}

/// Whether every vertex lies in the box.
template <class S, int N>
bool inside(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  for (const Point<S, N>& v : triangle.vertices)
    if (!(box.lo.array() <= v.array() && v.array() <= box.hi.array()).all()) return false;
  return true;
}

/// Whether every corner of the box lies in the triangle. In space only a flat box can.
template <int N>
bool holds(const Triangle<double, N>& triangle, const Aabb<double, N>& box) {
  if (N == 3 && (box.lo.array() < box.hi.array()).all()) return false;
  for (int corner = 0; corner < 1 << N; ++corner) {
    Point<double, N> c;
    for (int k = 0; k < N; ++k) c[k] = corner >> k & 1 ? box.hi[k] : box.lo[k];
    if (outer(triangle, Aabb<double, N>{c, c}, NoTrace{}) > 0) return false;
  }
  return true;
}

}  // namespace detail

}  // namespace triangle_aabb

/// Whether triangle and box have a common point. Exact; degenerate triangles are segments or points. An empty box,
/// NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Triangle<S, N>& triangle, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (triangle_aabb::detail::meaningless(triangle, box)) return false;
  return triangle_aabb::detail::outer(cast<double>(triangle), cast<double>(box), trace) <= 0;
}

/// Whether some point of the triangle lies in the box's interior; a flat box has none. Exact.
template <class S, int N, class Trace = NoTrace>
bool intersects_interior(const Triangle<S, N>& triangle, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (triangle_aabb::detail::meaningless(triangle, box) || (box.lo.array() == box.hi.array()).any()) return false;
  return triangle_aabb::detail::outer(cast<double>(triangle), cast<double>(box), trace) < 0;
}

/// How triangle (A) and box (B) lie. Exact, for flat boxes and degenerate triangles too. Only a flat box can lie in a
/// triangle in space.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Triangle<S, N>& triangle, const Aabb<S, N>& box, Trace&& trace = {}) {
  if (triangle_aabb::detail::meaningless(triangle, box)) return Relation::disjoint;
  const Triangle<double, N> wide_triangle = cast<double>(triangle);
  const Aabb<double, N> wide_box = cast<double>(box);

  const int outer = triangle_aabb::detail::outer(wide_triangle, wide_box, trace);
  if (outer > 0) return Relation::disjoint;
  const bool a_in_b = triangle_aabb::detail::inside(triangle, box),
             b_in_a = triangle_aabb::detail::holds(wide_triangle, wide_box);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return outer == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
