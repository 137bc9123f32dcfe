#pragma once
// A camera that a hand moves: orbit, pan, zoom at a point, and eased glides between two views.

#include <optional>

#include "viz/camera.h"

namespace isect::viz {

class CameraRig {
 public:
  /// `reduced_motion`: glides arrive at once.
  explicit CameraRig(bool reduced_motion = false) : reduced_motion_(reduced_motion) {}

  void reduce_motion(bool reduced) { reduced_motion_ = reduced; }

  /// The view at this moment, somewhere between two views while it glides.
  const Camera& now() const { return now_; }
  /// The view at which it will come to rest.
  const Camera& goal() const { return moving() ? to_ : now_; }
  bool moving() const { return left_ > 0; }

  void jump(const Camera&);
  static constexpr double usual_glide = 0.350;  ///< seconds
  /// Glides there, slow at both ends. Every moment in between is a valid camera.
  void glide(const Camera&, double seconds = usual_glide);
  void advance(double seconds);

  /// Turns by a movement of the pointer in pixels; the elevation stops at straight up and straight down.
  void orbit(const Vec2& pixels);
  /// Moves the target so that what was under `from` comes under `to`.
  void pan(const View&, const Vec2& from, const Vec2& to);
  /// Scales by `factor` (> 1: closer); the point of the target's plane under `at` stays where it is.
  void zoom(const View&, const Vec2& at, double factor);
  void set_perspective(bool);
  /// Returns the projection that was set last; none: no hand has set one.
  const std::optional<bool>& projection() const { return projection_; }
  void forget_projection() { projection_.reset(); }

 private:
  Camera now_, from_, to_;
  double whole_ = 1, left_ = 0;  ///< seconds of the glide, and of those still to come
  bool reduced_motion_;
  std::optional<bool> projection_;
};

}  // namespace isect::viz
