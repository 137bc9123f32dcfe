// Capsule against capsule in the plane: whether the segments cross, how near each end comes, and the exact relation.

#include "lessons/capsule_capsule/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::capsule_capsule_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return tell(setup(p)); }

struct Thick {
  Vec2 p, q;
  double r;
};
Preset preset_of(const char* id, const char* title, const Thick& a, const Thick& b) {
  const auto at = [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };
  return {id,
          title,
          "",
          {{"p_a", at(a.p)}, {"q_a", at(a.q)}, {"r_a", a.r}, {"p_b", at(b.p)}, {"q_b", at(b.q)}, {"r_b", b.r}}};
}

const Thick lying = {{-2.5, -0.5}, {0.5, -0.5}, 0.75};

std::vector<Preset> presets() {
  return {
      preset_of("side", "an end near the side", lying, {{-1, 0.75}, {1.5, 1.75}, 0.625}),
      preset_of("ends", "apart: two ends", lying, {{1.75, 0.75}, {3, 1.5}, 0.5}),
      preset_of("crossing", "crossing", lying, {{-2, -1.75}, {0.5, 1.5}, 0.375}),
      preset_of("parallel", "parallel, touching", lying, {{-1.25, 1}, {2.25, 1}, 0.75}),
      preset_of("touching", "touching: two ends", lying, {{1.25, 0.5}, {2.75, 1.25}, 0.5}),
      preset_of("inside", "b inside a", {{-2, -0.5}, {1.5, 0.5}, 1.25}, {{-1.25, 0}, {0.75, 0.5}, 0.5}),
      preset_of("segments", "radius 0: segments", {{-2, -0.5}, {1, 0.5}, 0}, {{-1, 1}, {0.5, -1.5}, 0}),
  };
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "capsule-capsule",
      .title = "Capsule and capsule",
      .rows = "beyond the note",
      .summary = "Whether two thick segments meet: do they cross, and how near does each end come?",
      .parameters = {vector("p_a", "**p**_a", "First end of a, in world units; the third coordinate is not used.",
                            {-2.5, -0.5, 0}),
                     vector("q_a", "**q**_a", "Second end of a, in world units; the third coordinate is not used.",
                            {0.5, -0.5, 0}),
                     {"r_a", "*r*_a", "Radius of a, in world units.", 0.75, 0, 1e6, 0, 2},
                     vector("p_b", "**p**_b", "First end of b, in world units; the third coordinate is not used.",
                            {-1, 0.75, 0}),
                     vector("q_b", "**q**_b", "Second end of b, in world units; the third coordinate is not used.",
                            {1.5, 1.75, 0}),
                     {"r_b", "*r*_b", "Radius of b, in world units.", 0.625, 0, 1e6, 0, 2}},
      .group_by = "",
      .presets = presets(),
      .camera = {},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"intervals", "sphere-sphere", "convex-hull"},
      .ideas = {"Minkowski sum", "orientation"},
      .shared = shared_ideas,
      .query = R"({"kind": "capsule_capsule",
 "a": {"p": [-4, 0, 0], "q": [4, 0, 0], "r": 2},
 "b": {"p": [2, 3, 5], "q": [-2, -3, 5], "r": 3}})",
  };
  return lesson;
}

}  // namespace isect::lessons::capsule_capsule_lesson
