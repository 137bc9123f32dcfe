// A program for a ray and a sphere with one wrong line: it forgets that a ray may begin inside.

#include <cmath>

#include "lessons/ray_sphere/picture.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::ray_sphere_lesson {

using namespace viz;

namespace {

std::string program(const Ray<double, 3>& ray, const Sphere<double, 3>& sphere) {
  const Vec3 f = ray.origin - sphere.center;
  const double a = ray.direction.dot(ray.direction), b = f.dot(ray.direction);
  const double c = f.dot(f) - sphere.radius * sphere.radius;
  if (b * b < a * c) return "MISS";
  const double t = (-b - std::sqrt(b * b - a * c)) / a;
  if (t < 0) return "MISS";
  return t <= ray.range.hi ? "HIT" : "MISS";
}

TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p, false);
  return {program(s.ray, s.sphere), s.truth.surface ? "HIT" : "MISS"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a ray or a segment hits a sphere",
      {"f ← o − c", "A ← d · d, B ← f · d, C ← f · f − r²", "if B² < A C: return MISS", "t ← (−B − √(B² − A C)) / A",
       "if t < 0: return MISS", "return 0 ≤ t ≤ t_max ? HIT : MISS"},
      {5, "if t < 0: t ← (−B + √(B² − A C)) / A",
       "A ray that begins inside the ball has its first root behind **o**. It hits the sphere at the second one, from "
       "inside."},
      "two-roots", {{"origin", "0.8125,0,-0.609375"}});
}

}  // namespace isect::lessons::ray_sphere_lesson
