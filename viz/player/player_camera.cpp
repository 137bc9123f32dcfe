// The camera of a player's reader.

#include "viz/compose/compose.h"
#include "viz/player/player.h"

namespace isect::viz {
namespace {

std::vector<const Scene*> scenes_of(const Walk& walk) {
  std::vector<const Scene*> scenes;
  for (const Step& s : walk.steps) scenes.push_back(&s.scene);
  return scenes;
}

}  // namespace

Camera Player::opening_view() const {
  if (beside_) {
    std::vector<const Scene*> scenes = scenes_of(walk());
    for (const Scene* scene : scenes_of(*beside_)) scenes.push_back(scene);
    return frame(opening(lesson()), scenes, aspect_);
  }
  return closer(frame_alike(opening(lesson()), walk(), overview_->samples, aspect_), scene(), aspect_);
}

void Player::look() {
  if (!moved_) camera_.glide(opening_view(), seconds_to_move);
}

void Player::set_aspect(double aspect) {
  if (aspect == aspect_) return;
  all_or_nothing([&](Player& next) {
    next.aspect_ = aspect;
    if (!moved_) next.camera_.jump(next.opening_view());
  });
}

void Player::orbit(const Vec2& pixels) {
  if (lesson().flat) return;
  remember("orbit");
  camera_.orbit(pixels);
  moved_ = true;
}

void Player::pan(const View& view, const Vec2& from, const Vec2& to) {
  remember("pan");
  camera_.pan(view, from, to);
  moved_ = true;
}

void Player::zoom(const View& view, const Vec2& at, double factor) {
  remember("zoom");
  camera_.zoom(view, at, factor);
  moved_ = true;
}

void Player::frame_all() {
  Camera from = opening(lesson());
  from.perspective = camera_.goal().perspective;
  const Camera framed = frame(from, scenes_of(walk()), aspect_);
  remember("");
  camera_.glide(framed);
  moved_ = true;
}

void Player::set_perspective(bool on) {
  if (lesson().flat || camera_.goal().perspective == on) return;
  remember("");
  camera_.set_perspective(on);
  moved_ = true;
}

}  // namespace isect::viz
