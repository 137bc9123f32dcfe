#include "viz/visibility.h"

#include <cmath>
#include <functional>

#include "core/ray_sphere.h"

namespace isect::viz {
namespace {

/// Samples a curve over s in [0, 1], finds each change between visible and hidden by bisection, and cuts there.
std::vector<Stretch> split(const std::function<Vec3(double)>& at,
                           const std::function<bool(const Vec3&)>& is_hidden, int samples) {
  std::vector<Stretch> result;
  double s = 0;
  bool now = is_hidden(at(0));
  result.push_back({{at(0)}, now});
  for (int i = 1; i <= samples; ++i) {
    const double next_s = static_cast<double>(i) / samples;
    const bool next = is_hidden(at(next_s));
    if (next != now) {
      double lo = s, hi = next_s;
      for (int k = 0; k < 40; ++k) {
        const double middle = (lo + hi) / 2;
        (is_hidden(at(middle)) == now ? lo : hi) = middle;
      }
      result.back().points.push_back(at(lo));
      result.push_back({{at(lo)}, next});
    }
    result.back().points.push_back(at(next_s));
    s = next_s, now = next;
  }
  return result;
}

}  // namespace

bool hidden(const Vec3& p, const View& view, const std::vector<Ball>& balls, int own) {
  const Vec3 direction = view.towards_eye(p);
  const Ray<double, 3> sight = {
      p, direction, {0, view.camera().perspective ? (view.eye() - p).norm() : HUGE_VAL}};
  for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
    if (i == own) continue;
    // A point computed on the surface may lie a rounding inside it: the ball is drawn that much smaller here.
    const Sphere<double, 3> solid = {balls[i].center, balls[i].radius * (1 - 0x1p-30)};
    const RaySphere<double> shared = intersect(sight, solid);
    if (shared && shared.solid->hi > shared.solid->lo) return true;
  }
  return false;
}

std::vector<Stretch> stretches(const Vec3& from, const Vec3& to, const View& view,
                               const std::vector<Ball>& balls) {
  const auto at = [&](double s) -> Vec3 { return from + s * (to - from); };
  std::vector<Stretch> parts = split(
      at, [&](const Vec3& p) { return hidden(p, view, balls); }, 64);
  for (Stretch& part : parts) part.points = {part.points.front(), part.points.back()};
  return parts;
}

std::vector<Stretch> stretches(const Vec3& center, const Vec3& u, const Vec3& v, const View& view,
                               const std::vector<Ball>& balls, int own) {
  const auto at = [&](double s) -> Vec3 {
    const double angle = 2 * std::numbers::pi * s;
    return center + std::cos(angle) * u + std::sin(angle) * v;
  };
  const auto is_hidden = [&](const Vec3& p) {
    if (own >= 0 && (p - balls[own].center).dot(view.towards_eye(p)) < 0) return true;
    return hidden(p, view, balls, own);
  };
  return split(at, is_hidden, 96);
}

Outline outline(const Ball& ball, const View& view) {
  const Vec2 middle = view.project(ball.center).at;
  if (!view.camera().perspective) {
    const double r = ball.radius * view.scale_at(ball.center);
    return {middle, {r, 0}, {0, r}};
  }

  // The tangent cone of half angle alpha, its axis at theta to the view direction, is cut by the picture plane in an
  // ellipse of eccentricity sin theta / cos alpha, between tan(theta - alpha) and tan(theta + alpha).
  const Vec3 to_center = ball.center - view.eye();
  const double distance = to_center.norm(), along = to_center.dot(view.forward());
  const double alpha = std::asin(std::min(1.0, ball.radius / distance)), theta = std::acos(along / distance);
  const double focal = view.scale_at(view.camera().target) * (view.camera().target - view.eye()).norm();
  const double near = focal * std::tan(theta - alpha), far = focal * std::tan(theta + alpha);
  const double e = std::sin(theta) / std::cos(alpha), a = (far - near) / 2;

  const Vec2 axis =
      view.corner() + Vec2(view.width() / 2, view.height() / 2);  // where the view direction meets it
  const Vec2 outwards = (middle - axis).norm() > 1e-9 ? Vec2((middle - axis).normalized()) : Vec2(1, 0);
  const Vec2 across = {-outwards.y(), outwards.x()};
  return {axis + (near + far) / 2 * outwards, a * outwards, a * std::sqrt(std::max(0.0, 1 - e * e)) * across};
}

}  // namespace isect::viz
