#include "viz/player/dragging.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace isect::viz {
namespace {

Moved refused_by(const Condition* forbids) {
  return {{}, forbids ? "That is not allowed; give " + forbids->allowed : std::string()};
}

/// Returns the point of the handle's line that is nearest to the viewing ray, unless the line points to the viewer:
/// then a pixel fixes no point of it.
std::optional<Vec3> on_line(const View& view, const Handle& handle, const Vec2& pixel) {
  constexpr double least = 0.02;  // the square of a sine
  const View::ViewingRay ray = view.viewing_ray(pixel);
  const Vec3 along = handle.direction.stableNormalized(), from = ray.origin - handle.at;
  const double cosine = along.dot(ray.direction), sine2 = 1 - cosine * cosine;
  if (!(sine2 > least)) return {};
  return handle.at + (from.dot(along) - cosine * from.dot(ray.direction)) / sine2 * along;
}

}  // namespace

Vec3 brought(const View& view, const Handle& handle, const Vec2& pixel) {
  if (handle.kind == Handle::Kind::on_line)
    if (const std::optional<Vec3> place = on_line(view, handle, pixel)) return *place;
  if (handle.kind != Handle::Kind::plane && handle.kind != Handle::Kind::on_plane)
    return view.on_facing_plane(pixel, handle.at);
  return view.on_plane(pixel, handle.at, handle.direction.cross(handle.across)).value_or(handle.at);
}

const Handle* same_handle(const Scene& scene, const Handle& handle) {
  const auto found = std::ranges::find_if(
      scene.handles, [&](const Handle& h) { return h.id() == handle.id() && h.kind == handle.kind; });
  return found == scene.handles.end() ? nullptr : &*found;
}

Moved Snap::settle(Player& player) {
  while (search_.go_on()) continue;
  if (!search_.found()) return otherwise_(player);
  player.set_parameters(search_.found()->setting);
  return {search_.found()->told};
}

Snap snapping_drag(const Player& player, const Handle& handle, const Vec3& start, const Vec3& to) {
  const Way way = way_of(player.lesson(), player.parameters(), handle, start, to);
  return {BorderSearch(player.lesson(), way, 0, 1.25, 1,
                       landmarks(player.lesson(), player.parameters(), handle, start, to, player.scene(), 1)),
          [handle, to](Player& moved) { return refused_by(moved.drag_handle(handle, to)); }};
}

Snap snapping_nudge(const Player& player, const View& view, const Handle& handle, const Vec2& way) {
  constexpr double search = 600;  // px
  const Vec3 far = brought(view, handle, view.project(handle.at).at + search * way);
  return {
      BorderSearch(player.lesson(), way_of(player.lesson(), player.parameters(), handle, handle.at, far), 1 / search, 1,
                   0, landmarks(player.lesson(), player.parameters(), handle, handle.at, far, player.scene(), 0)),
      [](Player&) { return Moved{"The case does not change that way"}; }};
}

Moved drag_to(Player& player, const Handle& handle, const Vec3& start, const Vec3& to, bool snapping) {
  if (snapping) return snapping_drag(player, handle, start, to).settle(player);
  return refused_by(player.drag_handle(handle, to));
}

Moved nudge(Player& player, const View& view, const Handle& handle, const Vec2& way, bool snapping) {
  constexpr double step = 8;  // px
  player.remember((snapping ? "snap " : "nudge ") + handle.id());
  if (snapping) return snapping_nudge(player, view, handle, way).settle(player);
  Vec3 to = brought(view, handle, view.project(handle.at).at + step * way);
  const double rounding = 1e-9 * (to - handle.at).norm();  // of a view: coordinates that are not meant to move stay
  for (int i = 0; i < 3; ++i)
    if (std::abs(to[i] - handle.at[i]) <= rounding) to[i] = handle.at[i];
  return refused_by(player.drag_handle(handle, to));
}

}  // namespace isect::viz
