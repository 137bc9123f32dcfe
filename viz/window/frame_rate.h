#pragma once
// How fast the window draws, without a display: reported by `isect bench`.

#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns the frames per second of a window of 1280 x 800 pixels in an off-screen context, drawn by Mesa's software;
/// each frame has another step and keeps nothing. Runs for so many seconds, ten frames at least. Throws NoBackend.
double frames_per_second(const std::vector<const Lesson*>&, double seconds);

}  // namespace isect::viz
