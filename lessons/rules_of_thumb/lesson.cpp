// Eight rules of thumb (N10), each as a small experiment: a count without the rule, and with it.
//
// The experiments stand in rules_of_thumb/.

#include "lessons/course.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::rules_of_thumb_lesson {
namespace {

using namespace viz;

struct Rule {
  const char* id;
  const char* title;
  Experiment (*make)(const Flat&);  ///< null for the measured rule
  Vec3 p;
};
const std::vector<Rule> rules = {
    {"1-trivial", "trivial accept, reject", trivial, {-0.625, 0.375, 0}},
    {"2-reuse", "reuse results", reuse, {-2.5, 0.25, 0}},
    {"3-reorder", "reorder the tests", reorder, {-1, 0.0625, 0}},
    {"4-postpone", "postpone the expensive", postpone, {-1.875, -0.5, 0}},
    {"5-dimension", "reduce the dimension", fewer_axes, {-1.5, 0, 0}},
    {"6-precalculate", "precalculate", precalculate, {-1, 0.25, 0}},
    {"7-measure", "time and profile", nullptr, {0, 0, 0}},
    {"8-robust", "make it robust", robust, {0.9, 1.3, 0}},
};

Walk walk(const Parameters& values) {
  const std::string& id = std::get<std::string>(values.at("rule"));
  const Vec3& p = std::get<Vec3>(values.at("p"));
  for (const Rule& r : rules)
    if (r.id == id && r.make != nullptr) return tell(r.make({p.x(), p.y()}), {p.x(), p.y()});
  return measure();
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = [] {
    std::vector<std::string> ids;
    std::vector<Preset> presets;
    for (const Rule& r : rules) {
      ids.emplace_back(r.id);
      presets.push_back({r.id, r.title, {}, {{"rule", std::string(r.id)}, {"p", r.p}}});
    }
    std::vector<std::string> with_query = ids;
    std::erase(with_query, "7-measure");
    return Lesson{
        .id = "rules-of-thumb",
        .title = "Eight rules of thumb",
        .rows = "N10",
        .summary = "Eight rules of the lecture note as experiments: counted without the rule, and with it.",
        .parameters = {choice("rule", "rule", "Which rule.", ids),
                       where("rule", with_query,
                             vector("p", "**p**",
                                    "Position of the query object, in world units; its third coordinate is not used.",
                                    rules.front().p))},
        .group_by = {},
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .steps = walk,
        .flat = true,
        .opening = opening(),
        .closing = &closing(),
        .after = {"sphere-aabb", "ray-sphere", "obb-obb", "hierarchy", "concave-polygon"},
        .ideas = {"trivial reject", "temporal coherence", "projection", "exact predicate"},
        .shared = shared_ideas,
        .query = R"({"kind": "sphere_box", "center": [3, 3, 0], "radius": 1,
 "lo": [-1, -1, -1], "hi": [1, 1, 1]})",
    };
  }();
  return lesson;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
