// Point and point (N11): exact equality, nearness within a tolerance, and what the tolerance changes.

#include <isect/point_point.h>
#include "lessons/course.h"
#include "lessons/points/picture.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::points_lesson {
namespace {

using namespace viz;

Walk walk(const Parameters& values) {
  const std::string& question = std::get<std::string>(values.at("question"));
  const Setup setup(values);
  if (question == "equal") return equality(setup);
  return question == "near" ? nearness(setup) : chain(setup);
}

std::vector<Opinion> opinions(const Parameters& values) {
  const Setup s(values);
  if (std::get<std::string>(values.at("question")) != "near") return {};
  const std::vector<Said> all = said(s);
  const auto says = [](bool near) { return near ? "near" : "far"; };
  Opinions them(says(all.front().near));
  for (std::size_t i = 1; i < all.size(); ++i) them.add(all[i].name, says(all[i].near));
  return them.take();
}

struct Pose {
  Vec3 p, q, r = Vec3(0.75, -0.375, 0);
  double tolerance = 1;
  const char* unit = "one";
  const char* z = "given";
};

Preset preset_of(const char* id, const char* title, const char* question, const Pose& pose) {
  return {id,
          title,
          question,
          {{"question", std::string(question)},
           {"p", pose.p},
           {"q", pose.q},
           {"r", pose.r},
           {"tolerance", pose.tolerance},
           {"unit", std::string(pose.unit)},
           {"z", std::string(pose.z)}}};
}

std::vector<Preset> presets() {
  double sum = 0;
  for (int i = 0; i < 10; ++i) sum += 0.1;
  const Vec3 p(1, 0, 0.5), o(0, 0, 0);
  return {preset_of("copied", "a copied point", "equal", {.p = p, .q = {1, -0.0, 0.5}}),
          preset_of("different", "different on y", "equal", {.p = p, .q = {1, 0.75, 0.5}}),
          preset_of("ten-steps", "ten steps of 0.1", "equal", {.p = p, .q = {sum, 0, 0.5}}),
          preset_of("nan", "not a number", "equal", {.p = p, .q = {1, 0, -0.5}, .z = "NaN"}),
          preset_of("cube", "in the cube, not in the ball", "near", {.p = o, .q = {0.75, 0.75, -0.5}}),
          preset_of("on-sphere", "on the sphere", "near", {.p = o, .q = {0.5, 0.5, -0.25}, .tolerance = 0.75}),
          preset_of("rounding", "rounding decides", "near", {.p = o, .q = {0.6, 0, -0.8}}),
          preset_of("overflow", "huge: overflow", "near", {.p = o, .q = {0.5, 0.25, -0.25}, .unit = "huge"}),
          preset_of("underflow", "tiny: underflow", "near", {.p = o, .q = {1, 1, -0.5}, .unit = "tiny"}),
          preset_of("chain", "not transitive", "chain", {.p = {-1, -0.375, 0}, .q = {-0.125, 0, 0}})};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "points",
      .title = "Point and point",
      .rows = "N11",
      .summary = "When points are the same, when they are near, and what a tolerance changes.",
      .parameters =
          {choice("question", "question", "What is tested.", {"equal", "near", "chain"}),
           vector("p", "**p**", "The first point, in units.", Vec3(1, 0, 0.5), 2),
           vector("q", "**q**", "The second point, in units.", Vec3(1, 0, 0.5), 2),
           where("question", {"chain"}, vector("r", "**r**", "The third point, in units.", Vec3(0.75, -0.375, 0), 2)),
           where("question", {"near", "chain"},
                 {"tolerance", "tolerance", "How far apart near points may be, in units.", 1.0, 0, 1e6, 0, 2}),
           where("question", {"equal", "near"},
                 choice("unit", "unit", "The unit of all lengths: 1, 2^600 or 2^-600.", {"one", "huge", "tiny"})),
           choice("z", "*z* of **q**", "The third coordinate of q: as given, or NaN.", {"given", "NaN"})},
      .group_by = "question",
      .presets = presets(),
      .camera = points_lesson::camera,
      .steps = walk,
      .opinions = opinions,
      .opening = points_lesson::opening(),
      .closing = &points_lesson::closing(),
      .after = {"relations"},
      .ideas = {"tolerance", "squared distance", "exact predicate"},
      .shared = shared_ideas,
      .query = R"({"kind": "point_point", "a": [0.1, 0.2], "b": [0.1, 0.3],
 "tol": 0.1})",
  };
  return lesson;
}

}  // namespace isect::lessons::points_lesson
