// Bounding a rounding error: how an exact test finds its sign. The model x (1 + d), the filter of orient2d line by
// line, the stages after it, and its constant under the microscope.
//
// The run and its numbers stand in rounding_bound/setup, the steps in derivation, decision, stages and cells there.

#include "lessons/course.h"
#include "lessons/rounding_bound/setup.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::rounding_bound_lesson {
namespace {

using namespace viz;

/// The points of most presets: a lies on the line, up to the rounding of its coordinates.
struct Place {
  Vec3 a = {-0.7, 0.4, 0}, b = {-3, -0.8, 0}, c = {1.6, 1.6, 0};
};

struct Look {
  double right = 0, up = 0, factor = 1;
  const char* unit = "one";
};

Preset preset_of(const char* id, const char* title, const Look& look, const Place& place = {}) {
  return {id,
          title,
          {},
          {{"a", place.a},
           {"b", place.b},
           {"c", place.c},
           {"unit", std::string(look.unit)},
           {"factor", look.factor},
           {"right", look.right},
           {"up", look.up}}};
}

std::vector<Preset> presets() {
  const Place ordinary = {{-1.5, 1.5, 0}, {-3, -0.8, 0}, {1.6, 1.6, 0}};
  const Place short_numbers = {{0.5, 0.25, 0}, {-2, -1, 0}, {2, 1, 0}};
  const Place far_points = {{0.0625, 0.0625, 0}, {1.5, 1.5, 0}, {3, 3, 0}};
  const Place near_points = {{2.9, 1.9, 0}, {2.1, 1.3, 0}, {3.7, 2.5, 0}};
  const Place small = {{1e-50, 1e-50, 0}, {-2, -2, 0}, {2, 2, 0}};
  const Place tight = {{1.0000000074505806, -1.0000000149011616, 0},
                       {-1.0000000074505806, 1.0000000149011612, 0},
                       {-1.1102230246251565e-16, -1.1102230246251565e-16, 0}};
  const Place smaller = {{1e-60, 1e-60, 0}, {-2, -2, 0}, {2, 2, 0}};
  return {preset_of("near", "near the line", {.right = 12, .up = -12}),
          preset_of("ordinary", "well beside the line", {}, ordinary),
          preset_of("certain", "just certain", {.right = -12, .up = 12}),
          preset_of("on-line", "on the line", {}),
          preset_of("short-numbers", "on the line, few bits", {}, short_numbers),
          preset_of("weak", "factor 1/8", {.right = 12, .up = 12, .factor = 0.125}),
          preset_of("half", "factor 1/2", {.right = 12, .up = 12, .factor = 0.5}),
          preset_of("tight", "factor 0.599", {.factor = 0.599}, tight),
          preset_of("naive", "factor 0", {.right = 6, .up = 6, .factor = 0}),
          preset_of("rounded-differences", "rounded differences", {.right = 6, .up = -6}, far_points),
          preset_of("exact-differences", "exact differences", {.right = 3, .up = -3}, near_points),
          preset_of("small-beside-large", "small beside large", {.right = 2, .up = 5}, small),
          preset_of("many-bits", "more than 255 bits", {.right = 2, .up = 5}, smaller),
          preset_of("underflow", "tiny: underflow", {.right = 12, .up = -12, .unit = "tiny"}),
          preset_of("overflow", "huge: overflow", {.right = 12, .up = -12, .unit = "huge"})};
}

Walk walk(const Parameters& values) { return tell(Setup(values)); }

bool line_has_two_points(const Parameters& values) {
  const Setup s(values);
  return s.tested_b != s.tested_c;
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "rounding-bound",
      .title = "Bounding a rounding error",
      .rows = "beyond the note",
      .summary =
          "When a sign found in doubles is certain, by a bound on its rounding error, and what runs when it is not.",
      .parameters = {vector("a", "**a**", "The point in the middle; its third coordinate is not used.", Place().a),
                     vector("b", "**b**", "Where the line comes from; its third coordinate is not used.", Place().b),
                     vector("c", "**c**", "Where the line goes to; its third coordinate is not used.", Place().c),
                     choice("unit", "unit", "The unit of all coordinates: 1, 2^515 or 2^-530.",
                            {"one", "huge", "tiny"}),
                     {"factor", "factor", "The filter takes its bound times this, from 0 to 1.", 1.0, 0, 1, 0, 1},
                     microscope::steps_towards("right"),
                     microscope::steps_towards("up")},
      .conditions = {{"c", "a point other than **b** in the plane", line_has_two_points}},
      .group_by = {},
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opening = opening(),
      .closing = &closing(),
      .after = {"convex-hull", "robustness"},
      .ideas = {"exact predicate", "filter"},
      .shared = shared_ideas,
      .query = R"({"kind": "orient2d", "a": [-0.7, 0.4],
 "b": [-3, -0.8], "c": [1.6, 1.6]})",
  };
  return lesson;
}

}  // namespace isect::lessons::rounding_bound_lesson
