#pragma once
// Sphere against axis-aligned box as the note prints it and as it is written in practice: for lessons and comparison.
// `intersects` in isect/sphere_aabb.h is right for all input.
//
// All but the note's count touching as an intersection, but rounding may decide there; squares overflow or vanish
// beyond 1e+-154 in double, 1e+-19 in float; an inverted box is taken as it is.

#include <variant>

#include <isect/sphere_aabb.h>

namespace isect::sphere_aabb {

/// The box's point nearest to the center.
template <class S, int N>
struct Nearest {
  Point<S, N> p;
};
/// One axis alone parts them: the box begins or ends farther than r from the center.
template <class S>
struct Rejected {
  int axis;
  S gap;
};
template <class S, int N>
using MethodEvent = std::variant<Nearest<S, N>, Axis<S>, Compared<S>, Rejected<S>>;

/// The note's method: whether the box comes nearer than touching. Naive: rounding may decide, and NaN is near.
template <class S, int N, class Trace = NoTrace>
bool accumulate_naive(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace = {}) {
  S distance2 = S(0);
  for (int axis = 0; axis < N; ++axis) {
    const S c = sphere.center[axis];
    S gap = S(0);
    if (c < box.lo[axis]) {
      gap = c - box.lo[axis];
      distance2 = distance2 + gap * gap;
    } else if (c > box.hi[axis]) {
      gap = c - box.hi[axis];
      distance2 = distance2 + gap * gap;
    }
    if constexpr (heard<Trace>) trace(Axis<S>{axis, c, box.along(axis), gap, distance2});
  }
  const S radius2 = sphere.radius * sphere.radius;
  const bool near = distance2 < radius2;
  if constexpr (heard<Trace>) trace(Compared<S>{distance2, radius2});
  return near;
}

/// Finds the nearest point by clamping the center to the box. NaN in the center or the radius: no.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.3 and 5.2.5.
template <class S, int N, class Trace = NoTrace>
bool clamped(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace = {}) {
  const Point<S, N> p = sphere.center.cwiseMax(box.lo).cwiseMin(box.hi);
  trace(Nearest<S, N>{p});

  const Vector<S, N> f = sphere.center - p;
  const S distance2 = f.dot(f), radius2 = sphere.radius * sphere.radius;
  trace(Compared<S>{distance2, radius2});
  return distance2 <= radius2;
}

/// Does what accumulate_naive does, but gives up at the first axis whose gap exceeds r.
/// Source: Larsson, Akenine-Moller, Lengyel, On faster sphere-box overlap testing, J. Graphics Tools 12 (2007).
template <class S, int N, class Trace = NoTrace>
bool with_rejections(const Sphere<S, N>& sphere, const Aabb<S, N>& box, Trace&& trace = {}) {
  S distance2 = S(0);
  for (int axis = 0; axis < N; ++axis) {
    const S c = sphere.center[axis];
    S gap = S(0);
    if (c < box.lo[axis])
      gap = box.lo[axis] - c;
    else if (c > box.hi[axis])
      gap = c - box.hi[axis];
    if (gap > sphere.radius) {
      trace(Rejected<S>{axis, gap});
      return false;
    }
    distance2 = distance2 + gap * gap;
    if constexpr (heard<Trace>) trace(Axis<S>{axis, c, box.along(axis), gap, distance2});
  }

  const S radius2 = sphere.radius * sphere.radius;
  trace(Compared<S>{distance2, radius2});
  return distance2 <= radius2;
}

}  // namespace isect::sphere_aabb
