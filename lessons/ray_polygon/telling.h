#pragma once
// The walk of a ray to a polygon: the plane, the coordinate to drop, and the crossings.

#include "lessons/ray_polygon/picture.h"

namespace isect::lessons::ray_polygon_lesson {

/// "the ray hits the polygon at *t* = 2"
std::string verdict_text(const RayPolygon<double>&);
viz::Walk tell(const Setup&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::ray_polygon_lesson
