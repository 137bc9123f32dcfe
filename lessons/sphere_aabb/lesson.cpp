// Sphere against axis-aligned box (N15): the squared distance to the box, one axis after the other.
//
// The steps stand in sphere_aabb/telling.

#include <isect/sphere_aabb.h>

#include <isect/methods/sphere_aabb.h>
#include "lessons/course.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/parameters.h"
#include "lessons/sphere_aabb/telling.h"

namespace isect::lessons::sphere_aabb_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) { return tell(setup(p)); }

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  const bool meets = s.truth != Relation::disjoint;
  Opinions all(in_words(s.truth));
  const auto add = [&](const char* method, bool overlap) { all.add(method, says_overlap(overlap), overlap == meets); };
  add("if, else (<), the note's", sphere_aabb::accumulate_naive(s.ball, s.box));
  add("rejections first", sphere_aabb::with_rejections(s.ball, s.box));
  add("clamp the centre", sphere_aabb::clamped(s.ball, s.box));
  add("centre in the box expanded by *r*", s.in_grown);
  return all.take();
}

Preset preset_of(const char* id, const char* title, const Vec3& c, double r) {
  return {id, title, "", {{"c", c}, {"r", r}, {"b_min", Vec3(-1.5, -0.75, -0.75)}, {"b_max", Vec3(0, 0.75, 0.75)}}};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "sphere-aabb",
      .title = "Sphere and box",
      .rows = "N15",
      .summary = "Whether a ball meets an axis-aligned box: the squared distance, summed axis by axis.",
      .parameters = {vector("c", "**c**", "Centre of the ball, in world units.", Vec3(0.75, 1.375, -1.375)),
                     {"r", "*r*", "Radius of the ball, in world units.", 1.5, 0, 1e6, 0.1, 4},
                     vector("b_min", "b_{min}", "Lower corner of the box, in world units.", Vec3(-1.5, -0.75, -0.75)),
                     vector("b_max", "b_{max}", "Upper corner of the box, in world units.", Vec3(0, 0.75, 0.75))},
      .group_by = "",
      .presets = {preset_of("corner", "near a corner", {0.75, 1.375, -1.375}, 1.5),
                  preset_of("corner-miss", "passing a corner", {0.625, 1.375, -1.375}, 0.75),
                  preset_of("face", "near a face", {0.75, 0.25, 0}, 1.25),
                  preset_of("edge", "near an edge", {0.5, 1.25, 0.25}, 1.25),
                  preset_of("apart", "apart", {1.75, 0.5, 0}, 1),
                  preset_of("centre-inside", "centre inside", {-0.25, 0.375, 0}, 1),
                  preset_of("touching-face", "touching: a face", {1, 0.125, 0}, 1),
                  preset_of("touching-edge", "touching: an edge", {0.5625, 1.5, 0}, 0.9375),
                  preset_of("touching-corner", "touching: a corner", {0.75, 1.125, -1}, 0.875),
                  preset_of("ball-inside", "the ball inside", {-0.75, 0.0625, 0}, 0.625),
                  preset_of("box-inside", "the box inside", {-0.75, 0, 0}, 1.375)},
      .camera = {},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = {{"if d² < r²: return OVERLAP", "if d² ≤ r²: return OVERLAP",
                  "A ball that touches the box shares a point with it; closed sets include their boundary.",
                  "touching-face"}},
      .after = {"relations", "aabb-aabb"},
      .ideas = {"Minkowski sum", "squared distance"},
      .shared = shared_ideas,
      .query = R"({"kind": "sphere_box", "center": [2, 2, 0], "radius": 1.5,
 "lo": [-1, -1, -1], "hi": [1, 1, 1]})",
  };
  return lesson;
}

}  // namespace isect::lessons::sphere_aabb_lesson
