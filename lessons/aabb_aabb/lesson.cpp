// Axis-aligned boxes (N13): an interval test for each axis, up to the first gap.

#include "lessons/aabb_aabb/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::aabb_aabb_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return tell(setup(p)); }

Preset preset_of(const char* id, const char* title, const Vec3& b_min, const Vec3& b_max, double grow = 0) {
  const Vec3 more = Vec3::Constant(grow);
  return {id,
          title,
          "",
          {{"a_min", Vec3(Vec3(-2, -1, -1) - more)},
           {"a_max", Vec3(Vec3(0, 1, 1) + more)},
           {"b_min", b_min},
           {"b_max", b_max}}};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "aabb-aabb",
      .title = "Box and box",
      .rows = "N13, N12",
      .summary = "Whether two axis-aligned boxes meet: one interval test for each axis, ended by the first gap.",
      .parameters = {vector("a_min", "a_{min}", "Lower corner of the first box, in world units.", {-2, -1, -1}),
                     vector("a_max", "a_{max}", "Upper corner of the first box, in world units.", {0, 1, 1}),
                     vector("b_min", "b_{min}", "Lower corner of the second box, in world units.", {-0.75, -0.5, 0}),
                     vector("b_max", "b_{max}", "Upper corner of the second box, in world units.", {1, 1.5, 1.5})},
      .group_by = "",
      .presets = {preset_of("overlapping", "overlapping", {-0.75, -0.5, 0}, {1, 1.5, 1.5}),
                  preset_of("gap-x", "a gap on x", {0.75, -0.5, -0.5}, {2, 1, 1}),
                  preset_of("gap-y", "a gap on y", {-1.5, 1.5, -0.5}, {0.5, 2.5, 1}),
                  preset_of("gap-z", "a gap on z", {-0.5, -0.75, -3}, {1, 0.75, -1.5}),
                  preset_of("touching-face", "touching: a face", {0, -0.75, -0.75}, {1.5, 0.75, 0.75}),
                  preset_of("touching-edge", "touching: an edge", {-3.5, 1, -0.75}, {-2, 2, 0.75}),
                  preset_of("touching-corner", "touching: a corner", {0, 1, 1}, {1.25, 2, 2}),
                  preset_of("b-inside-a", "b inside a", {-1.5, -0.5, -0.5}, {-0.5, 0.5, 0.5}),
                  preset_of("a-inside-b", "a inside b", {-2.5, -1.5, -1.5}, {0.5, 1.5, 1.5}, -0.25),
                  preset_of("equal", "equal", {-2, -1, -1}, {0, 1, 1})},
      .camera = {},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = {{"    else return OVERLAP", "return OVERLAP",
                  "Inside the loop it lets x alone decide; boxes that overlap on x may have a gap on y or z.",
                  "gap-y"}},
      .after = {"relations", "intervals"},
      .ideas = {"separating axis", "containment"},
      .shared = shared_ideas,
      .query = R"({"kind": "box_box", "alo": [0, 0, 0], "ahi": [1, 1, 1],
 "blo": [1, 0, 0], "bhi": [2, 1, 1]})",
  };
  return lesson;
}

}  // namespace isect::lessons::aabb_aabb_lesson
