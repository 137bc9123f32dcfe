#pragma once
// What the pointer is on: the first item along a viewing ray, by the core's own ray tests.

#include <optional>

#include "viz/camera.h"

namespace isect::viz {

struct Picked {
  const Item* item;
  Vec3 at;  ///< where the viewing ray meets it first
};

/// Among balls, solids, meshes and regions. Of those that are met at the same place the one drawn last.
std::optional<Picked> pick(const Scene&, const View::ViewingRay&);

}  // namespace isect::viz
