#pragma once
// A last step for lessons with two natural parameters: where the setting lies among all cases.

#include <utility>

#include "viz/case_map.h"

namespace isect::lessons {

/// The walk with the map of cases after its last step; as it is where the map has no place for the setting.
/// `told` says what the plane means, in sentences of at most 20 words. The lesson must outlive the walk.
inline viz::Walk with_case_map(viz::Walk walk, const viz::Lesson& lesson, const viz::Parameters& here,
                               const std::string& told) {
  const std::optional<viz::Cases::Spot> place = viz::spot_on(*lesson.map, here);
  if (!place) return walk;
  viz::Step step = walk.steps.back();  // what is known stays
  step.slug = viz::case_map_slug, step.title = "Where this case lies";
  step.caption = told + "\nThe dashed lines lead to this setting. Small rings are the other presets.";
  step.formula = "here: " + lesson.map->branches[static_cast<std::size_t>(place->branch)];
  step.decides = false;
  step.comparison.reset(), step.question.reset();
  for (viz::Value& value : step.values) value.fresh = false;
  step.scene = {};
  step.scene.chart = viz::DeferredChart([&lesson, here] { return viz::case_map(lesson, here); });
  walk.steps.push_back(std::move(step));
  return walk;
}

}  // namespace isect::lessons
