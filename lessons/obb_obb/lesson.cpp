// Oriented boxes by separating axes (N07, N04): the classical fifteen, in three groups.
//
// What is said of the axes stands in obb_obb/telling, what is said of the relation in obb_obb/relation.

#include <isect/obb_obb.h>

#include <Eigen/Geometry>
#include <set>

#include <isect/methods/obb_obb.h>
#include "lessons/course.h"
#include "lessons/obb_obb/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::obb_obb_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return Teller(setup(p)).tell(); }

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  const bool meets = s.truth != Relation::disjoint;
  Opinions all(in_words(s.truth));
  std::set<double> asked;
  for (const double epsilon : {0.0, 1e-6, s.epsilon}) {
    if (!asked.insert(epsilon).second) continue;
    const bool overlap = obb_obb::gottschalk(s.a, s.b, epsilon);
    all.add(epsilon == 0 ? "no epsilon" : "epsilon " + as_power(epsilon), says_overlap(overlap), overlap == meets);
  }
  return all.take();
}

struct Pose {
  Vec3 center, half, u, v;
};

Preset preset_of(const char* id, const char* title, const Pose& a, const Pose& b, double epsilon = 1e-9) {
  return {id,
          title,
          "",
          {{"a", a.center},
           {"a_half", a.half},
           {"a_u", a.u},
           {"a_v", a.v},
           {"b", b.center},
           {"b_half", b.half},
           {"b_u", b.u},
           {"b_v", b.v},
           {"epsilon", epsilon}}};
}

const Vec3 ex = {1, 0, 0}, ey = {0, 1, 0};
const Pose at_left = {{-1.25, 0, 0}, {1, 0.75, 0.75}, ex, ey};

std::vector<Preset> presets() {
  return {
      preset_of("normal-of-b", "a normal of b", at_left,
                {{0.875, 1.75, -0.375}, {1, 0.625, 0.5}, {0.5, -0.5, -0.5}, {-1, -0.25, -1}}),
      preset_of("normal-of-a", "a normal of a", at_left,
                {{1.25, 0.5, -0.5}, {1, 0.625, 0.5}, {0.75, -0.5, 1}, {0.25, 0.75, 0.5}}),
      preset_of("edges", "edge against edge", at_left,
                {{0.875, 1.75, -0.375}, {1, 0.625, 0.5}, {-1, 0.25, 0}, {-1, -0.75, 1}}),
      preset_of("overlapping", "overlapping", at_left,
                {{0.5, 0.375, 0.25}, {1, 0.625, 0.5}, {1, 0.5, 0.25}, {-0.5, 1, 0.25}}),
      preset_of("touching", "touching", {{-1.25, 0, 0}, {1, 0.75, 0.75}, ex, ey},
                {{0.75, 0.25, 0}, {1, 0.5, 0.5}, {3, 4, 0}, {-4, 3, 0}}),
      preset_of("parallel", "parallel edges, ε = 0",
                {{-1, 0, 0}, {1, 0.75, 0.75}, {0.75, 0.5, -0.25}, {-0.25, 0, -0.75}},
                {{0.5, -0.75, -0.625}, {0.75, 1, 0.75}, {0.75, 0.25, -0.25}, {-0.25, 0, -0.75}}, 0),
      preset_of("slender", "thin boxes, a coarse ε", {{-0.5, 0.0625, 0}, {2, 0.0625, 0.0625}, {1, 0.25, 0}, ey},
                {{0.5, -0.0625, 0}, {2, 0.0625, 0.0625}, {1, 0.25, 0}, ey}, 0.125),
      preset_of("b-inside-a", "b inside a", {{-0.5, 0, 0}, {1.5, 1.125, 1}, ex, ey},
                {{0, 0.375, 0.25}, {0.5, 0.375, 0.3125}, {1, 0.5, 0.25}, {-0.5, 1, 0.25}}),
  };
}

Parameter half_lengths(const char* name, const char* label, const char* help, const Vec3& initial) {
  Parameter p = vector(name, label, help, initial);
  p.lo = p.drag_lo = 0;
  return p;
}

/// Two directions, a microradian apart or more, span the plane of the sides.
Condition aside(const char* v, const char* u) {
  return {v, std::string("a vector that is neither 0 nor along ") + u, [=](const Parameters& p) {
            const Vec3 one = unit(std::get<Vec3>(p.at(u))), other = unit(std::get<Vec3>(p.at(v)));
            return one.cross(other).norm() >= 1e-6;
          }};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "obb-obb",
      .title = "Oriented boxes",
      .rows = "N07, N04",
      .summary = "Whether two oriented boxes meet, by separating axes: fifteen at most.",
      .parameters = {vector("a", "**a**", "Centre of the first box, in world units.", at_left.center),
                     half_lengths("a_half", "**h**_a", "Half-lengths of the first box, in world units.", at_left.half),
                     vector("a_u", "**a**_u", "First side direction of a, of any length but 0.", ex),
                     vector("a_v", "**a**_v", "Second side direction of a, not along the first; made orthogonal to it.",
                            ey),
                     vector("b", "**b**", "Centre of the second box, in world units.", {0.5, 0.375, 0.25}),
                     half_lengths("b_half", "**h**_b", "Half-lengths of the second box, in world units.",
                                  {1, 0.625, 0.5}),
                     vector("b_u", "**b**_u", "First side direction of b, of any length but 0.", {1, 0.5, 0.25}),
                     vector("b_v", "**b**_v", "Second side direction of b, not along the first; made orthogonal to it.",
                            {-0.5, 1, 0.25}),
                     {"epsilon", "ε", "Added to every |a_i · b_j|, without a unit.", 1e-9, 0, 1, 0, 0.1}},
      .conditions = {not_zero("a_u"), aside("a_v", "a_u"), not_zero("b_u"), aside("b_v", "b_u")},
      .group_by = "",
      .presets = presets(),
      .camera = {},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = {{"l ← b − a; c_ij ← |a_i · b_j| + ε", "l ← b − a; c_ij ← |a_i · b_j|, and each gap's sign exact",
                  "An absolute ε that hides rounding between parallel edges also hides the gap between thin boxes.",
                  "slender"}},
      .after = {"aabb-aabb"},
      .ideas = {"separating axis", "Minkowski sum", "projection", "tolerance"},
      .shared = shared_ideas,
      .query = R"({"kind": "obb_obb", "a": {"c": [0, 0, 0],
 "u": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "e": [1, 1, 1]},
 "b": {"c": [2.5, 0, 0], "e": [1, 1, 1],
 "u": [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]}})",
  };
  return lesson;
}

}  // namespace isect::lessons::obb_obb_lesson
