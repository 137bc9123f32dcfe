// Cases that are drawn as outlines: boxes, triangles, points beside a line, polygons.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lessons/speed_against_error/drawings.h"

namespace isect::lessons::speed_against_error_lesson {

namespace {

using Obb3 = Obb<double, 3>;

/// How far the boxes are apart along a unit axis; negative if they overlap there.
double gap_along(const viz::Vec3& axis, const Obb3& a, const Obb3& b) {
  const auto reach = [&](const Obb3& x) { return (x.axes.transpose() * axis).cwiseAbs().dot(x.half); };
  return std::abs(axis.dot(b.center - a.center)) - reach(a) - reach(b);
}

/// The unit axis of the separating-axis test with the largest gap.
viz::Vec3 widest_gap(const Obb3& a, const Obb3& b) {
  std::vector<viz::Vec3> axes;
  for (int i = 0; i < 3; ++i) {
    axes.emplace_back(a.axes.col(i)), axes.emplace_back(b.axes.col(i));
    for (int j = 0; j < 3; ++j)
      if (const viz::Vec3 n = a.axes.col(i).cross(b.axes.col(j)); n.norm() > 1e-3) axes.emplace_back(n.normalized());
  }
  return *std::ranges::max_element(axes, {}, [&](const viz::Vec3& axis) { return gap_along(axis, a, b); });
}

/// Upwards in a picture in which `right` runs to the right: where the box is long, as far as that is across.
viz::Vec3 along_its_length(const Obb3& x, const viz::Vec3& right) {
  int longest = 0;
  x.half.maxCoeff(&longest);
  const viz::Vec3 up = x.axes.col(longest) - x.axes.col(longest).dot(right) * right;
  return up.norm() > 0.3 ? viz::Vec3(up.normalized()) : right.unitOrthogonal();
}

}  // namespace

Drawn drawing(const std::string& family, const Obb3& a, const Obb3& b) {
  const bool slender = family == "slender";
  if (!slender && std::min(a.half.minCoeff(), b.half.minCoeff()) < 0.2 * std::max(a.half.maxCoeff(), b.half.maxCoeff()))
    return {};
  viz::Vec3 right = widest_gap(a, b);
  if (right.dot(b.center - a.center) < 0) right = -right;
  const double gap = gap_along(right, a, b);
  if (family == "exact-touch" && std::abs(gap) > 1e-9) return {};

  const viz::Vec3 up = along_its_length(a, right);
  Drawing d;
  for (const Obb3* box : {&a, &b}) {
    std::array<viz::Vec2, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const viz::Vec3 signs = {(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0};
      const viz::Vec3 corner = box->center - a.center + box->axes * box->half.cwiseProduct(signs);
      corners[i] = {right.dot(corner), up.dot(corner)};
    }
    shadow(corners).draw(d.sketch, box == &a ? viz::Role::first : viz::Role::second);
  }
  if (slender) d.sketch.stretch();
  d.note = slender ? about(2 * a.half.minCoeff()) + " thick" : is_about("gap", gap);
  return d;
}

Drawn drawing(const std::string& family, const Ray<double, 3>& ray, const Triangle<double, 3>& triangle) {
  const auto& [p, q, r] = triangle.vertices;
  const viz::Vec3 direction = ray.direction.normalized();
  const viz::Vec3 cross = (q - p).cross(r - p);
  const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()}), twice = cross.norm();
  const bool needle = family == "needle", in_plane = family == "near-coplanar";
  if (!needle && twice < 0.2 * longest * longest) return {};
  const viz::Vec3 n = cross.normalized();
  const viz::Vec3 right =
      in_plane ? viz::Vec3((direction - direction.dot(n) * n).normalized()) : direction.unitOrthogonal();
  const viz::Vec3 up = in_plane ? n.cross(right) : direction.cross(right);

  std::vector<viz::Vec2> corners;
  double end = 0;
  for (const Point<double, 3>& v : triangle.vertices) {
    const viz::Vec3 from_eye = v - ray.origin;
    corners.emplace_back(right.dot(from_eye), up.dot(from_eye));
    end = std::max(end, 1.15 * corners.back().x());
  }
  Drawing d;
  d.sketch.ring(corners, viz::Role::second);
  if (in_plane) d.sketch.arrow({0, 0}, {end, 0}, viz::Role::first);
  d.sketch.dot({0, 0}, viz::Role::first);
  if (needle) d.sketch.stretch();
  if (needle) d.note = about(twice / longest) + " high";
  if (in_plane) d.note = about(std::abs(n.dot(ray.origin - p))) + " off it";
  if (family == "far") d.note = about(p.norm()) + " away";
  return d;
}

Drawn drawing(const std::string& family, const std::array<Point<double, 2>, 3>& points) {
  double unit = 0;
  for (const Point<double, 2>& p : points) unit = std::max(unit, p.cwiseAbs().maxCoeff());
  std::array<viz::Vec2, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = points[i] / unit;
  std::size_t first = 0, last = 1;  // of the three, those farthest apart
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 2}, {1, 2}})
    if ((at[j] - at[i]).norm() > (at[last] - at[first]).norm()) first = i, last = j;
  const viz::Vec2 across = at[last] - at[first];
  if (!(across.norm() > 0.5)) return {};
  Drawing d;
  d.sketch.line(at[first] - 0.15 * across, at[last] + 0.15 * across, viz::Role::construction);
  const std::size_t asked = family.starts_with("Kettner") ? 0 : 2;
  for (std::size_t i = 0; i < 3; ++i) d.sketch.dot(at[i], i == asked ? viz::Role::first : viz::Role::second);
  if (family == "range") d.note = is_about("size", unit);
  if (family == "small beside large") d.note = is_about("sizes", points[0].norm(), points[2].norm());
  return d;
}

Drawn drawing(const std::string& family, const Point<double, 2>& p, const Ring<double, 2>& ring) {
  std::vector<viz::Vec2> corners;
  viz::Vec2 lo = viz::Vec2::Zero(), hi = lo;
  for (const Point<double, 2>& v : ring) {
    corners.emplace_back(v - ring[0]);
    lo = lo.cwiseMin(corners.back()), hi = hi.cwiseMax(corners.back());
  }
  const viz::Vec2 size = hi - lo;
  if (!(size.minCoeff() > 0.25 * size.maxCoeff())) return {};
  Drawing d;
  d.sketch.ring(corners, viz::Role::second, true);
  d.sketch.dot(p - ring[0], viz::Role::first);
  if (family.starts_with("far")) d.note = about(ring[0].x()) + " away";
  return d;
}

}  // namespace isect::lessons::speed_against_error_lesson
