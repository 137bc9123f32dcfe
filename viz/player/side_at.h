#pragma once
// The side of an outline that a pointer is at.

#include <optional>
#include <vector>

#include "viz/camera.h"
#include "viz/scene_editor.h"

namespace isect::viz {

/// A place on a side.
struct PlaceOnSide {
  SceneSide side;
  Vec3 at;
};
/// Returns the side that passes nearest to a pixel, and its place that is seen there; none if all pass by further than
/// `reach`, in pixels, or have an end behind the eye.
std::optional<PlaceOnSide> side_at(const std::vector<SceneSide>&, const View&, const Vec2& pixel, double reach);

}  // namespace isect::viz
