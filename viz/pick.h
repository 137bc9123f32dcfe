#pragma once
// What the pointer is on: the first item along a sight line, by the core's own ray tests.

#include <optional>

#include "viz/camera.h"

namespace isect::viz {

struct Picked {
  const Item* item;
  Vec3 at;  ///< where the sight line meets it first
};

/// Among balls, solids, meshes and regions. Of those that are met at the same place the one drawn last.
std::optional<Picked> pick(const Scene&, const View::SightLine&);

}  // namespace isect::viz
