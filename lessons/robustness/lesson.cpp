// Robustness (N10, rule 8): a microscope. Each cell is one floating-point neighbour of a point, coloured by what a
// naive test says of it, and by what is true.
//
// The steps stand in robustness/telling, the tests under the microscope in robustness/settings.

#include "lessons/course.h"
#include "lessons/robustness/settings.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::robustness_lesson {
namespace {

using namespace viz;

Walk walk(const Parameters& values) {
  const std::string& scalar = std::get<std::string>(values.at("scalar"));
  return tell(scalar, setting(std::get<std::string>(values.at("test")), scalar, std::get<Vec3>(values.at("p"))),
              microscope::selected_of(values));
}

/// A neighbour that the naive test has wrong, for each test and scalar.
struct Look {
  const char *test, *scalar;
  double right, up;
};
const Look looks[] = {{"orientation", "double", 6, -6}, {"orientation", "float", 6, -6}, {"crossings", "double", 10, 6},
                      {"crossings", "float", 12, 11},   {"tangent", "double", -2, 3},    {"tangent", "float", -3, -6},
                      {"spheres", "double", -5, 3},     {"spheres", "float", -8, 5}};

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = [] {
    std::vector<Preset> presets;
    for (const auto& [test, scalar, right, up] : looks)
      presets.push_back({test + std::string(scalar == std::string("float") ? "-float" : ""),
                         std::string(test) + ", " + scalar,
                         {},
                         {{"test", std::string(test)},
                          {"scalar", std::string(scalar)},
                          {"p", standard_point(test)},
                          {"right", right},
                          {"up", up}}});
    return Lesson{
        .id = "robustness",
        .title = "Robustness: a microscope",
        .rows = "N10",
        .summary =
            "Neighbouring floating-point numbers, a cell each: what a naive test says of them, and what is true.",
        .parameters = {choice("test", "test", "The naive test under the microscope.", tests()),
                       choice("scalar", "scalar", "The numbers: 53 bits or 24.", {"double", "float"}),
                       vector("p", "**p**",
                              "The point in the middle, in world units; its third coordinate is not used.",
                              standard_point(tests().front())),
                       microscope::steps_towards("right"), microscope::steps_towards("up")},
        .group_by = {},
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .steps = walk,
        .flat = true,
        .opening = opening(),
        .closing = &closing(),
        .after = {"points", "sphere-sphere", "ray-sphere", "crossings", "rules-of-thumb"},
        .ideas = {"exact predicate", "tolerance", "orientation"},
        .shared = shared_ideas,
        .query = R"({"kind": "orient2d", "a": [0.1, 0.3],
 "b": [0.2, 0.6], "c": [0.3, 0.9]})",
    };
  }();
  return lesson;
}

}  // namespace isect::lessons::robustness_lesson
