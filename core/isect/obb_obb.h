#pragma once
// Oriented box against oriented box, exactly right: separating axes. isect/parts/obb_obb_axes.h says which they are,
// and why they suffice.
//
// The first pass is the classical test in the scalar itself, with a proved margin in place of its epsilon. It settles
// nearly all pairs; the axes of the others are tested exactly, one by one, each by the sign of a polynomial. The
// classical test itself stands in isect/methods/obb_obb.h. Source: Gottschalk, Lin, Manocha, OBBTree, SIGGRAPH 1996;
// Ericson, Real-Time Collision Detection (2005), 4.4.1.

#include <optional>
#include <type_traits>

#include <isect/numbers/predicate.h>
#include <isect/parts/obb_obb_axes.h>
#include <isect/parts/obb_obb_first_pass.h>
#include <isect/parts/unit_of_length.h>
#include <isect/point_obb.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace obb_obb {

namespace detail {

/// Whether a gap of 0 says nothing: the axis is the product of two parallel edges, which vanishes, or both boxes lie in
/// one plane across it, which no box with a volume does.
template <int N>
bool says_nothing(const Obb<double, N>& a, const Obb<double, N>& b, const Axis& axis) {
  const auto vanishes = [&](int k) {
    return sign_of([&]<class W>() -> W { return direction<W>(a, b, axis)[static_cast<std::size_t>(k)]; }) == 0;
  };
  bool leads = axis.kind != Kind::edges;
  for (int k = 0; k < N && !leads; ++k) leads = !vanishes(k);
  if (!leads || a.half.minCoeff() > 0 || b.half.minCoeff() > 0) return !leads;
  return sign_of([&]<class W>() -> W {
           const Components<W, N> l = direction<W>(a, b, axis);
           return radius<W, N>(l, a) + radius<W, N>(l, b);
         }) == 0;
}

/// The verdict of all axes together: the one that separates, or whether one touches.
struct Settled {
  std::optional<Axis> separating;
  bool touching = false;
};

/// Whether the boxes have the same axes, up to order and signs, as boxes along the coordinate axes do: then the face
/// normals of A are all that there is to ask.
template <int N>
bool same_axes(const Obb<double, N>& a, const Obb<double, N>& b) {
  for (int j = 0; j < N; ++j) {
    bool found = false;
    for (int i = 0; i < N; ++i) found |= a.axes.col(i) == b.axes.col(j) || a.axes.col(i) == -b.axes.col(j);
    if (!found) return false;
  }
  return true;
}

/// Asks every axis that the first pass left open exactly, up to the first that separates; a listener hears of all. The
/// boxes are finite and have independent axes.
template <int N, class Trace>
[[gnu::noinline, gnu::cold]] Settled settle(const Obb<double, N>& a, const Obb<double, N>& b, unsigned open,
                                            Trace&& trace) {
  Settled result;
  if (!heard<Trace> && same_axes(a, b)) open &= (1u << N) - 1;
  for (const Axis& axis : all_axes<N>()) {
    if (!heard<Trace> && (open >> place<N>(axis) & 1) == 0) continue;
    const Vector<double, N> u = a.axes.col(axis.i), v = b.axes.col(axis.j);
    if (axis.kind == Kind::edges && (u == v || u == -v)) continue;  // parallel, as most parallel edges are
    const int sign = sign_of([&]<class W>() -> W { return gap<W>(a, b, axis); }, trace);
    if constexpr (heard<Trace>) trace(tested(a, b, axis, sign));
    if (sign > 0) return {axis, false};
    if (sign == 0 && !result.touching) result.touching = !says_nothing(a, b, axis);
  }
  return result;
}

/// Whether A is a subset of B, of two boxes with independent axes.
template <int N, class Trace>
bool inside(const Obb<double, N>& a, const Obb<double, N>& b, Trace&& trace) {
  for (int i = 0; i < N; ++i)
    if (sign_of([&]<class W>() -> W { return beyond<W>(a, b, i); }, trace) > 0) return false;
  return true;
}

/// Runs the first pass, when only a verdict is wanted: in S, or in doubles when someone listens.
template <class S, int N, class Trace>
FirstPass verdict(const Obb<S, N>& a, const Obb<S, N>& b, Trace&& trace) {
  if constexpr (heard<Trace>)
    return first_pass(cast<double>(a), cast<double>(b), trace);
  else
    return first_pass(a, b, trace);
}

/// Whether the box exists and has a point.
template <class S, int N, class Trace>
bool exists(const Obb<S, N>& box, Trace&& trace) {
  return !empty(box) && finite(box) && point_obb::detail::independent(cast<double>(box).axes, trace);
}

}  // namespace detail

}  // namespace obb_obb

/// Whether a box has a point: its numbers are finite, its half-lengths not negative, its axes independent. Exact.
template <class S, int N>
bool has_points(const Obb<S, N>& box) {
  return obb_obb::detail::exists(box, NoTrace());
}

/// An axis that separates the boxes; of several, one that plain doubles are sure of. Nothing when the boxes have a
/// common point, and for boxes without points (see `intersects`). Exact.
template <class S, int N, class Trace = NoTrace>
std::optional<obb_obb::Axis> separating_axis(const Obb<S, N>& a, const Obb<S, N>& b, Trace&& trace = {}) {
  if (!obb_obb::detail::exists(a, trace) || !obb_obb::detail::exists(b, trace)) return {};
  const Obb<double, N>&wide_a = in_doubles(a), &wide_b = in_doubles(b);
  const obb_obb::detail::FirstPass first = obb_obb::detail::first_pass(wide_a, wide_b, trace);
  if (first.separating || first.overlap) return first.separating;
  return obb_obb::detail::settle(wide_a, wide_b, first.open, trace).separating;
}

/// Whether the boxes have a common point. Exact, for flat boxes too. An empty box, one with dependent axes (there is
/// no such box), NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Obb<S, N>& a, const Obb<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b)) return false;
  const obb_obb::detail::FirstPass first = obb_obb::detail::verdict(a, b, trace);
  if (first.separating || first.overlap) [[likely]]
    return first.overlap;
  if (!obb_obb::detail::exists(a, trace) || !obb_obb::detail::exists(b, trace)) return false;
  const auto settled = [&](const Obb<double, N>& x, const Obb<double, N>& y) {
    return !obb_obb::detail::settle<N>(x, y, first.open, trace).separating;
  };
  return settled_in_own_unit<Trace>(in_doubles(a), in_doubles(b), settled);
}

/// How the boxes lie. Exact, for flat boxes too, some half_i = 0. Equal means the same set, whatever the order, signs
/// and lengths of the axes. Nothing meets an empty box, one with dependent axes, NaN or an infinite coordinate.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Obb<S, N>& a, const Obb<S, N>& b, Trace&& trace = {}) {
  if (empty(a) || empty(b)) return Relation::disjoint;
  const Obb<double, N>&wide_a = in_doubles(a), &wide_b = in_doubles(b);

  const obb_obb::detail::FirstPass first = obb_obb::detail::verdict(a, b, trace);
  if (first.separating) return Relation::disjoint;
  obb_obb::detail::Settled settled;
  if (!first.overlap) {
    if (!obb_obb::detail::exists(a, trace) || !obb_obb::detail::exists(b, trace)) return Relation::disjoint;
    settled = obb_obb::detail::settle(wide_a, wide_b, first.open, trace);
  }
  if (settled.separating) return Relation::disjoint;

  const bool a_in_b = obb_obb::detail::inside(wide_a, wide_b, trace),
             b_in_a = obb_obb::detail::inside(wide_b, wide_a, trace);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return settled.touching ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
