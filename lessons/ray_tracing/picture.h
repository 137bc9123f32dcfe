#pragma once
// One pixel's ray among the objects, seen from outside, and the whole picture.

#include "lessons/ray_tracing/tracer.h"

namespace isect::lessons::ray_tracing_lesson {

struct OnePixel {
  /// For the pixel that holds this point of the picture plane.
  OnePixel(const viz::Vec3& point, const viz::Vec3& lamp, ShadowRay);

  viewing::World world;
  viewing::Eye eye;
  ShadowRay start;
  viz::Vec3 lamp, handle, aim;  ///< the point as given; the middle of its pixel
  int column, row;
  viewing::Ray3 ray;
  Traced traced;
  bool acne = false;  ///< in shadow only because the naive shadow ray meets the surface where it starts
};
struct Shown {
  bool ray = false, hits = false, normal = false, shadow_ray = false;
};

viz::Scene picture(const OnePixel&, const Shown&);
viz::Scene picture(const OnePixel&, const Shown&, const Image&);  ///< as the eye sees it

viz::Walk tell(const OnePixel&);  // telling.cpp
/// What the parameters say. (lesson.cpp)
OnePixel setup(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::ray_tracing_lesson
