// Bounding volume hierarchies (N09): built, queried by a ray and for pairs, and their cost counted as they grow.
//
// Each walk stands in a file of its own in hierarchy/, the pictures in hierarchy/tree.

#include "lessons/course.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/shared/moved_boxes.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::hierarchy_lesson {
namespace {

using namespace viz;

const std::vector<std::string> walks = {"build", "ray", "pairs", "growth"};
const Vec3 at_the_left = {-3.5, 1.25, 0};

Walk walk(const Parameters& values) {
  const std::string& which = std::get<std::string>(values.at("walk"));
  const auto vector = [&](const char* name) { return std::get<Vec3>(values.at(name)); };
  if (which == "growth") return growth();
  const Boxes boxes = boxes_of(values);
  if (which == "pairs") return pairs(boxes, vector("q"));
  const bool usual = std::get<double>(values.at("size")) == 1 && !has_moved(values, boxes);
  const TreePlace place = usual ? TreePlace() : place_beside(boxes);
  if (which == "build") return build(boxes, place);
  return ray(boxes, {vector("o").head<2>(), vector("d").head<2>()}, place);
}

Preset preset_of(const char* id, const char* title, const char* walk, const Vec3& p = at_the_left,
                 const Vec3& o = {-4.25, -0.25, 0}, const Vec3& d = {1, 0.1875, 0}, const Vec3& q = {0.25, -0.75, 0}) {
  return {id, title, walk, {{"walk", std::string(walk)}, {"p", p}, {"size", 1.0}, {"o", o}, {"d", d}, {"q", q}}};
}

/// Box 0 nearly as large as all boxes together.
Preset large_preset() {
  Preset large = preset_of("large", "one large box", "build", {-1.5, 0, 0});
  large.parameters["size"] = 7.0;
  return large;
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = {
      choice("walk", "walk", "What is done with the hierarchy.", walks),
      where("walk", {"build", "ray", "pairs"},
            vector("p", "**p**", "Centre of box 0, in units; its third coordinate is not used.", at_the_left)),
      where("walk", {"build", "ray"},
            {"size", "box 0", "How many times its usual size box 0 is.", 1.0, 0, 100, 0.25, 8}),
      where("walk", {"ray"},
            vector("o", "**o**", "The origin of the ray, in units; its third coordinate is not used.", Vec3::Zero())),
      where("walk", {"ray"},
            vector("d", "**d**", "The direction of the ray, of any length but 0; its third coordinate is not used.",
                   Vec3::UnitX())),
      where("walk", {"pairs"}, vector("q", "**q**", "Centre of the second object, in units.", Vec3::Zero()))};
  add_movable_boxes(all, count_of_boxes, "walk", {"build", "ray", "pairs"});
  return all;
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "hierarchy",
      .title = "Bounding volume hierarchies",
      .rows = "N09",
      .summary = "Boxes in boxes: how a hierarchy is built, what it rules out, and how that grows.",
      .parameters = parameters(),
      .conditions = {not_zero("d", true)},
      .group_by = "walk",
      .presets = {preset_of("build", "build", "build"), preset_of("outlier", "one far off", "build", {0.5, -2.75, 0}),
                  large_preset(), preset_of("ray", "a ray", "ray"),
                  preset_of("ray-beyond", "pruned beyond the hit", "ray", at_the_left, {-4.25, 1.375, 0}, {1, 0, 0}),
                  preset_of("ray-back", "two hits in a leaf", "ray", at_the_left, {0.625, 0.6640625, 0},
                            {-1, -0.1875, 0}),
                  preset_of("ray-missed", "past all boxes", "ray", at_the_left, {-4.25, -2.25, 0}, {1, -0.0625, 0}),
                  preset_of("pairs", "two objects meet", "pairs"), preset_of("growth", "as n grows", "growth")},
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opening = opening(),
      .closing = &closing(),
      .after = {"bounding-volumes", "aabb-aabb", "rays"},
      .ideas = {"bounding volume hierarchy", "trivial reject"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_box", "origin": [-2, 0.5], "dir": [1, 0.25],
 "lo": [0, 0], "hi": [1, 1]})",
  };
  return lesson;
}

}  // namespace isect::lessons::hierarchy_lesson
