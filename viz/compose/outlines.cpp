#include "viz/compose/outlines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <isect/convex_hull.h>

namespace isect::viz {

Rim rim(const Ball& ball, const View& view) {
  const Vec3 n = view.towards_eye(ball.center);
  Rim result = {ball.center, {}, {}};
  double radius = ball.radius;
  if (view.camera().perspective) {
    const double share = ball.radius / (view.eye() - ball.center).norm();
    result.middle += share * ball.radius * n;
    radius *= std::sqrt(1 - share * share);
  }
  result.u = radius * n.cross(view.up()).normalized();
  result.v = n.cross(result.u);
  return result;
}

std::vector<Vec3> outline(const Capsule<double, 3>& capsule, const View& view) {
  constexpr int corners = 96;  // of each end's rim
  std::vector<Vec3> points;
  for (const Vec3& end : {capsule.p, capsule.q}) {
    const Rim circle = rim({end, capsule.radius}, view);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      points.push_back(circle.middle + std::cos(angle) * circle.u + std::sin(angle) * circle.v);
    }
  }
  std::vector<Vec2> seen;
  for (const Vec3& p : points) seen.push_back(view.project(p).at);
  std::vector<Vec3> chain;
  for (const Vec2& corner : convex_hull(seen)) chain.push_back(points[std::ranges::find(seen, corner) - seen.begin()]);
  return chain;
}

Outline outline(const Ball& ball, const View& view) {
  const Vec2 middle = view.project(ball.center).at;
  if (!view.camera().perspective) {
    const double r = ball.radius * view.scale_at(ball.center);
    return {middle, {r, 0}, {0, r}};
  }

  // The picture plane cuts the tangent cone of half angle alpha, its axis at theta to the view direction, in an ellipse
  // of eccentricity sin theta / cos alpha, between tan(theta - alpha) and tan(theta + alpha).
  const Vec3 to_center = ball.center - view.eye();
  const double distance = to_center.norm(), along = to_center.dot(view.forward());
  const double alpha = std::asin(std::min(1.0, ball.radius / distance)), theta = std::acos(along / distance);
  const double focal = view.scale_at(view.camera().target) * (view.camera().target - view.eye()).norm();
  const double near = focal * std::tan(theta - alpha), far = focal * std::tan(theta + alpha);
  const double e = std::sin(theta) / std::cos(alpha), a = (far - near) / 2;

  const Vec2 axis = view.corner() + Vec2(view.width() / 2, view.height() / 2);  // where the view direction meets it
  const Vec2 outwards = (middle - axis).norm() > 1e-9 ? Vec2((middle - axis).normalized()) : Vec2(1, 0);
  const Vec2 across = {-outwards.y(), outwards.x()};
  return {axis + (near + far) / 2 * outwards, a * outwards, a * std::sqrt(std::max(0.0, 1 - e * e)) * across};
}

}  // namespace isect::viz
