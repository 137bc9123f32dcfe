// Interval against interval (N12), with points as intervals of one number (N11): the test that boxes are made of.

#include "lessons/course.h"
#include "lessons/intervals/picture.h"

namespace isect::lessons::intervals_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return tell(setup(p)); }

Preset preset_of(const char* id, const char* title, double a_min, double a_max, double b_min, double b_max) {
  return {id, title, "", {{"a_min", a_min}, {"a_max", a_max}, {"b_min", b_min}, {"b_max", b_max}}};
}

Parameter end(const char* name, const char* label, const char* help, double initial) {
  return {name, label, help, initial, -1e6, 1e6, -5, 5};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "intervals",
      .title = "Interval and interval",
      .rows = "N12, N11",
      .summary = "Whether two intervals, or two points on a line, have a number in common.",
      .parameters = {end("a_min", "*a*_{min}", "Lower end of the first interval.", -3),
                     end("a_max", "*a*_{max}", "Upper end of the first interval.", 1),
                     end("b_min", "*b*_{min}", "Lower end of the second interval.", -1),
                     end("b_max", "*b*_{max}", "Upper end of the second interval.", 3)},
      .group_by = "",
      .presets = {preset_of("overlapping", "overlapping", -3, 1, -1, 3),
                  preset_of("b-after-a", "b after a", -3, -1, 1, 3), preset_of("a-after-b", "a after b", 1, 3, -3, -1),
                  preset_of("touching", "touching", -3, 0, 0, 3), preset_of("a-inside-b", "a inside b", -1, 1, -3, 3),
                  preset_of("b-inside-a", "b inside a", -3, 3, -1, 3), preset_of("equal", "equal", -2, 2, -2, 2),
                  preset_of("empty", "b is empty", -2, 2, 1, -1), preset_of("same-point", "the same point", 1, 1, 1, 1),
                  preset_of("near-points", "0.1 + 0.2 and 0.3", 0.1 + 0.2, 0.1 + 0.2, 0.3, 0.3)},
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = {{"return OVERLAP", "return a or b is empty ? DISJOINT : OVERLAP",
                  "An interval that ends before it begins has no number in it. The comparisons do not see that.",
                  "empty"}},
      .after = {"relations", "points"},
      .ideas = {"closed set", "slab", "separating axis"},
      .shared = shared_ideas,
      .query = R"({"kind": "interval_interval", "a": [0, 1], "b": [1, 2]})",
  };
  return lesson;
}

}  // namespace isect::lessons::intervals_lesson
