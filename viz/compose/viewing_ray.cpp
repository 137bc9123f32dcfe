#include "viz/compose/viewing_ray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <isect/clip_segment.h>

namespace isect::viz {
namespace {

/// Whether the line passes the ball around the solid by more than its possible rounding. Most lines do.
bool passes_far(const Ray<double, 3>& sight, const Shell& solid) {
  constexpr double more = 1.001;
  const double reach = more * solid.size;
  return (solid.middle - sight.origin).cross(sight.direction).squaredNorm() >
         reach * reach * sight.direction.squaredNorm();
}

}  // namespace

bool runs_through(Ray<double, 3> sight, const Shell& solid) {
  if (solid.inside.empty() || passes_far(sight, solid)) return false;
  constexpr double share = 1e-13;  // some hundred roundings
  const double speed = sight.direction.norm(), far = sight.origin.norm();
  double lo = sight.range.lo, hi = sight.range.hi, doubt = 0;
  bool parallel = false;
  const auto rate_of = [&](const Plane<double, 3>& p) { return p.normal.dot(sight.direction); };
  const auto is_parallel = [&](double rate) { return !(std::abs(rate) > 1e-6 * speed); };
  const auto t_of = [&](const Plane<double, 3>& p, double rate) { return -(p.normal.dot(sight.origin) + p.d) / rate; };
  for (const Plane<double, 3>& p : solid.inside) {
    const double rate = rate_of(p), inverse = 1 / rate, t = -(p.normal.dot(sight.origin) + p.d) * inverse;
    if (is_parallel(rate)) {
      parallel = true;
      continue;
    }
    (rate > 0 ? lo : hi) = rate > 0 ? std::max(lo, t) : std::min(hi, t);
    doubt = std::max(doubt, share * (far + std::abs(p.d) + std::abs(t) * speed) * std::abs(inverse));
  }
  if (hi < lo - 2 * doubt) return false;
  if (!parallel && hi > lo + 2 * doubt) return true;

  for (const Plane<double, 3>& p : solid.inside) {
    const double rate = rate_of(p), t = t_of(p, rate);
    if (!is_parallel(rate) && (rate > 0 ? t < lo - 2 * doubt : t > hi + 2 * doubt)) continue;
    const auto kept = clip(sight, p);
    if (!kept) return false;
    sight.range = *kept;
  }
  return sight.range.hi > sight.range.lo;
}

Vec3 doubled_area(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += (points[i] - points[0]).cross(points[i + 1] - points[0]);
  return sum;
}

bool misses(const Ray<double, 3>& sight, const Vec3& center, double radius) {
  const Vec3 ahead = center - sight.origin;
  const double far = ahead.norm(), reach = 1.001 * radius + 1e-9 * (far + sight.origin.norm());
  return ahead.cross(sight.direction).norm() > reach * sight.direction.norm() ||
         (far > reach && ahead.dot(sight.direction) < 0);
}

bool misses(const Ray<double, 3>& sight, const Polygon<double, 3>& screen) {
  if (screen.rings.empty() || screen.rings[0].empty()) return true;
  const std::vector<Vec3>& outline = screen.rings[0];
  double size = 0;
  for (const Ring<double, 3>& ring : screen.rings)
    for (const Vec3& p : ring) size = std::max(size, (p - outline[0]).norm());
  if (misses(sight, outline[0], size)) return true;

  const Vec3 ahead = outline[0] - sight.origin;
  const double speed = sight.direction.norm(), far = ahead.norm();
  const double corners = static_cast<double>(outline.size());
  const double doubt = 1e-14 * corners * corners * size * size;  // some ten roundings of each term of the normal
  const Vec3 n = doubled_area(outline);
  const double num = n.dot(ahead), den = n.dot(sight.direction);
  if (!(std::abs(den) > doubt * speed)) return false;
  const auto beyond = [&](double t) { return (num - t * den) * (den > 0 ? 1 : -1); };  // > 0: the plane is met after t
  const auto [lo, hi] = sight.range;
  return beyond(lo) < -doubt * (far + lo * speed) || (std::isfinite(hi) && beyond(hi) > doubt * (far + hi * speed));
}

}  // namespace isect::viz
