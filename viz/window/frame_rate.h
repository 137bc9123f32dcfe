#pragma once
// How fast the window draws, without a display: what `isect bench` tells.

#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Frames a second of a window of 1280 x 800 pixels in an off-screen context, which Mesa's software draws; another step
/// in each frame, nothing kept from the last. Goes on for that many seconds, ten frames at least. Throws NoBackend.
double frames_per_second(const std::vector<const Lesson*>&, double seconds);

}  // namespace isect::viz
