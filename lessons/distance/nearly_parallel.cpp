// Nearly parallel segments: their distance is well-conditioned, their nearest points are not.

#include <cmath>

#include "lessons/distance/telling.h"

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

constexpr double small_angle2 = 1e-3;  ///< the square of its sine
constexpr double a_jump = 20;          ///< times as far as the end has moved

}  // namespace

std::optional<Tilt> tilted_back(const Segment3& a, const Segment3& b) {
  using Record3 = Record<nearest_features::SegmentEvent<double, 3>>;
  Record3 before, after;
  const double d = std::sqrt(nearest_features::distance2<double, 3>(a, b, before));
  const auto& lines = std::get<nearest_features::Lines<double>>(before.events.front());
  const Vec3 u = a.q - a.p, v = b.q - b.p;
  if (lines.parallel || lines.determinant > small_angle2 * u.squaredNorm() * v.squaredNorm()) return {};

  const Vec3 aside = v - v.dot(u) / u.squaredNorm() * u;
  const Segment3 other = {b.p, b.q - 2 * aside};
  const double turned = std::sqrt(nearest_features::distance2<double, 3>(a, other, after));
  using Closest = nearest_features::Closest<double, 3>;
  const auto &here = std::get<Closest>(before.events.back()), &there = std::get<Closest>(after.events.back());
  const Tilt tilt = {{here.on_a, here.on_b},
                     {there.on_a, there.on_b},
                     (other.q - b.q).norm(),
                     (here.on_a - there.on_a).norm(),
                     std::abs(d - turned)};
  if (!(tilt.jump > a_jump * tilt.moved && tilt.change <= tilt.moved)) return {};
  return tilt;
}

}  // namespace isect::lessons::distance_lesson
