// Ray tracing (N01): one pixel's ray, its closest hit, its shading and its shadow ray; then all pixels.
//
// The steps stand in ray_tracing/telling, the tracer in ray_tracing/tracer, the pictures in ray_tracing/picture, the
// eye and the objects' ray tests in shared/viewing.

#include "lessons/course.h"
#include "lessons/ray_tracing/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::ray_tracing_lesson {
namespace {

using namespace viz;
using namespace viewing;

const Vec3 standard_lamp = {-1, 2.25, -1.5};

Walk walk(const Parameters& values) { return tell(setup(values)); }

Preset preset_of(const char* id, const char* title, int column, int row, const char* shadow = "apart") {
  const Vec3 middle = Eye(columns, rows).on_plane({column + 0.5, row + 0.5});
  const Vec3 at = (1e4 * middle).array().round() / 1e4;  // any point of the pixel will do: one that can be read
  return {id, title, "", {{"pixel", at}, {"lamp", standard_lamp}, {"shadow", std::string(shadow)}}};
}

}  // namespace

OnePixel setup(const Parameters& p) {
  const bool apart = std::get<std::string>(p.at("shadow")) == "apart";
  return {std::get<Vec3>(p.at("pixel")), std::get<Vec3>(p.at("lamp")),
          apart ? ShadowRay::leaves_own_out : ShadowRay::naive};
}

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "ray-tracing",
      .title = "Ray tracing",
      .rows = "N01, N16",
      .summary = "An image by primary rays: the closest hit, its normal, and a shadow ray to the light source.",
      .parameters = {vector("pixel", "pixel",
                            "A point on the image plane, in world units; its first coordinate is not used.",
                            Vec3(plane_x, 0, 0), 2),
                     vector("lamp", "light source", "Position of the light source, in world units.", standard_lamp, 5),
                     choice(
                         "shadow", "shadow ray",
                         "Whether the object that a shadow ray starts on is left out (apart) or tested, too (naive).",
                         {"apart", "naive"})},
      .group_by = "",
      .presets = {preset_of("lit", "lit", 7, 25), preset_of("shadow", "in shadow", 24, 29),
                  preset_of("turned-away", "turned away", 19, 28), preset_of("sky", "sky", 24, 5),
                  preset_of("acne", "shadow acne", 13, 16, "naive")},
      .camera = from_outside(),
      .steps = walk,
      .opening = opening(),
      .closing = &closing(),
      .after = {"rays", "ray-sphere", "hierarchy", "ray-polygon"},
      .ideas = {"closest hit", "bounding volume hierarchy"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_sphere", "origin": [0, 0, 5], "dir": [0.1, 0, -1],
 "center": [0, 0, 0], "radius": 1})",
  };
  return lesson;
}

}  // namespace isect::lessons::ray_tracing_lesson
