#pragma once
// The item under the pointer: the first one along a viewing ray, by the core's own ray tests.

#include <optional>

#include "viz/camera.h"

namespace isect::viz {

struct Picked {
  const Item* item;
  Vec3 at;  ///< where the viewing ray hits it first
};

/// Picks among balls, solids, meshes and regions. Of items hit at the same place it returns the one drawn last.
std::optional<Picked> pick(const Scene&, const View::ViewingRay&);

}  // namespace isect::viz
