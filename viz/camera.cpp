#include "viz/camera.h"

#include <Eigen/Geometry>

#include <cmath>

namespace isect::viz {
namespace {

/// An orthographic view is the limit of ever narrower perspective ones; this one looks the same already.
constexpr double nearly_orthographic = 0.5 * std::numbers::pi / 180;

double mix(double a, double b, double x) { return a + (b - a) * x; }
double mix_angle(double a, double b, double x) { return a + std::remainder(b - a, 2 * std::numbers::pi) * x; }
double opening(const Camera& c) { return c.perspective ? c.field_of_view : nearly_orthographic; }

}  // namespace

double ease_in_out(double x) { return x < 0.5 ? 4 * x * x * x : 1 - std::pow(2 - 2 * x, 3) / 2; }

Camera between(const Camera& a, const Camera& b, double x) {
  Camera c = b;
  c.target = a.target + (b.target - a.target) * x;
  c.azimuth = mix_angle(a.azimuth, b.azimuth, x);
  c.elevation = mix(a.elevation, b.elevation, x);
  c.half_height = std::exp(mix(std::log(a.half_height), std::log(b.half_height), x));
  if (a.perspective || b.perspective) {
    c.perspective = true;
    c.field_of_view = mix(opening(a), opening(b), x);
  }
  return c;
}

View::View(const Camera& camera, double width, double height, Vec2 corner)
    : camera_(camera), width_(width), height_(height), corner_(corner) {
  const double ca = std::cos(camera.azimuth), sa = std::sin(camera.azimuth);
  const double ce = std::cos(camera.elevation), se = std::sin(camera.elevation);
  const Vec3 backward = {sa * ce, se, ca * ce};  // from the target towards the eye

  forward_ = -backward;
  right_ = {ca, 0, -sa};
  up_ = backward.cross(right_);
  pixels_per_unit_ = height / (2 * camera.half_height);

  const double far_away = 1e3 * camera.half_height;
  const double distance = camera.perspective ? camera.half_height / std::tan(camera.field_of_view / 2) : far_away;
  eye_ = camera.target + distance * backward;
}

Projected View::project(const Vec3& p) const {
  const Vec3 from_eye = p - eye_;
  const double depth = from_eye.dot(forward_);
  double scale = pixels_per_unit_;
  if (camera_.perspective) scale *= (camera_.target - eye_).dot(forward_) / depth;
  const Vec3 offset = p - camera_.target;
  const Vec2 middle = corner_ + Vec2(width_ / 2, height_ / 2);
  return {middle + scale * Vec2(offset.dot(right_), -offset.dot(up_)), depth};
}

Vec3 View::towards_eye(const Vec3& p) const {
  if (!camera_.perspective) return -forward_;
  return (eye_ - p).normalized();
}

View::ViewingRay View::viewing_ray(const Vec2& pixel) const {
  const Vec2 offset = (pixel - corner_ - Vec2(width_ / 2, height_ / 2)) / pixels_per_unit_;
  const Vec3 through = camera_.target + offset.x() * right_ - offset.y() * up_;
  if (!camera_.perspective) return {through - (camera_.target - eye_).dot(forward_) * forward_, forward_};
  return {eye_, (through - eye_).normalized()};
}

Vec3 View::on_facing_plane(const Vec2& pixel, const Vec3& p) const {
  const ViewingRay line = viewing_ray(pixel);
  const double t = (p - line.origin).dot(forward_) / line.direction.dot(forward_);
  return line.origin + t * line.direction;
}

std::optional<Vec3> View::on_plane(const Vec2& pixel, const Vec3& p, const Vec3& normal) const {
  constexpr double least_slope = 0.05;  // three degrees
  const ViewingRay line = viewing_ray(pixel);
  const double rate = line.direction.dot(normal);
  if (!(std::abs(rate) > least_slope * normal.norm() * line.direction.norm())) return {};
  const double t = (p - line.origin).dot(normal) / rate;
  if (camera_.perspective && !(t > 0)) return {};
  return Vec3(line.origin + t * line.direction);
}

double View::scale_at(const Vec3& p) const {
  if (!camera_.perspective) return pixels_per_unit_;
  return pixels_per_unit_ * (camera_.target - eye_).dot(forward_) / (p - eye_).dot(forward_);
}

}  // namespace isect::viz
