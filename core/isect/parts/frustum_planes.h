#pragma once
// The six planes of a frustum, one after the other: what the tests of all volumes share.

#include <isect/conventions.h>
#include <isect/shapes.h>

namespace isect::frustum_planes {

/// One plane: the volume lies beyond it, cuts it, or lies on its inner side, perhaps touching it.
struct Tested {
  int plane;
  Culling side;
};

namespace detail {

/// `side_of(plane)` says where the volume lies. The first plane that it lies beyond ends the test.
template <class S, class SideOf, class Trace>
Culling cull(const Frustum<S>& frustum, const SideOf& side_of, Trace&& trace) {
  Culling culling = Culling::inside;
  for (int i = 0; i < 6; ++i) {
    const Culling side = side_of(frustum.planes[i]);
    trace(Tested{i, side});
    if (side == Culling::outside) return Culling::outside;
    if (side == Culling::crossing) culling = Culling::crossing;
  }
  return culling;
}

}  // namespace detail

}  // namespace isect::frustum_planes
