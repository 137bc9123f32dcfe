// Collision (N25): the double loop with its count, then sweep and prune, then a hierarchy; and what discrete times
// miss.
//
// Each way stands in a file of its own, collision/double_loop, sweep and hierarchy; the boxes and their picture in
// collision/picture, the moving box in collision/tunnelling.

#include "lessons/collision/telling.h"
#include "lessons/course.h"
#include "lessons/shared/moved_boxes.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::collision_lesson {
namespace {

using namespace viz;

Walk walk(const Parameters& values) {
  const std::string& method = std::get<std::string>(values.at("method"));
  const Boxes boxes = few(values);
  const Frame frame = has_moved(values, boxes) ? frame_of(boxes) : Frame();
  if (method == "brute-force") return double_loop(boxes, frame);
  if (method == "sweep") return sweep(boxes, frame);
  if (method == "hierarchy") return hierarchy(boxes, frame);
  return tunnelling(std::get<Vec3>(values.at("p")), std::get<double>(values.at("speed")));
}

std::vector<Parameter> parameters(const Vec3& p) {
  std::vector<Parameter> all = {
      choice("method", "method", "How pairs are found, or one moving box.",
             {"brute-force", "sweep", "hierarchy", "motion"}),
      vector("p", "**p**", "The centre of box 0 or of the moving box; its third coordinate is not used.", p),
      where("method", {"motion"},
            {"speed", "speed", "Speed of the moving box, in world units per second.", 4.0, 0, 1e6, 0, 8})};
  add_movable_boxes(all, count_of_few, "method", {"brute-force", "sweep", "hierarchy"});
  return all;
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = [] {
    std::vector<Preset> presets;
    const auto add = [&](const char* id, const char* title, const char* method, const Vec3& p, double speed) {
      presets.push_back({id, title, method, {{"method", std::string(method)}, {"p", p}, {"speed", speed}}});
    };
    const Vec3 near = {-1.75, -0.5, 0}, far = {-2.5, -1.5, 0};
    for (const char* method : {"brute-force", "sweep", "hierarchy"}) {
      add(method, "boxes meet", method, near, 4);
      add((std::string(method) + "-apart").c_str(), "one box apart", method, far, 4);
    }
    add("tunnelling", "a bullet", "motion", {-2.5, 0, 0}, 5);
    add("slow", "a slow box", "motion", {-2.5, 0, 0}, 2);
    add("passes-by", "passes by", "motion", {-2.5, 2.25, 0}, 5);
    return Lesson{
        .id = "collision",
        .title = "Collision",
        .rows = "N25",
        .summary = "Finding all pairs of overlapping boxes in three ways, and what discrete times miss.",
        .parameters = parameters(near),
        .group_by = "method",
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .steps = walk,
        .flat = true,
        .opening = opening(),
        .closing = &closing(),
        .errata = errata(),
        .after = {"aabb-aabb", "rays", "hierarchy"},
        .ideas = {"Minkowski sum", "continuous collision detection", "bounding volume hierarchy", "temporal coherence"},
        .shared = shared_ideas,
        .query = R"({"kind": "box_box", "alo": [0, 0], "ahi": [1, 1],
 "blo": [0.5, 0.5], "bhi": [2, 2]})",
    };
  }();
  return lesson;
}

}  // namespace isect::lessons::collision_lesson
