// Cases with a ball: beside another one, a box, a ray.

#include "lessons/speed_against_error/drawings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isect::lessons::speed_against_error_lesson {

using viz::Vec2;
using viz::Vec3;

namespace {

using Sphere3 = Sphere<double, 3>;

bool whole(const Sphere3& x) { return x.center.allFinite() && std::isfinite(x.radius) && x.radius >= 0; }
bool whole(const Aabb<double, 3>& x) {
  return x.lo.allFinite() && x.hi.allFinite() && (x.lo.array() <= x.hi.array()).all();
}

/// What is wrong with a ball, as a note.
std::string spoilt(const Sphere3& x) {
  if (std::isnan(x.radius) || x.center.hasNaN()) return "the other: not a number";
  if (std::isinf(x.radius) || !x.center.allFinite()) return "the other: ∞";
  return "the other: *r* < 0";
}
std::string spoilt(const Aabb<double, 3>& x) {
  if (x.lo.hasNaN() || x.hi.hasNaN()) return "the box: not a number";
  return x.lo.allFinite() && x.hi.allFinite() ? "the box: ends exchanged" : "the box: ∞";
}

Drawing alone(const Sphere3& x, viz::Role role, const std::string& note) {
  Drawing d;
  d.sketch.circle({0, 0}, x.radius, role);
  d.note = note;
  return d;
}

}  // namespace

Drawn drawing(const std::string&, const Sphere3& a, const Sphere3& b) {
  if (!whole(a)) return alone(b, viz::Role::second, spoilt(a));
  if (!whole(b)) return alone(a, viz::Role::first, spoilt(b));
  const Vec3 apart = b.center - a.center;
  const double unit = std::max({a.radius, b.radius, apart.cwiseAbs().maxCoeff()});
  const double r = a.radius / unit, s = b.radius / unit;
  if (!(std::min(r, s) > 0.3 * std::max(r, s))) return {};
  Drawing d;
  d.sketch.circle({0, 0}, r, viz::Role::first);
  d.sketch.circle({(apart / unit).norm(), 0}, s, viz::Role::second);
  d.note = is_about("*r*", a.radius, b.radius);
  return d;
}

Drawn drawing(const std::string&, const Sphere3& ball, const Aabb<double, 3>& box) {
  if (!whole(ball)) {
    Drawing d;
    d.sketch.ring({{0, 0}, {box.hi.x() - box.lo.x(), 0}, (box.hi - box.lo).head<2>(), {0, box.hi.y() - box.lo.y()}},
                  viz::Role::second);
    d.note = spoilt(ball);
    return d;
  }
  if (!whole(box)) return alone(ball, viz::Role::first, spoilt(box));
  const double unit =
      std::max({ball.radius, (box.hi - box.lo).maxCoeff(), (ball.center - box.lo).cwiseAbs().maxCoeff()});
  const Vec3 size = (box.hi - box.lo) / unit, center = (ball.center - box.lo) / unit;
  const double r = ball.radius / unit;
  const bool small = size.maxCoeff() < 0.05 * r;  // beside it, the ball's surface looks flat
  if (!(small ? size.minCoeff() > 0.3 * size.maxCoeff() : r > 0.1 && size.minCoeff() > 0.15)) return {};

  // Seen across the way to the nearest point: then a gap between the two is a gap in the picture.
  const Vec3 nearest = center.cwiseMax(0).cwiseMin(size), way = center - nearest;
  const Vec3 right = way.norm() > 1e-6 ? Vec3(way.normalized()) : Vec3(Vec3::UnitX()), up = right.unitOrthogonal();
  std::array<Vec2, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 corner = {(i & 1) != 0 ? size.x() : 0, (i & 2) != 0 ? size.y() : 0, (i & 4) != 0 ? size.z() : 0};
    corners[i] = {right.dot(corner - nearest), up.dot(corner - nearest)};
  }
  Drawing d;
  shadow(corners).draw(d.sketch, viz::Role::second);
  if (small) {
    const double reach = size.maxCoeff(), gap = way.norm() - r;
    d.sketch.ring({{gap, -reach}, {gap + reach, -reach}, {gap + reach, reach}, {gap, reach}}, viz::Role::first);
  } else {
    d.sketch.circle({way.norm(), 0}, r, viz::Role::first);
  }
  d.note = is_about("*r*", ball.radius);
  return d;
}

namespace {

/// An eye a little above a ball as large as a planet: what is near the eye, in heights.
Drawn above_ground(const Vec3& to_center, double radius, const Vec3& direction) {
  const Vec3 up = -to_center.normalized();
  const double height = to_center.norm() - radius, rise = direction.dot(up);
  if (!(height > 0 && height < 1e-3 * radius && std::abs(rise) < 0.8)) return {};
  Drawing d;
  d.sketch.ring({{-1, -1}, {3, -1}, {3, -1.5}, {-1, -1.5}}, viz::Role::second);
  d.sketch.arrow({0, 0}, 1.8 * Vec2((direction - rise * up).norm(), rise), viz::Role::first);
  d.sketch.dot({0, 0}, viz::Role::first);
  d.note = is_about("*r*", radius / height) + " heights";
  return d;
}

}  // namespace

Drawn drawing(const std::string& family, const Ray<double, 3>& ray, const Sphere3& ball) {
  const Vec3 direction = ray.direction.stableNormalized(), to_center = ball.center - ray.origin;
  if (family == "planet") return above_ground(to_center, ball.radius, direction);

  // In the plane of ray and centre: s along the ray, m aside.
  const double unit = std::max(to_center.cwiseAbs().maxCoeff(), ball.radius);
  const Vec3 l = to_center / unit;
  const double s = l.dot(direction), m = (l - s * direction).norm(), r = ball.radius / unit;
  Drawing d;
  d.sketch.dot({0, 0}, viz::Role::first);
  if (family == "far-small") {
    if (!(s > 0.9 && r < 1e-3)) return {};
    d.sketch.arrow({0, 0}, {1.2, 0}, viz::Role::first);
    d.sketch.dot({s, m}, viz::Role::second);
    d.note = about(s / r) + " radii away";
    return d;
  }
  if (family == "zero-radius") {
    if (!(s > 0.5 && r == 0)) return {};
    d.sketch.arrow({0, 0}, {s + 0.4, 0}, viz::Role::first);
    d.sketch.dot({s, m}, viz::Role::second);
    d.note = "*r* = 0";
    return d;
  }
  if (!(r > 0.2 && s > 0.3)) return {};
  d.sketch.circle({s, m}, r, viz::Role::second);
  d.sketch.arrow({0, 0}, {s + 1.3 * r, 0}, viz::Role::first);
  if (family == "near-tangent") d.note = is_about("*m* / *r* − 1", (m - r) / r);
  if (family == "direction-length") d.note = is_about("|**d**|", ray.direction.stableNorm());
  return d;
}

}  // namespace isect::lessons::speed_against_error_lesson
