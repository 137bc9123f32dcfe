// Crossings: a point in a polygon (N22), every special case, by the half-open rule and by the closed one that fails.
//
// The situations stand in crossings/situations, the picture in crossings/picture, the steps of the rules in
// crossings/half_open and crossings/closed.

#include <isect/methods/point_polygon.h>
#include "lessons/course.h"
#include "lessons/crossings/situations.h"
#include "lessons/crossings/telling.h"
#include "lessons/shared/location.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::crossings_lesson {
namespace {

using namespace viz;

std::vector<Parameter> parameters() {
  std::vector<std::string> shapes;
  for (const Situation& s : situations()) shapes.emplace_back(s.id);
  std::vector<Parameter> all = {
      choice("rule", "rule", "What counts as a crossing.", {"half-open", "closed"}),
      choice("polygon", "polygon", "Which polygon, named after its special case.", shapes),
      vector("p", "**p**", "The point, in world units; its third coordinate is not used.", Vec3(0, 0, 0))};
  for (int i = 0; i < most_corners(); ++i) all.push_back(movable("v", i, "polygon's corner"));
  return all;
}

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const std::string rule : {"half-open", "closed"})
    for (const Situation& s : situations()) {
      const std::string id = rule == "half-open" ? s.id : std::string(s.id) + "-closed";
      all.push_back(
          {id, s.title, rule, {{"rule", rule}, {"polygon", std::string(s.id)}, {"p", Vec3(s.p.x(), s.p.y(), 0)}}});
    }
  return all;
}

Walk walk(const Parameters& values) {
  const Setup setup(values);
  return std::get<std::string>(values.at("rule")) == "closed" ? closed(setup) : half_open(setup);
}

/// Even-odd answers.
std::vector<Opinion> opinions(const Parameters& values) {
  const Setup s(values);
  LocationOpinions all(s.truth.even_odd);
  const auto ask = [&](const std::string& method, auto&& crossings) {
    bool inside = false;
    for (const Ring<double, 2>& ring : s.polygon.rings) inside = inside != crossings(s.p, ring);
    all.add(method, inside);
  };
  ask("division", [](const auto& p, const auto& ring) { return point_polygon::crossings_naive(p, ring); });
  ask("multiplication", [](const auto& p, const auto& ring) { return point_polygon::crossings_multiplied(p, ring); });
  ask("translated to the origin",
      [](const auto& p, const auto& ring) { return point_polygon::crossings_translated(p, ring); });
  ask("closed rule", [](const auto& p, const auto& ring) { return point_polygon::crossings_closed(p, ring) % 2 == 1; });
  int turns = 0;  // odd if and only if the count of crossings is: each of them adds 1 or takes 1 away
  for (const Ring<double, 2>& ring : s.polygon.rings) turns += point_polygon::winding_naive(s.p, ring);
  all.add("winding number, odd or even", turns % 2 != 0);
  return all.take();
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "crossings",
      .title = "Point in polygon: crossings",
      .rows = "N22",
      .summary = "Whether a point lies in a polygon, by counting the edges that a ray crosses; every special case.",
      .parameters = parameters(),
      .group_by = "rule",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .opening = opening(),
      .closing = &closing(),
      .errata = errata(),
      .after = {"intervals", "rays", "convex-hull"},
      .ideas = {"half-open rule", "orientation"},
      .shared = shared_ideas,
      .query = R"({"kind": "pip", "point": [0.75, 0.125],
 "rings": [[[-2, -1.5], [2, 1.5], [2, -1.5], [-2, 1.5]]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::crossings_lesson
