#pragma once
// Axis-aligned box against box as the note prints it and as it is written in practice: for lessons and comparison.
// `intersects` in isect/aabb_aabb.h is right for all input.

#include <variant>

#include <isect/aabb_aabb.h>
#include <isect/methods/interval_interval.h>

namespace isect::aabb_aabb {

/// Whether the boxes meet, axis by axis, as the note prints it, errata corrected. Naive: right for valid boxes, but it
/// takes inverted ones and NaN for overlapping.
template <class S, int N, class Trace = NoTrace>
bool by_axis(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  for (int axis = 0; axis < N; ++axis) {
    const bool disjoint = !interval_interval::ends(a.along(axis), b.along(axis));
    trace(Axis<S>{axis, a.along(axis), b.along(axis), disjoint});
    if (disjoint) return false;
  }
  return true;
}

template <class S>
using MethodEvent = std::variant<interval_interval::Common<S>, interval_interval::Middles<S>>;

/// Compares the larger lower ends with the smaller upper ends, without a branch. An inverted box meets nothing, but NaN
/// may slip through std::max and std::min.
template <class S, int N, class Trace = NoTrace>
bool min_max(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  bool meets = true;
  for (int axis = 0; axis < N; ++axis) meets &= interval_interval::min_max(a.along(axis), b.along(axis), trace);
  return meets;
}

/// Compares centers and half-sides. Naive: centers round, so that boxes that touch may come apart.
/// Source: Ericson, Real-Time Collision Detection (2005), 4.2.1.
template <class S, int N, class Trace = NoTrace>
bool by_centers(const Aabb<S, N>& a, const Aabb<S, N>& b, Trace&& trace = {}) {
  for (int axis = 0; axis < N; ++axis)
    if (!interval_interval::by_middles(a.along(axis), b.along(axis), trace)) return false;
  return true;
}

}  // namespace isect::aabb_aabb
