#pragma once
// Clipping a convex polygon at a half-space in plain floating point: for lessons and comparison. `clip` in
// isect/clip_polygon.h is right for all input. Source: Sutherland, Hodgman, Reentrant polygon clipping, Comm. ACM 17
// (1974).

#include <isect/clip_polygon.h>

namespace isect::clip_polygon {

/// Clips the ring at one plane, in floating point. Naive: rounding may decide which vertices survive.
template <class S, int N, class Trace = NoTrace>
Ring<S, N> sutherland_hodgman(const Ring<S, N>& ring, const Plane<S, N>& half_space, Trace&& trace = {}) {
  Ring<S, N> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, N>&p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
    const S from = half_space.normal.dot(p) + half_space.d, to = half_space.normal.dot(q) + half_space.d;
    trace(Side{static_cast<int>(i), from > S(0) ? 1 : from < S(0) ? -1 : 0});
    if (from >= S(0)) kept.push_back(p);
    if (!(from * to < S(0))) continue;
    kept.push_back(p + (from / (from - to)) * (q - p));
    trace(Crossing<S, N>{static_cast<int>(i), kept.back()});
  }
  return kept;
}

}  // namespace isect::clip_polygon
