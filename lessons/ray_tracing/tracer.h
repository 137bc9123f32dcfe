#pragma once
// A small ray tracer: the closest hit of a viewing ray, its normal, and a shadow ray to the light source.

#include "lessons/shared/viewing.h"

namespace isect::lessons::ray_tracing_lesson {

inline constexpr int columns = 48, rows = 36;

/// Balls, a box and a floor.
std::vector<viewing::Object> scene_objects();

/// What one viewing ray finds.
struct Traced {
  std::optional<BvhHit<double>> hit;
  viz::Vec3 point = viz::Vec3::Zero(), normal = viz::Vec3::Zero(), to_lamp = viz::Vec3::Zero();
  double cosine = 0;           ///< of the angle between the normal and the way to the lamp
  std::optional<int> blocker;  ///< an object between the point and the lamp; not computed for a point that faces away
  double brightness = 0;       ///< 0 to 1
};

/// How many rays were sent, and how many objects and boxes around them were tested.
struct Work {
  int eye_rays = 0, shadow_rays = 0, tests = 0, nodes = 0;
};

inline constexpr double ambient = 0.2;  ///< the share of full brightness that reaches every point

/// Where a shadow ray starts: at the object, which is left out, or on the object's surface as rounded.
enum class ShadowRay { leaves_own_out, naive };

Traced trace(const viewing::World&, const viewing::Ray3&, const viz::Vec3& lamp, Work&,
             ShadowRay = ShadowRay::leaves_own_out);
viz::Cell cell_of(const viewing::World&, const Traced&);

/// The picture, row by row.
struct Image {
  std::vector<Traced> pixels;
  Work work;
};
Image trace(const viewing::World&, const viewing::Eye&, const viz::Vec3& lamp, ShadowRay = ShadowRay::leaves_own_out);

}  // namespace isect::lessons::ray_tracing_lesson
