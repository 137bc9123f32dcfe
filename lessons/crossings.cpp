// Crossings: a point in a polygon (N22), every special case, by the half-open rule and by the closed one that fails.
//
// The situations stand in crossings/situations, the picture in crossings/picture, the steps of both rules in
// crossings/rules.

#include "lessons/crossings/rules.h"
#include "lessons/crossings/situations.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace crossings_lesson;

std::vector<Parameter> parameters() {
  std::vector<std::string> shapes;
  for (const Situation& s : situations()) shapes.emplace_back(s.id);
  return {{"rule",
           "rule",
           "What counts as a crossing.",
           std::string("half-open"),
           0,
           0,
           0,
           0,
           {"half-open", "closed"}},
          {"polygon", "polygon", "The polygon, by the situation it belongs to.", shapes.front(), 0, 0, 0, 0,
           shapes},
          {"p", "**p**", "The point, in world units; its third coordinate is not used.", Vec3(0, 0, 0), -1e6,
           1e6, -4, 4}};
}

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const std::string rule : {"half-open", "closed"})
    for (const Situation& s : situations()) {
      const std::string id = rule == "half-open" ? s.id : std::string(s.id) + "-closed";
      all.push_back({id,
                     s.title,
                     rule,
                     {{"rule", rule}, {"polygon", std::string(s.id)}, {"p", Vec3(s.p.x(), s.p.y(), 0)}}});
    }
  return all;
}

Walk walk(const Parameters& values) {
  const Vec3& p = std::get<Vec3>(values.at("p"));
  const Setup setup(situation(std::get<std::string>(values.at("polygon"))), {p.x(), p.y()});
  return std::get<std::string>(values.at("rule")) == "closed" ? closed(setup) : half_open(setup);
}

}  // namespace

const Lesson& crossings() {
  static const Lesson lesson = {
      .id = "crossings",
      .title = "Point in polygon: crossings",
      .rows = "N22",
      .summary =
          "Whether a point lies in a polygon, by counting the edges that a ray crosses; every special case.",
      .parameters = parameters(),
      .group_by = "rule",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .walk = walk,
      .flat = true,
  };
  return lesson;
}

}  // namespace isect::lessons
