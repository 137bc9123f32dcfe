#include "lessons/ray_tracing/tracer.h"

#include <algorithm>

namespace isect::lessons::ray_tracing_lesson {

using namespace viz;
using namespace viewing;

std::vector<Object> scene_objects() {
  return {{"ball **a**", Sphere<double, 3>{{2, -0.125, -0.875}, 0.875}, Role::first},
          {"ball **b**", Sphere<double, 3>{{1, -0.5, 0.625}, 0.5}, Role::hit},
          {"ball **c**", Sphere<double, 3>{{3.25, 0, 1.125}, 1}, Role::miss},
          {"box", Aabb<double, 3>{{0.75, -1, -1.625}, {1.375, -0.25, -1}}, Role::second},
          {"floor", Ring<double, 3>{{0.25, -1, 2.5}, {4.5, -1, 2.5}, {4.5, -1, -2.5}, {0.25, -1, -2.5}}, Role::muted}};
}

Traced trace(const World& world, const Ray3& ray, const Vec3& lamp, Work& work, ShadowRay start) {
  Traced result;
  bvh_ray::Counts counts;
  result.hit = world.closest(ray, counts);
  const auto nodes = [](const bvh_ray::Counts& c) { return static_cast<int>(c.visited + c.missed + c.farther); };
  ++work.eye_rays, work.tests += static_cast<int>(counts.tested), work.nodes += nodes(counts);
  if (!result.hit) return result;

  const int own = result.hit->primitive;
  result.point = ray.at(result.hit->t);
  result.normal = normal_at(world.object(own).shape, result.point);
  result.to_lamp = lamp - result.point;
  result.cosine = result.normal.dot(result.to_lamp.normalized());
  result.brightness = ambient;
  if (!(result.cosine > 0)) return result;

  // A convex object never shades the side that faces the lamp: leaving it out, rounding of the point does no harm.
  const Ray3 shadow = {result.point, result.to_lamp, {0, 1}};
  const auto blocks = [&](int i) {
    ++work.tests;
    const bool left_out = i == own && start == ShadowRay::leaves_own_out;
    const std::optional<double> t = left_out ? std::nullopt : first_hit(shadow, world.object(i).shape);
    if (t) result.blocker = i;
    return t;
  };
  ++work.shadow_rays;
  bvh_ray::Counts asked;
  if (!any_hit(world.bvh, shadow, blocks, asked)) result.brightness = ambient + (1 - ambient) * result.cosine;
  work.nodes += nodes(asked);
  return result;
}

Cell cell_of(const World& world, const Traced& traced) {
  if (!traced.hit) return {Role::grid, {}};
  return {world.object(traced.hit->primitive).role, traced.brightness};
}

Image trace(const World& world, const Eye& eye, const Vec3& lamp, ShadowRay start) {
  Image image;
  for (int row = 0; row < eye.rows; ++row)
    for (int column = 0; column < eye.columns; ++column)
      image.pixels.push_back(
          trace(world, eye.through(eye.on_plane({column + 0.5, row + 0.5})), lamp, image.work, start));
  return image;
}

}  // namespace isect::lessons::ray_tracing_lesson
