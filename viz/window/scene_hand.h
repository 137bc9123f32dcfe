#pragma once
// The handles of a scene that a hand is at.

#include <optional>
#include <vector>

#include "viz/window/scene_view.h"

namespace isect::viz {

constexpr float hit_area = 14;  ///< px around a handle's middle

/// Returns where the pointer is.
inline Vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }
/// Returns the handle with the keyboard's ring.
std::optional<Handle> handle_of_keyboard(const ScenePane&);
/// Returns the handle within reach of a pixel, the nearest one of several.
std::optional<Handle> handle_near(const std::vector<Handle>&, const View&, const Vec2& pixel);

}  // namespace isect::viz
