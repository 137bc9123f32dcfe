#pragma once
// Axis-aligned box against box.
//
// Boxes are products of intervals, so they share a box: on every axis the interval from the larger lower end to the
// smaller upper end. They are disjoint when that is inverted on *some* axis, and meet when they overlap in x and y and
// z. The note says "or", and its figure returns OVERLAP after the first axis: only the end of the loop may say so. Only
// inputs are compared: exact for free. Source: the note, N13 (corrected), N12.

#include <algorithm>
#include <limits>
#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace aabb_aabb {

/// by_axis: one axis, compared; the first disjoint one ends the test.
template <class S>
struct Axis {
  int axis;
  Interval<S> a, b;
  bool disjoint;
};
/// relate: the shared box; none when it is inverted on some axis.
template <class S, int N>
struct Common {
  Aabb<S, N> common;
};
template <class S, int N>
using Event = std::variant<Axis<S>, Common<S, N>>;

/// The box that both boxes share; empty when they have no common point, or one is empty. Exact; finite arguments.
template <class S, int N>
Aabb<S, N> common(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  return {a.lo.cwiseMax(b.lo), a.hi.cwiseMin(b.hi)};
}

namespace detail {

template <class S, int N>
bool same(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  return a.lo == b.lo && a.hi == b.hi;
}

}  // namespace detail

}  // namespace aabb_aabb

/// Whether the boxes have a common point. Exact; an empty box, NaN or an infinite coordinate: no.
///
/// No branch depends on the answer. A shared box that is not inverted says that neither of the two is. Where a
/// coordinate is NaN or infinite, so is the sum of all widths; it is -inf only where a box is inverted. The sum may
/// also overflow though no coordinate is infinite, so the coordinates are checked then.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  if constexpr (heard<Trace>) trace(aabb_aabb::Common<S, N>{aabb_aabb::common(a, b)});

  const S widths = (a.hi - a.lo).sum() + (b.hi - b.lo).sum();
  bool meets = true;
  for (int i = 0; i < N; ++i) meets &= std::max(a.lo[i], b.lo[i]) <= std::min(a.hi[i], b.hi[i]);
  if (!(widths <= std::numeric_limits<S>::max())) [[unlikely]]
    return meets && finite(a) && finite(b);
  return meets;
}

/// Whether a point is interior to both boxes; a flat one's interior is within the plane, line or point it spans. Exact.
template <class S, int N>
bool interiors_intersect(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  if (empty(a) || empty(b) || !finite(a) || !finite(b)) return false;
  for (int i = 0; i < N; ++i) {
    const bool one_point = a.lo[i] == b.hi[i] && a.hi[i] == b.lo[i];
    if (!one_point && !(a.lo[i] < b.hi[i] && b.lo[i] < a.hi[i])) return false;
  }
  return true;
}

/// How the boxes lie. Exact, for flat boxes too. An empty box, NaN or an infinite coordinate: disjoint.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  if (!finite(a) || !finite(b)) return Relation::disjoint;

  const Aabb<S, N> common = aabb_aabb::common(a, b);
  trace(aabb_aabb::Common<S, N>{common});

  if (empty(common)) return Relation::disjoint;
  if (aabb_aabb::detail::same(a, b)) return Relation::equal;
  if (aabb_aabb::detail::same(common, a)) return Relation::a_inside_b;
  if (aabb_aabb::detail::same(common, b)) return Relation::b_inside_a;
  return interiors_intersect(a, b) ? Relation::overlapping : Relation::touching;
}

}  // namespace isect
