#pragma once
// The window: a player for any list of lessons.

#include <stdexcept>
#include <vector>

#include "viz/lesson.h"
#include "viz/place.h"

namespace isect::viz {

/// No window without a display: says so and names what to do instead.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the window at `at` and returns when it is closed. Throws NoDisplay.
void show(const std::vector<const Lesson*>&, const Place& at);

}  // namespace isect::viz
