// Ray tracing (N01): one pixel's ray, its closest hit, its shading and its shadow ray; then all pixels.
//
// The steps stand in ray_tracing/telling, the tracer in ray_tracing/tracer, the pictures in ray_tracing/picture, the
// eye and the objects' ray tests in shared/viewing.

#include "lessons/ray_tracing/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace viewing;
using namespace ray_tracing_lesson;

const Vec3 standard_lamp = {-1, 2.25, -1.5};

Walk walk(const Parameters& values) {
  return tell(std::get<Vec3>(values.at("pixel")), std::get<Vec3>(values.at("lamp")));
}

Preset preset_of(const char* id, const char* title, int column, int row) {
  const Vec3 at = Eye(columns, rows).on_plane({column + 0.5, row + 0.5});
  return {id, title, "", {{"pixel", at}, {"lamp", standard_lamp}}};
}

}  // namespace

const Lesson& ray_tracing() {
  static const Lesson lesson = {
      .id = "ray-tracing",
      .title = "Ray tracing",
      .rows = "N01, N16",
      .summary = "A picture by viewing rays: the closest hit, its normal, and a ray to the lamp.",
      .parameters = {vector("pixel", "pixel",
                            "A point of the picture plane, in world units; its first coordinate is not used.",
                            Vec3(plane_x, 0, 0), 2),
                     vector("lamp", "lamp", "Where the lamp hangs, in world units.", standard_lamp, 5)},
      .group_by = "",
      .presets = {preset_of("lit", "lit", 7, 25), preset_of("shadow", "in shadow", 24, 29),
                  preset_of("turned-away", "turned away", 19, 28), preset_of("sky", "sky", 24, 5)},
      .camera = from_outside(),
      .steps = walk,
  };
  return lesson;
}

}  // namespace isect::lessons
