#pragma once
// What can be picked: bodies of triangles with a bounding ball, and balls.

#include "lessons/shared/viewing.h"

namespace isect::lessons::picking_lesson {

/// A gem in front of a crate, and two balls that touch in a point seen by the eye.
std::vector<viewing::Object> objects();
/// The ball itself, or the smallest one around all vertices.
Sphere<double, 3> bounding_ball(const viewing::Shape&);
/// How many ray tests the shape itself takes: one a triangle.
int tests_of(const viewing::Shape&);

}  // namespace isect::lessons::picking_lesson
