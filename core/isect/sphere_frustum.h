#pragma once
// Sphere against view frustum: what a renderer asks before it draws.
//
// The frustum is the common part of six half-spaces n.x + d >= 0. A ball that lies beyond one of the planes is
// outside, one that no plane cuts is inside. Between the two it may be visible or not: near an edge a ball can cut
// two planes and miss what they have in common. To draw too much is harmless, so that is left undecided, and only
// that: on which side of a plane the ball lies is exact. Source: the note, N01 (view-volume culling); Akenine-Moller,
// Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.13.

#include <variant>

#include <isect/parts/frustum_planes.h>
#include <isect/plane_sphere.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_frustum {

using frustum_planes::Tested;
using Event = std::variant<Tested, plane_sphere::Decision, Fallback>;

namespace detail {

/// Where the ball lies with respect to n.x + d >= 0, by that inequality even where the normal is 0. Finite arguments.
template <class S, class Trace>
Culling side(const Plane<S, 3>& plane, const Sphere<S, 3>& sphere, Trace&& trace) {
  const plane_sphere::Decision signs = plane_sphere::detail::decide(plane, sphere, trace);
  if (signs.center < 0 && signs.clear > 0) return Culling::outside;
  return signs.center >= 0 && signs.clear >= 0 ? Culling::inside : Culling::crossing;
}

}  // namespace detail

}  // namespace sphere_frustum

/// outside: for certain, the ball lies beyond one plane. inside: for certain and exactly, the frustum contains the
/// ball, inner tangency included. crossing: neither; the ball may still be outside. A plane with a zero normal bounds
/// nothing, or everything when its d < 0. An empty ball, NaN or an infinite coordinate: outside.
template <class S, class Trace = NoTrace>
Culling cull(const Sphere<S, 3>& sphere, const Frustum<S>& frustum, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere) || !finite(frustum)) return Culling::outside;

  const auto side_of = [&](const Plane<S, 3>& plane) { return sphere_frustum::detail::side(plane, sphere, trace); };
  return frustum_planes::detail::cull(frustum, side_of, trace);
}

}  // namespace isect
