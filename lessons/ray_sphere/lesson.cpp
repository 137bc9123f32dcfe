// Ray and sphere: the root cases, by the note's three methods (N16-N19).
//
// The picture is drawn by ray_sphere/picture, the steps stand in ray_sphere/haines and ray_sphere/quadratic;
// ray_sphere/cases has the map of all cases and the methods side by side.

#include "lessons/course.h"
#include "lessons/ray_sphere/telling.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/plane.h"

namespace isect::lessons::ray_sphere_lesson {

namespace {

using namespace viz;

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> all = {
      choice("method", "method", "The algorithm that is stepped through.", {"haines", "quadratic", "half-b"}),
      choice("extent", "extent", "A ray has no end; a segment ends at t_max.", {"ray", "segment"}),
      vector("origin", "**o**", "Origin of the ray, in world units.", in_plane(-3.5, 0.5), 6),
      vector("direction", "**d**", "Direction of the ray, of any length but 0.", in_plane(2, 0.25)),
      where("extent", {"segment"},
            {"t_max", "*t*_{max}", "End of a segment, in lengths of the direction.", 1.0, 0, 1e6, 0, 4}),
      vector("center", "**c**", "Centre of the ball, in world units.", in_plane(1, 0), 6),
      {"radius", "*r*", "Radius of the ball, in world units.", 1.5 * axis_length, 0, 1e6, 0.1, 4},
  };
  return all;
}

/// One situation, in coordinates of the lesson's plane.
struct Situation {
  const char* id;
  const char* title;
  Vec2 origin, direction, center;
  double t_max;  ///< 0: a ray
};

const Situation situations[] = {
    {"two-roots", "two roots", {-3.5, 0.5}, {2, 0.25}, {1, 0}, 0},
    {"tangent", "tangent", {-3.5, 1.5}, {2, 0}, {1, 0}, 0},
    {"miss", "miss", {-3.5, 1}, {2, 0.5}, {1, 0}, 0},
    {"inside", "inside", {0.25, -0.75}, {1.5, 0.75}, {1, 0}, 0},
    {"behind", "behind", {2, 0.75}, {1.5, 0.5}, {-1, 0}, 0},
    {"segment-before", "ends before", {-3.5, 0.5}, {2, 0.25}, {1, 0}, 1},
    {"segment-inside", "ends inside", {-3.5, 0.5}, {2, 0.25}, {1, 0}, 2},
    {"surface-in", "on, heading in", {-0.5, 0}, {1.5, 0.75}, {1, 0}, 0},
    {"surface-out", "on, heading out", {-0.5, 0}, {-1.5, 0.75}, {1, 0}, 0},
    {"near-surface", "just before it", {-0.5, 0x1p-19}, {1.5, 0.75}, {1, 0}, 0},  // f · f − r² without rounding
    {"near-rounded", "before it, rounded", {-0.500000000001, 0}, {1.5, 0.75}, {1, 0}, 0},  // ... and with it
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const std::string& method : parameters().front().choices) {
    for (const Situation& s : situations) {
      const std::string id = method == "haines" ? s.id : std::string(s.id) + "-" + method;
      all.push_back({id,
                     s.title,
                     method,
                     {{"method", method},
                      {"extent", std::string(s.t_max > 0 ? "segment" : "ray")},
                      {"origin", in_plane(s.origin.x(), s.origin.y())},
                      {"direction", in_plane(s.direction.x(), s.direction.y())},
                      {"t_max", s.t_max > 0 ? s.t_max : 1.0},
                      {"center", in_plane(s.center.x(), s.center.y())},
                      {"radius", 1.5 * axis_length}}});
    }
  }
  return all;
}

Walk walk(const Parameters& values) {
  const std::string& method = std::get<std::string>(values.at("method"));
  if (method == "quadratic") return quadratic(values);
  if (method == "half-b") return half_b(values);
  return haines(values);
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "ray-sphere",
      .title = "Ray and sphere",
      .rows = "N16-N19",
      .summary = "Where a ray or a segment meets a sphere, by three methods.",
      .parameters = parameters(),
      .conditions = {not_zero("direction")},
      .group_by = "method",
      .presets = presets(),
      .camera = {.azimuth = azimuth, .elevation = elevation},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .errata = errata(),
      .after = {"rays", "sphere-sphere"},
      .ideas = {"Minkowski sum", "stable roots", "closest hit"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_sphere", "origin": [0, 0, -5], "dir": [0, 0, 1],
 "center": [1, 0, 0], "radius": 1})",
  };
  return lesson;
}

}  // namespace isect::lessons::ray_sphere_lesson
