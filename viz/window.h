#pragma once
// The window: a player for any list of lessons.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "viz/course.h"
#include "viz/lesson.h"
#include "viz/place.h"

namespace isect::viz {

/// No window without a display: says so and names what to do instead.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the window at `at` and returns when it is closed. What the reader must hear of beside, such as a state file
/// that is damaged, is shown there and given to `say`. `save_scene` writes a setting into the file of the lesson that
/// is made from one, which is then as if made from that; null: there is none. Throws NoDisplay.
void show(const std::vector<const Lesson*>&, const Course&, const Place& at,
          const std::function<void(const std::string&)>& say = {},
          const std::function<void(const Parameters&)>& save_scene = {});

}  // namespace isect::viz
