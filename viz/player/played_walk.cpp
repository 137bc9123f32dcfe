#include "viz/player/played_walk.h"

#include <algorithm>
#include <utility>

#include "viz/chart/case_map.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

Walk checked_walk(const Lesson& lesson, const Parameters& parameters) {
  validate(lesson, parameters);
  Walk walk = lesson.walk(parameters);
  if (walk.steps.empty()) throw BadInput("lesson " + lesson.id + " has no step for these parameters");
  return walk;
}

std::string matching_preset(const Lesson& lesson, const Parameters& parameters) {
  for (const Preset& p : lesson.presets)
    if (p.parameters == parameters) return p.id;
  return {};
}

/// Returns the variants with the titles of their walks, so that titles are written down in one place.
std::vector<Method> methods_of(const Lesson& lesson, Parameters parameters) {
  std::vector<Method> methods;
  for (const Parameter& p : lesson.parameters) {
    if (p.name != lesson.group_by) continue;
    for (const std::string& choice : p.choices) {
      parameters[p.name] = choice;
      const std::string title = lesson.walk(parameters).method;
      methods.push_back({choice, title.empty() ? choice : title});
    }
  }
  return methods;
}

std::shared_ptr<const LessonOverview> overview_of(const Lesson& lesson, const Walk& walk,
                                                  const Parameters& parameters) {
  LessonOverview overview;
  for (const Preset& p : lesson.presets) overview.samples.push_back(checked_walk(lesson, p.parameters));
  if (overview.samples.empty()) overview.samples.push_back(walk);
  overview.methods = methods_of(lesson, parameters);
  return std::make_shared<const LessonOverview>(std::move(overview));
}

}  // namespace

PlayedWalk::PlayedWalk(const Lesson& lesson, Parameters parameters, std::shared_ptr<const LessonOverview> overview)
    : lesson_(lesson),
      parameters_(std::move(parameters)),
      walk_(checked_walk(lesson, parameters_)),
      has_axis_(viz::has_axis(walk_)),
      has_time_(viz::has_time(walk_)),
      overview_(overview ? std::move(overview) : overview_of(lesson, walk_, parameters_)),
      preset_(matching_preset(lesson, parameters_)) {
  if (lesson.opinions) opinions_ = lesson.opinions(parameters_);
  if (lesson.map) map_part_ = case_map_in_parts(lesson, parameters_);
}

bool PlayedWalk::methods_differ() const {
  return std::ranges::any_of(opinions_, [](const Opinion& o) { return !o.agrees; });
}

std::string PlayedWalk::title_of(const Parameter& p, const std::string& choice) const {
  if (p.name != lesson_.group_by) return choice;
  const auto found = std::ranges::find(methods(), choice, &Method::choice);
  return found == methods().end() ? choice : plain(found->title);
}

std::string PlayedWalk::method() const {
  const auto found = parameters_.find(lesson_.group_by);
  return found == parameters_.end() ? std::string() : std::get<std::string>(found->second);
}

std::vector<const Preset*> PlayedWalk::group() const {
  std::vector<const Preset*> group;
  for (const Preset& p : lesson_.presets)
    if (p.group == method()) group.push_back(&p);
  return group;
}

void PlayedWalk::reread() {
  overview_ = overview_of(lesson_, walk_, parameters_);
  preset_ = matching_preset(lesson_, parameters_);
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
