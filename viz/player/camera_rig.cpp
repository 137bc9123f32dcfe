#include "viz/player/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isect::viz {
namespace {

constexpr double radians_per_pixel = 0.008;

}  // namespace

void CameraRig::jump(const Camera& camera) {
  now_ = camera;
  left_ = 0;
}

void CameraRig::glide(const Camera& camera, double seconds) {
  if (reduced_motion_) return jump(camera);
  from_ = now_;
  to_ = camera;
  whole_ = left_ = seconds;
}

void CameraRig::advance(double seconds) {
  if (!moving()) return;
  left_ = std::max(0.0, left_ - seconds);
  now_ = moving() ? between(from_, to_, ease_in_out(1 - left_ / whole_)) : to_;
}

void CameraRig::orbit(const Vec2& pixels) {
  jump(goal());
  now_.azimuth = std::remainder(now_.azimuth - pixels.x() * radians_per_pixel, 2 * std::numbers::pi);
  now_.elevation =
      std::clamp(now_.elevation + pixels.y() * radians_per_pixel, -std::numbers::pi / 2, std::numbers::pi / 2);
}

void CameraRig::pan(const View& view, const Vec2& from, const Vec2& to) {
  jump(goal());
  now_.target += view.on_facing_plane(from, now_.target) - view.on_facing_plane(to, now_.target);
}

void CameraRig::zoom(const View& view, const Vec2& at, double factor) {
  jump(goal());
  const Vec3 fixed = view.on_facing_plane(at, now_.target);
  const double half_height = std::clamp(now_.half_height / factor, 1e-290, 1e290);
  now_.target = fixed + (now_.target - fixed) * (half_height / now_.half_height);
  now_.half_height = half_height;
}

void CameraRig::set_perspective(bool on) {
  projection_ = on;
  Camera camera = goal();
  camera.perspective = on;
  glide(camera);
}

}  // namespace isect::viz
