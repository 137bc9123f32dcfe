// Picking (N01): which object is under the pointer, by the closest hit of its viewing ray; bounding volumes first.
//
// The steps stand in picking/telling, the objects in picking/objects, the pictures in picking/picture, the eye and the
// objects' ray tests in shared/viewing.

#include "lessons/course.h"
#include "lessons/picking/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::picking_lesson {
namespace {

using namespace viz;
using namespace viewing;

Walk walk(const Parameters& values) { return tell(std::get<Vec3>(values.at("pointer"))); }

Preset preset_of(const char* id, const char* title, double y, double z) {
  return {id, title, "", {{"pointer", Vec3(plane_x, y, z)}}};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "picking",
      .title = "Picking",
      .rows = "N01, N03, N16",
      .summary = "Which object is under the pointer: the closest hit of its viewing ray, bounding volumes first.",
      .parameters = {vector("pointer", "pointer",
                            "A point on the image plane, in world units; its first coordinate is not used.",
                            Vec3(plane_x, 0.25, -0.4375), 2)},
      .group_by = "",
      .presets = {preset_of("front", "the one in front", 0.25, -0.4375), preset_of("behind", "one behind", 0.5, -0.75),
                  preset_of("miss", "nothing", 0.875, 0.25), preset_of("tie", "a tie", 0.25, 0.5625)},
      .camera = from_outside(),
      .steps = walk,
      .opening = opening(),
      .closing = &closing(),
      .after = {"rays", "ray-sphere", "bounding-volumes", "ray-tracing"},
      .ideas = {"closest hit", "trivial reject"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_obb", "origin": [-3, 0, 0], "dir": [1, 0, 0],
 "c": [0, 0, 0], "e": [1, 1, 1], "tmin": 0, "tmax": 10,
 "u": [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::picking_lesson
