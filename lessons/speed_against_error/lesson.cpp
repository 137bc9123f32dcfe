// Speed against error: the measured plots, read one step at a time (N10, rules 7 and 8).
//
// The numbers are those of bench/results.json, so that every run of the lesson says the same; `isect bench` makes new
// ones. The sentences about them are computed in speed_against_error/telling.

#include "lessons/course.h"
#include "lessons/shared/parameters.h"
#include "lessons/speed_against_error/results.h"
#include "lessons/speed_against_error/telling.h"

namespace isect::lessons::speed_against_error_lesson {
namespace {

using namespace viz;

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const std::string& test : tests(results())) all.push_back({test, test, "", {{"test", test}}});
  return all;
}

Walk walk(const Parameters& values) { return Teller(results(), std::get<std::string>(values.at("test"))).tell(); }

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "speed-against-error",
      .title = "Speed against error",
      .rows = "N10",
      .summary = "What each method costs and how often it errs, as measured: what the exact call is worth.",
      .parameters = {choice("test", "test", "The test whose measurements are read.", tests(results()))},
      .group_by = "",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opening = opening(),
      .closing = &closing(),
      .after = {"rules-of-thumb", "robustness", "rounding-bound"},
      .ideas = {"exact predicate", "filter", "stable roots"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_sphere", "variant": "quadratic",
 "origin": [0, 0, 6371001], "dir": [0, 0, -1],
 "center": [0, 0, 0], "radius": 6371000})",
  };
  return lesson;
}

}  // namespace isect::lessons::speed_against_error_lesson
