#include "viz/player/played_walk.h"

#include "viz/chart/case_map.h"

namespace isect::viz {

Walk checked_walk(const Lesson& lesson, const Parameters& parameters) {
  validate(lesson, parameters);
  Walk walk = lesson.walk(parameters);
  if (walk.steps.empty()) throw BadInput("lesson " + lesson.id + " has no step for these parameters");
  return walk;
}

PlayedWalk::PlayedWalk(const Lesson& lesson, const Parameters& parameters) : walk_(checked_walk(lesson, parameters)) {
  if (lesson.map) map_part_ = case_map_in_parts(lesson, parameters);
}

bool PlayedWalk::prepare(int step) {
  Step& shown = walk_.steps[step];
  if (!map_part_ || shown.slug != case_map_slug) return false;
  if (std::optional<Chart> map = map_part_()) {
    shown.scene.chart = std::make_shared<const Chart>(std::move(*map));
    map_part_ = nullptr;
  }
  return true;
}

}  // namespace isect::viz
