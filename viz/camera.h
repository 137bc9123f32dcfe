#pragma once
// Where the viewer stands. y is up; azimuth turns about y, elevation lifts the eye; angles in radians.

#include <numbers>
#include <optional>

#include "viz/scene.h"

namespace isect::viz {

struct Camera {
  Vec3 target = Vec3::Zero();                      ///< the point in the middle of the picture
  double azimuth = 30 * std::numbers::pi / 180;    ///< 0: the eye on +z; positive: towards +x
  double elevation = 22 * std::numbers::pi / 180;  ///< in [-pi/2, pi/2]
  double half_height = 3;                          ///< world units from the middle to the top edge, at the target
  bool perspective = false;
  double field_of_view = 35 * std::numbers::pi / 180;  ///< vertical, for perspective
  bool operator==(const Camera&) const = default;
};

/// Where a step is seen from in a way of its own.
struct StepView {
  Camera camera;
  bool has_target = false, has_half_height = false;  ///< what the camera says of them counts; else the walk is framed
  bool operator==(const StepView&) const = default;
};

/// Returns the course of a glide from 0 to 1, slow at both ends.
double ease_in_out(double share);
/// Returns the camera `share` of the way from one to the other: `from` at 0, `to` at 1. Each on the way is a valid one;
/// azimuth takes the shorter way.
Camera between(const Camera& from, const Camera& to, double share);

/// A point on the picture: pixels from the top left corner (y down), and the distance along the view direction.
struct Projected {
  Vec2 at;
  double depth = 0;
};

/// A camera looking at a viewport of width x height pixels whose top left corner lies at `corner`.
class View {
 public:
  View(const Camera&, double width, double height, Vec2 corner = Vec2::Zero());

  /// Returns where `p` appears. In perspective, points at or behind the eye have depth <= 0.
  Projected project(const Vec3& p) const;
  /// Returns the unit vector from `p` towards the eye.
  Vec3 towards_eye(const Vec3& p) const;
  /// The viewing ray through a pixel: a point on it and its unit direction away from the eye.
  struct ViewingRay {
    Vec3 origin, direction;
  };
  ViewingRay viewing_ray(const Vec2& pixel) const;
  /// Returns the point under `pixel` on the plane through `p` that faces the viewer: where a dragged handle goes.
  Vec3 on_facing_plane(const Vec2& pixel, const Vec3& p) const;
  /// Returns the point on the plane through `p` with this normal, of any length; none where the plane is seen so nearly
  /// edge-on that a pixel fixes no point, or where the point lies behind the eye.
  std::optional<Vec3> on_plane(const Vec2& pixel, const Vec3& p, const Vec3& normal) const;
  /// Pixels per world unit at `p`, across the view direction.
  double scale_at(const Vec3& p) const;

  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 forward() const { return forward_; }  ///< away from the viewer
  Vec3 eye() const { return eye_; }          ///< far away when orthographic
  const Camera& camera() const { return camera_; }
  double width() const { return width_; }
  double height() const { return height_; }
  Vec2 corner() const { return corner_; }

 private:
  Camera camera_;
  double width_, height_;
  Vec2 corner_;
  Vec3 right_, up_, forward_, eye_;
  double pixels_per_unit_;
};

}  // namespace isect::viz
