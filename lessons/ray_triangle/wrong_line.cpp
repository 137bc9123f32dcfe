// A program for a ray and a triangle with one wrong line: it accepts a whole parallelogram.

#include <Eigen/Geometry>

#include "lessons/ray_triangle/setup.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::ray_triangle_lesson {

using namespace viz;

namespace {

std::string program(const Ray3& ray, const Triangle3& x) {
  const Vec3 e1 = x.vertices[1] - x.vertices[0], e2 = x.vertices[2] - x.vertices[0];
  const Vec3 &d = ray.direction, l = ray.origin - x.vertices[0];
  const double det = d.cross(e2).dot(e1);
  if (det == 0) return "MISS";
  const double u = d.cross(e2).dot(l) / det;
  const double v = l.cross(e1).dot(d) / det;
  if (u < 0 || u > 1 || v < 0 || v > 1) return "MISS";
  const double t = l.cross(e1).dot(e2) / det;
  return 0 <= t && t <= ray.range.hi ? "HIT" : "MISS";
}

/// A seam is left out: rounding there misleads any such program.
TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  if (s.seam()) return {};
  return {program(s.ray, s.triangle), s.truth ? "HIT" : "MISS"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a ray or a segment hits a triangle",
      {"e₁ ← b − a, e₂ ← c − a, l ← o − a", "det ← (d × e₂) · e₁; if det = 0: return MISS", "u ← (d × e₂) · l / det",
       "v ← (l × e₁) · d / det", "if u < 0 or u > 1 or v < 0 or v > 1: return MISS", "t ← (l × e₁) · e₂ / det",
       "return 0 ≤ t ≤ t_max ? HIT : MISS"},
      {5, "if u < 0 or v < 0 or u + v > 1: return MISS",
       "The weight of **a** is 1 − *u* − *v*, and it must not be negative either. The wrong line accepts the "
       "parallelogram of both edges, twice the triangle."},
      "face", {{"o", "-0.84375,0.75,1.546875"}});
}

}  // namespace isect::lessons::ray_triangle_lesson
