// Distances (beyond the note): of a point and a segment, two segments, two boxes, and of capsules against a bound.
//
// What is true stands in distance/setup, the picture in distance/picture, what the walks share in distance/telling, and
// each walk in a file of its own: point, segments, boxes, capsules.

#include "lessons/course.h"
#include "lessons/distance/telling.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::distance_lesson {
namespace {

using namespace viz;

/// What a preset sets; all else is as in `initial`.
struct Situation {
  const char* id;
  const char* title;
  const char* objects;
  Parameters changed;
};

Parameters initial() {
  return {{"objects", std::string("point")},
          {"c", Vec3(0, 1.25, 0.5)},
          {"p_a", Vec3(-2, -1, 0)},
          {"q_a", Vec3(2, 0, 0)},
          {"p_b", Vec3(0.5, 0.25, 0.5)},
          {"q_b", Vec3(2.5, 1.75, 0)},
          {"r_a", 0.5},
          {"r_b", 0.25},
          {"clearance", 0.5},
          {"a_min", Vec3(-2.5, -1, -0.75)},
          {"a_max", Vec3(-0.5, 0.75, 0.75)},
          {"b_min", Vec3(0.75, -0.5, -0.5)},
          {"b_max", Vec3(2.5, 1.25, 1)}};
}

Situation beside(const char* id, const char* title, const Vec3& c) { return {id, title, "point", {{"c", c}}}; }
Situation two_segments(const char* id, const char* title, const Vec3& p, const Vec3& q) {
  return {id, title, "segments", {{"p_a", Vec3(-2.5, -0.75, 0)}, {"q_a", Vec3(1.5, -0.75, 0)}, {"p_b", p}, {"q_b", q}}};
}
Situation two_boxes(const char* id, const char* title, const Vec3& lo, const Vec3& hi) {
  return {id, title, "boxes", {{"b_min", lo}, {"b_max", hi}}};
}
Situation two_capsules(const char* id, const char* title, double clearance, double r_b = 0.25) {
  return {id,
          title,
          "capsules",
          {{"p_a", Vec3(-2.5, -0.5, 0)},
           {"q_a", Vec3(0.5, -0.5, 0)},
           {"p_b", Vec3(1.25, 0.5, 0)},
           {"q_b", Vec3(2.75, 1.25, 0.25)},
           {"r_b", r_b},
           {"clearance", clearance}}};
}

constexpr double tiny = 0x1p-31;  ///< so small a slope that the determinant rounds to 0

std::vector<Situation> situations() {
  return {
      beside("interior", "between the ends", {0, 1.25, 0.5}),
      beside("first-end", "before the first end", {-3, 1, 0}),
      beside("second-end", "beyond the second end", {2.75, 1.25, 0}),
      beside("at-border", "on a border of regions", {-2.5, 1, 0}),
      beside("on-segment", "on the segment", {0, -0.5, 0}),

      two_segments("interiors", "interior and interior", {-1.25, 0.5, -1.25}, {0.25, 1.5, 1.25}),
      two_segments("end-and-interior", "end and interior", {0.5, 0.25, 0.5}, {2.5, 1.75, 0}),
      two_segments("ends", "end and end", {2.25, 0.25, 0}, {3.25, 1.5, 0.5}),
      two_segments("clamped-once", "clamping once fails", {3, -0.25, 0}, {0.25, 1.75, 0.5}),
      two_segments("parallel", "parallel, side by side", {-0.5, 0.75, 0.5}, {3, 0.75, 0.5}),
      two_segments("parallel-ends", "parallel, ends nearest", {2.25, 0.5, 0}, {3.75, 0.5, 0}),
      two_segments("crossing", "crossing", {-1.5, -1.5, 0}, {0.5, 0.75, 0}),
      two_segments("touching", "touching", {0, -0.75, 0}, {1.5, 1.25, 0.5}),
      two_segments("nearly-parallel", "nearly parallel", {-2, 1, 0}, {1, 1.03125, 0}),
      two_segments("rounding", "parallel by rounding", {-2, 1, -tiny}, {2, 1, tiny}),

      two_boxes("faces", "face and face", {0.75, -0.5, -0.5}, {2.5, 1.25, 1}),
      two_boxes("edges", "edge and edge", {0.5, 1.5, -0.5}, {2.5, 2.5, 1}),
      two_boxes("corners", "corner and corner", {0.5, 1.75, 1.25}, {2, 2.75, 2}),
      two_boxes("level", "level with an edge", {0.5, 0.75, -0.5}, {2, 2, 1}),
      two_boxes("boxes-touching", "touching", {-0.5, -0.5, -0.5}, {1.5, 1, 0.5}),
      two_boxes("boxes-overlapping", "overlapping", {-1.25, -0.25, -0.5}, {1.5, 1.5, 1}),

      two_capsules("near", "just near enough", 0.625),
      two_capsules("far", "just too far", 0.375),
      two_capsules("exact", "exactly that far", 0.5),
      two_capsules("overlapping", "overlapping", 0, 0.875),
      two_capsules("below-zero", "a bound below 0", -2.5),
  };
}

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const Situation& s : situations()) {
    Parameters p = initial();
    for (const auto& [name, value] : s.changed) p[name] = value;
    p["objects"] = std::string(s.objects);
    all.push_back({s.id, s.title, s.objects, p});
  }
  return all;
}

Walk walk(const Parameters& p) {
  const Setup s = setup(p);
  if (s.is("point")) return point(s);
  if (s.is("segments")) return segments(s);
  return s.is("boxes") ? boxes(s) : capsules(s);
}

std::vector<Parameter> parameters() {
  const Parameters first = initial();
  const auto at = [&](const char* name) { return std::get<Vec3>(first.at(name)); };
  const auto in = [](std::vector<std::string> objects, Parameter p) {
    return where("objects", std::move(objects), std::move(p));
  };
  const std::vector<std::string> all_but_boxes = {"point", "segments", "capsules"}, two = {"segments", "capsules"};
  return {choice("objects", "objects", "A point and a segment, two segments, two boxes, or two capsules and a bound.",
                 {"point", "segments", "boxes", "capsules"}),
          in({"point"}, vector("c", "**c**", "The point, in world units.", at("c"))),
          in(all_but_boxes, vector("p_a", "**p**_a", "First end of the segment a, in world units.", at("p_a"))),
          in(all_but_boxes, vector("q_a", "**q**_a", "Second end of the segment a, in world units.", at("q_a"))),
          in(two, vector("p_b", "**p**_b", "First end of the segment b, in world units.", at("p_b"))),
          in(two, vector("q_b", "**q**_b", "Second end of the segment b, in world units.", at("q_b"))),
          in({"capsules"}, {"r_a", "*r*_a", "Radius of the capsule a, in world units.", 0.5, 0, 1e6, 0, 2}),
          in({"capsules"}, {"r_b", "*r*_b", "Radius of the capsule b, in world units.", 0.25, 0, 1e6, 0, 2}),
          in({"capsules"}, {"clearance", "clearance", "How far apart the surfaces have to be, in world units.", 0.5,
                            -1e6, 1e6, -3, 3}),
          in({"boxes"}, vector("a_min", "a_{min}", "Lower corner of the box a, in world units.", at("a_min"))),
          in({"boxes"}, vector("a_max", "a_{max}", "Upper corner of the box a, in world units.", at("a_max"))),
          in({"boxes"}, vector("b_min", "b_{min}", "Lower corner of the box b, in world units.", at("b_min"))),
          in({"boxes"}, vector("b_max", "b_{max}", "Upper corner of the box b, in world units.", at("b_max")))};
}

/// Requires a box that is not empty, where boxes count.
Condition not_empty(const std::string& box) {
  return {box + "_max", "a corner that is nowhere below " + box + "_min", [box](const Parameters& p) {
            const Vec3 &lo = std::get<Vec3>(p.at(box + "_min")), &hi = std::get<Vec3>(p.at(box + "_max"));
            return std::get<std::string>(p.at("objects")) != "boxes" || (lo.array() <= hi.array()).all();
          }};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "distance",
      .title = "Distance: the nearest features",
      .rows = "beyond the note",
      .summary = "How far apart two shapes are, and which ends, edges, corners or faces are nearest.",
      .parameters = parameters(),
      .conditions = {not_empty("a"), not_empty("b")},
      .group_by = "objects",
      .presets = presets(),
      .camera = camera(),
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"aabb-aabb", "sphere-aabb", "capsule-capsule"},
      .ideas = {"squared distance", "conservative advancement"},
      .shared = shared_ideas,
      .query = R"({"kind": "point_capsule", "point": [1, 3, 4],
 "p": [-3, 0, 0], "q": [3, 0, 0], "r": 5})",
  };
  return lesson;
}

}  // namespace isect::lessons::distance_lesson
