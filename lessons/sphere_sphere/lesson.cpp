// Sphere against sphere by squared distances (N14), and what the exact test adds: all six relations, touching included.

#include "lessons/course.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/plane.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return tell(setup(p)); }

Preset preset_of(const char* id, const char* title, const Vec2& b, double r1, double r2, const char* unit = "one") {
  return {id,
          title,
          "",
          {{"a", in_plane(-1, 0)},
           {"r_a", r1 * axis_length},
           {"b", in_plane(b.x(), b.y())},
           {"r_b", r2 * axis_length},
           {"unit", std::string(unit)}}};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "sphere-sphere",
      .title = "Sphere and sphere",
      .rows = "N14",
      .summary = "Whether two balls meet, by squared distances: no square root.",
      .parameters = {vector("a", "**a**", "Centre of the first ball, in units.", in_plane(-1, 0), 6),
                     {"r_a", "*r*_a", "Radius of the first ball, in units.", 1.5 * axis_length, 0, 1e6, 0.1, 4},
                     vector("b", "**b**", "Centre of the second ball, in units.", in_plane(2, 0), 6),
                     {"r_b", "*r*_b", "Radius of the second ball, in units.", axis_length, 0, 1e6, 0.1, 4},
                     choice("unit", "unit", "The unit of all lengths: 1, 2^600 or 2^-600.", {"one", "huge", "tiny"})},
      .group_by = "",
      .presets = {preset_of("overlapping", "overlapping", {1, 0}, 1.5, 1),
                  preset_of("disjoint", "disjoint", {2, 0.5}, 1.5, 1),
                  preset_of("touching", "touching", {1.5, 0}, 1.5, 1),
                  preset_of("inside", "a inside b", {-0.5, 0.25}, 0.75, 2),
                  preset_of("inner-touch", "touching inside", {-0.25, 0}, 2, 1.25),
                  preset_of("equal", "equal", {-1, 0}, 1.5, 1.5),
                  preset_of("overflow", "huge: overflow", {1, 0}, 1.5, 1, "huge"),
                  preset_of("underflow", "tiny: underflow", {1, 0}, 1.5, 1, "tiny")},
      .camera = {.azimuth = azimuth, .elevation = elevation},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = {{"if d² < R²", "if d² ≤ R²",
                  "Balls that touch have a common point; closed sets include their boundary.", "touching"}},
      .after = {"relations", "intervals"},
      .ideas = {"Minkowski sum", "squared distance"},
      .shared = shared_ideas,
      .query = R"({"kind": "sphere_sphere", "c1": [0, 0, 0],
 "r1": 2, "c2": [1, 0, 0], "r2": 1})",
  };
  return lesson;
}

}  // namespace isect::lessons::sphere_sphere_lesson
