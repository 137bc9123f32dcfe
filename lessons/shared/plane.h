#pragma once
// The objects of many a lesson lie in one plane that faces the opening camera, so that lengths, right angles and
// tangency show true. Its axes have dyadic coordinates and equal length 65/64: what is tangent or on the
// surface is so exactly, in floating point too.

#include "viz/scene.h"

namespace isect::lessons {

inline viz::Vec3 across() { return {0.8125, 0, -0.609375}; }         // (52, 0, -39) / 64
inline viz::Vec3 upwards() { return {-0.234375, 0.9375, -0.3125}; }  // (-15, 60, -20) / 64
inline constexpr double axis_length = 1.015625;                      // 65 / 64
inline constexpr double azimuth = 0.6435011087932844;                // of tangent 3/4: across() runs to the right
inline constexpr double elevation = 0.3947911196997615;              // of sine 5/13: upwards() runs up

/// The point x to the right of and y above the plane's origin, in units of axis_length.
inline viz::Vec3 in_plane(double x, double y) { return x * across() + y * upwards(); }

}  // namespace isect::lessons
