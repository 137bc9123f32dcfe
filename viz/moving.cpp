#include "viz/moving.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace isect::viz {
namespace {

Moved refused_by(const Condition* forbids) {
  return {{}, forbids ? "That does not do; give " + forbids->allowed : std::string()};
}

}  // namespace

Vec3 brought(const View& view, const Handle& handle, const Vec2& pixel) {
  if (handle.kind != Handle::Kind::plane) return view.on_facing_plane(pixel, handle.at);
  return view.on_plane(pixel, handle.at, handle.direction.cross(handle.across)).value_or(handle.at);
}

const Handle* same_handle(const Scene& scene, const Handle& handle) {
  const auto found = std::ranges::find_if(
      scene.handles, [&](const Handle& h) { return h.parameter == handle.parameter && h.kind == handle.kind; });
  return found == scene.handles.end() ? nullptr : &*found;
}

Moved drag_to(Player& player, const Handle& handle, const Vec3& start, const Vec3& to, bool snapping) {
  if (snapping) {
    const Way way = way_of(player.lesson(), player.parameters(), handle, start, to);
    if (const std::string told = player.snap_on(way, 0, 1.25, 1); !told.empty()) return {told};
  }
  return refused_by(player.drag_handle(handle, to));
}

Moved nudge(Player& player, const View& view, const Handle& handle, const Vec2& way, bool snapping) {
  constexpr double step = 8, search = 600;  // px
  const auto beside = [&](double px) { return brought(view, handle, view.project(handle.at).at + px * way); };
  player.remember((snapping ? "snap " : "nudge ") + handle.parameter);
  if (!snapping) return refused_by(player.drag_handle(handle, beside(step)));
  const Way on = way_of(player.lesson(), player.parameters(), handle, handle.at, beside(search));
  const std::string told = player.snap_on(on, 1 / search, 1, 0);
  return {told.empty() ? "The case does not change that way" : told};
}

}  // namespace isect::viz
