// Rays (N16): a point and a direction, or two points; finite, semi-infinite or infinite; and what t means.

#include "lessons/course.h"
#include "lessons/rays/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::rays_lesson {

namespace {

using namespace viz;

Preset preset_of(const char* id, const char* title, const char* made, const char* extent, const Vec3& o,
                 const Vec3& d_or_q) {
  const bool points = std::string(made) == "points";
  return {id,
          title,
          made,
          {{"made", std::string(made)},
           {"extent", std::string(extent)},
           {"o", o},
           {"d", points ? Vec3(1.5, 0.5, 0) : d_or_q},
           {"q", points ? d_or_q : Vec3(0, 0.5, 0)},
           {"wall", 1.5}}};
}

std::vector<Preset> presets() {
  return {preset_of("ray", "a ray", "direction", "ray", {-3, -0.5, 0}, {1.5, 0.5, 0}),
          preset_of("ray-behind", "behind a ray", "direction", "ray", {2.5, 1, 0}, {1, 0.5, 0}),
          preset_of("line", "a line", "direction", "line", {2.5, 1, 0}, {1, 0.5, 0}),
          preset_of("parallel", "parallel", "direction", "ray", {-2, -0.75, 0}, {0, 1, 0}),
          preset_of("segment", "a segment", "points", "segment", {-2.5, -0.5, 0}, {0.5, 0.5, 0}),
          preset_of("segment-on", "ending in the wall", "points", "segment", {-2.5, -0.5, 0}, {1.5, 1, 0}),
          preset_of("segment-in-wall", "lying in the wall", "points", "segment", {1.5, -1, 0}, {1.5, 0.75, 0}),
          preset_of("unit", "normalised", "unit", "ray", {-3, -0.5, 0}, {1.5, 0.5, 0}),
          preset_of("unit-short", "normalised, too short", "unit", "segment", {-3, -0.5, 0}, {1.5, 0.5, 0}),
          preset_of("unit-parallel", "normalised, parallel", "unit", "ray", {-2, -0.75, 0}, {0, 1, 0}),
          preset_of("bullet", "a bullet", "motion", "segment", {-2.5, -0.75, 0}, {4.5, 1.5, 0}),
          preset_of("slow-bullet", "a slow bullet", "motion", "segment", {-2.5, -0.75, 0}, {2, 0.75, 0})};
}

Walk walk(const Parameters& p) {
  if (std::get<std::string>(p.at("made")) != "motion") return tell(setup(p));
  const auto flat = [&](const char* name) {
    Vec3 v = std::get<Vec3>(p.at(name));
    v.z() = 0;
    return v;
  };
  return bullet(flat("o"), flat("d"));
}

bool given_by_direction(const Parameters& p) {
  const std::string& made = std::get<std::string>(p.at("made"));
  return made == "direction" || made == "unit";
}

Condition second_point() {
  return {"q", "a point that is not the first one again", [](const Parameters& p) {
            const Vec3 &o = std::get<Vec3>(p.at("o")), &q = std::get<Vec3>(p.at("q"));
            return std::get<std::string>(p.at("made")) != "points" || q.head<2>() != o.head<2>();
          }};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "rays",
      .title = "Rays",
      .rows = "N16, N20",
      .summary = "A ray given by a point and a direction or by two points, its range, and what t means.",
      .parameters = {choice("made", "made", "How the ray is given.", {"direction", "points", "unit", "motion"}),
                     where("made", {"direction", "points", "unit"},
                           choice("extent", "extent", "Which t belong to it.", {"ray", "segment", "line"})),
                     vector("o", "**o**", "Origin or first point, in world units; the third coordinate is not used.",
                            {-3, -0.5, 0}),
                     where("made", {"direction", "unit", "motion"},
                           vector("d", "**d**",
                                  "Direction, of any length but 0, or velocity, where no two points give the ray.",
                                  {1.5, 0.5, 0})),
                     where(
                         "made", {"points"},
                         vector("q", "**p**_2", "Second point, where the ray is given by two; not the first one again.",
                                {0, 0.5, 0})),
                     where("made", {"direction", "points", "unit"},
                           {"wall", "wall", "Position of the wall on x, in world units.", 1.5, -1e6, 1e6, -3, 3})},
      .conditions = {not_zero("d", true, given_by_direction), second_point()},
      .group_by = "made",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .map = &cases(),
      .opening = rays_lesson::opening(),
      .closing = &rays_lesson::closing(),
      .errata = {{"t ← −(n · o + D) / (n · d)", "if n · d = 0: return n · o + D = 0 ? HIT : MISS",
                  "For a ray parallel to the plane the quotient divides by zero.", "parallel"}},
      .after = {"intervals"},
      .ideas = {"closed set", "Minkowski sum", "continuous collision detection"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_plane", "origin": [0, 0, 1], "dir": [0, 1, -3],
 "normal": [0, 0, 1], "d": 0})",
  };
  return lesson;
}

}  // namespace isect::lessons::rays_lesson
