// All cases of a ray and a sphere in the plane of two numbers, and the methods side by side.

#include <Eigen/Geometry>
#include <cmath>

#include <isect/methods/ray_sphere.h>
#include <isect/methods/ray_sphere_stable.h>
#include "lessons/ray_sphere/picture.h"
#include "lessons/ray_sphere/telling.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/plane.h"

namespace isect::lessons::ray_sphere_lesson {
namespace {

using namespace viz;

enum Case { miss, ends_inside, inside, two_hits, behind, ends_before, tangent, heading_in, heading_out };

int branch(const Parameters& p) {
  const Setup s = setup(p, false);
  if (s.truth.line_roots == 0) return miss;
  if (s.truth.line_roots == 1) return tangent;
  if (s.truth.origin == Location::in) return inside;
  if (s.truth.origin == Location::on) return s.foot() > 0 ? heading_in : heading_out;
  if (!s.truth) return s.foot() < 0 ? behind : ends_before;
  return s.ray.range.hi < s.truth.roots.hi ? ends_inside : two_hits;
}
/// In radii: how far along the ray the origin is from the line's point nearest to the centre; that point's distance.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p, true);
  const Vec3 from_center = s.ray.origin - s.sphere.center;
  const double along = from_center.dot(s.ray.direction);
  return Vec2(along, (from_center - along * s.ray.direction).norm()) / s.sphere.radius;
}
/// The ray keeps its direction and passes on the same side as before, or above.
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p, true);
  const Vec3& d = s.ray.direction;
  const Vec3 from_center = s.ray.origin - s.sphere.center;
  Vec3 aside = from_center - from_center.dot(d) * d;
  if (!(aside.norm() > 1e-9 * s.sphere.radius)) aside = across().cross(upwards()).cross(d);
  if (!(aside.norm() > 0)) aside = d.unitOrthogonal();
  Parameters there = p;
  there["origin"] = Vec3(s.sphere.center + s.sphere.radius * (to.x() * d + std::max(to.y(), 0.0) * aside.normalized()));
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "start of the ray, measured from the point nearest to the centre, in radii",
      "distance of the line from the centre, in radii",
      {-3.5, 0},
      {2.5, 2.25},
      {"no real root", "ends inside", "from inside", "two hits", "behind", "ends before", "tangent", "on it, inwards",
       "on it, outwards"},
      branch,
      place,
      moved,
      "Two numbers decide: the distance of the line from the centre, and where on it the ray starts.\n"
      "The arc is the sphere itself: on it the origin lies on the surface."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p, false), unit = setup(p, true);
  const double length = s.ray.direction.stableNorm();
  const bool lengths = std::get<std::string>(p.at("method")) == "haines";  // as that walk counts
  const double scale = lengths ? length : 1;
  const auto says = [&](const std::optional<double>& t) {
    return t ? "*t* = " + shown(*t * scale) : std::string("no hit");
  };
  const std::optional<double>& truth = s.truth.surface;
  Opinions all(truth ? told(lengths ? unit : s, *truth * scale) : "no hit");
  const auto add = [&](const char* method, const std::optional<double>& t) {
    if (!t || !truth) return all.add(method, says(t), t.has_value() == truth.has_value());
    const bool agrees = says(t) == says(truth) || std::abs(*t - *truth) <= 5e-6 * std::abs(*truth) ||
                        (*truth == 0 && std::abs(*t) <= 1e-12 * s.sphere.radius / length);
    const int digits = digits_right(*t, *truth);
    const std::string right = digits == 0 || *truth == 0 ? "no digit is right"
                              : digits == 1              ? "1 digit is right"
                                                         : fmt::format("{} digits are right", digits);
    all.add(method, says(t) + (agrees ? "" : ": " + right), agrees);
  };
  std::optional<double> t = ray_sphere::haines(unit.ray, unit.sphere);
  if (t) *t /= length;
  add("Haines", t);
  add("quadratic formula", ray_sphere::quadratic(s.ray, s.sphere));
  add("half-B", ray_sphere::half_b(s.ray, s.sphere));
  add("stable roots", ray_sphere::stable_roots(s.ray, s.sphere));
  add("robust discriminant", ray_sphere::robust(s.ray, s.sphere));
  return all.take();
}

}  // namespace isect::lessons::ray_sphere_lesson
