// All places where a line may cross the triangle's plane, and the methods side by side.

#include <Eigen/Geometry>
#include <cmath>

#include "lessons/ray_triangle/seam.h"
#include "lessons/ray_triangle/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;

int branch(const Parameters& p) { return static_cast<int>(setup(p).place()); }

/// The weights of b and c. Nowhere where the line is so nearly parallel that rounding would choose the place.
Vec2 weights_of(const Parameters& p) {
  const Setup s = setup(p);
  const Vec3 e1 = s.vertex(1) - s.vertex(0), e2 = s.vertex(2) - s.vertex(0), l = s.ray.origin - s.vertex(0);
  const Vec3& d = s.ray.direction;
  const double det = d.cross(e2).dot(e1), size = d.norm() * e1.norm() * e2.norm();
  if (s.seam() || s.heading == 0 || !(std::abs(det) > 1e-5 * size)) return Vec2::Constant(NAN);
  return {d.cross(e2).dot(l) / det, l.cross(e1).dot(d) / det};
}

/// The ray keeps its direction, and the t at which it crosses the plane.
Parameters moved_to(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  if (!s.line) return p;
  const Vec3 at = s.vertex(0) + to.x() * (s.vertex(1) - s.vertex(0)) + to.y() * (s.vertex(2) - s.vertex(0));
  Parameters there = p;
  there["o"] = Vec3(at - *s.line * s.ray.direction);
  return there;
}

std::vector<Opinion> opinions_at_seam(const Setup& s) {
  Opinions all("meets " + words(met(Test::exact, s.ray, s)));
  all.add("Möller and Trumbore", "meets " + words(met(Test::moller_trumbore, s.ray, s)));
  all.add("signed volumes", "meets " + words(met(Test::volumes, s.ray, s)));
  all.add("shear", "meets " + words(met(Test::shear, s.ray, s)));
  return all.take();
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*u*, the weight of **b**",
      "*v*, the weight of **c**",
      {-2, -0.75},
      {3, 1.75},
      {"inside", "beyond bc", "beyond ca", "beyond ab", "beyond a", "beyond b", "beyond c", "edge", "vertex",
       "no crossing"},
      branch,
      weights_of,
      moved_to,
      "Each point of the plane is a place where the line crosses the triangle's plane, told by its weights.\n"
      "The three lines on which one weight is 0 cut the plane into seven regions. In the middle one no weight is "
      "negative."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  if (s.seam()) return opinions_at_seam(s);
  const std::optional<double>& truth = s.truth.t;
  Opinions all(truth ? "HIT, *t* = " + shown(*truth) : "no hit");
  const auto add = [&](const char* method, const std::optional<ray_triangle::Hit<double>>& found) {
    if (!found) return all.add(method, "no hit", !truth);
    if (!truth) return all.add(method, "HIT, *t* = " + shown(found->t), false);
    constexpr double enough = 1e-6;
    const bool near = std::abs(found->t - *truth) <= enough * (std::abs(*truth) + 1);
    all.add(method, "HIT, *t* = " + (near ? shown(*truth) : digits(found->t, *truth) + ", by rounding"), near);
  };
  add("Möller and Trumbore", ray_triangle::moller_trumbore(s.ray, s.triangle));
  add("signed volumes", ray_triangle::signed_volumes(s.ray, s.triangle));
  add("shear", ray_triangle::woop(s.ray, s.triangle));
  return all.take();
}

}  // namespace isect::lessons::ray_triangle_lesson
