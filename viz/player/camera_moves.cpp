#include "viz/player/camera_moves.h"

namespace isect::viz {

void orbit(Player& player, const Vec2& pixels) {
  if (player.lesson().flat) return;
  player.move_camera("orbit", [&](CameraRig& camera) { camera.orbit(pixels); });
}

void pan(Player& player, const View& view, const Vec2& from, const Vec2& to) {
  player.move_camera("pan", [&](CameraRig& camera) { camera.pan(view, from, to); });
}

void zoom(Player& player, const View& view, const Vec2& at, double factor) {
  player.move_camera("zoom", [&](CameraRig& camera) { camera.zoom(view, at, factor); });
}

void frame_all(Player& player) { player.frame(player.camera().whole(player.played(), player.shown().view)); }

void frame_shown(Player& player) {
  const Camera all = player.camera().holding(player.own_scene());
  player.move_camera("", [&](CameraRig& camera) { camera.glide(all); });
}

void set_perspective(Player& player, bool on) {
  if (player.lesson().flat || player.camera().goal().perspective == on) return;
  player.move_camera("", [&](CameraRig& camera) { camera.set_perspective(on); });
}

}  // namespace isect::viz
