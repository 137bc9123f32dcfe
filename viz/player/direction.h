#pragma once
// Where a figure is seen from, as people write it: azimuth and elevation in degrees.

#include "viz/lesson.h"

namespace isect::viz {

/// Returns the lesson's own view turned to this direction, with the whole walk in the frame of a picture of 960 x 600.
Camera seen_from(const Lesson&, const Walk&, double azimuth, double elevation);

}  // namespace isect::viz
