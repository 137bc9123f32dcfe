#pragma once
// Axis-aligned box against view frustum: what a renderer asks before it draws.
//
// Like a sphere (isect/sphere_frustum.h), a box beyond one of the six planes is outside, one that no plane cuts is
// inside, and what remains is left undecided, which draws too much near the frustum's edges. Each plane looks at the
// box's two extreme corners, and at one only if that is outside. Source: the note, N01 (view-volume culling);
// Assarsson, Moller, Optimized view frustum culling algorithms for bounding boxes, J. Graphics Tools 5 (2000).

#include <variant>

#include <isect/parts/frustum_planes.h>
#include <isect/plane_aabb.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace aabb_frustum {

using frustum_planes::Tested;
using Event = std::variant<Tested, Fallback>;

namespace detail {

/// Where the box lies with respect to n.x + d >= 0, by that inequality even where the normal is 0. Finite arguments.
template <class S, class Trace>
Culling side(const Plane<S, 3>& plane, const Aabb<S, 3>& box, Trace&& trace) {
  if (plane_aabb::detail::sign_at(plane, box, true, trace) < 0) return Culling::outside;
  return plane_aabb::detail::sign_at(plane, box, false, trace) >= 0 ? Culling::inside : Culling::crossing;
}

}  // namespace detail

}  // namespace aabb_frustum

/// outside: for certain, the box lies beyond one plane. inside: for certain and exactly, the frustum contains the
/// box, touching included. crossing: neither; the box may still be outside. A plane with a zero normal bounds
/// nothing, or everything when its d < 0. An empty box, NaN or an infinite coordinate: outside.
template <class S, class Trace = NoTrace>
Culling cull(const Aabb<S, 3>& box, const Frustum<S>& frustum, Trace&& trace = {}) {
  if (empty(box) || !finite(box) || !finite(frustum)) return Culling::outside;

  const auto side_of = [&](const Plane<S, 3>& plane) { return aabb_frustum::detail::side(plane, box, trace); };
  return frustum_planes::detail::cull(frustum, side_of, trace);
}

}  // namespace isect
