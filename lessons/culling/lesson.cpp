// View-volume culling (N01): volumes against the six planes of a frustum, one by one and under a hierarchy.
//
// The walks stand in culling/one_volume, culling/whole_scene and culling/hierarchy, the view volume in culling/picture.

#include "lessons/course.h"
#include "lessons/culling/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::culling_lesson {

namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  const char* volume;
  Vec3 p;
  double size;
};

const Situation situations[] = {
    {"outside", "beyond a plane", "box", {-0.5, 0, -3.25}, 0.75},
    {"crossing", "crossing", "box", {1.5, 0.25, 2.25}, 0.75},
    {"inside", "inside", "box", {1.75, 0, 0.5}, 0.75},
    {"touching", "touching a plane", "box", {3.75, 0, 1}, 0.75},
    {"beyond-an-edge", "beyond an edge", "box", {3.25, -2.375, 3.375}, 0.5},
    {"ball", "a ball", "ball", {1.5, 0.25, 2.25}, 0.75},
    {"scene", "a scene", "scene", {0, 0, 0}, 0.5},
    {"hierarchy", "a hierarchy", "hierarchy", {0, 0, 0}, 0.5},
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const Situation& s : situations)
    all.push_back({s.id,
                   s.title,
                   "",
                   {{"volume", std::string(s.volume)}, {"p", s.p}, {"size", s.size}, {"eye", Vec3(-4, 0, 0)}}});
  return all;
}

Walk walk(const Parameters& values) {
  const Vec3 &p = std::get<Vec3>(values.at("p")), &eye = std::get<Vec3>(values.at("eye"));
  const double size = std::get<double>(values.at("size"));
  const std::string& volume = std::get<std::string>(values.at("volume"));
  const Frustum<double> view = frustum(eye);
  if (volume == "hierarchy") return hierarchy(view, eye);
  if (volume == "scene") return whole_scene(view, eye);
  if (volume == "ball") return one_volume(view, eye, Ball{p, size});
  const Vec3 half = Vec3::Constant(size);
  return one_volume(view, eye, Box{p - half, p + half});
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "culling",
      .title = "View-volume culling",
      .rows = "N01, N03, N09",
      .summary = "Which volumes a view frustum contains, cuts or rejects, one by one and in a hierarchy.",
      .parameters = {choice("volume", "volume", "What is tested: one box, one ball, a scene, or boxes in a hierarchy.",
                            {"box", "ball", "scene", "hierarchy"}),
                     where("volume", {"box", "ball"},
                           vector("p", "**p**", "Centre of the box or ball, in world units; others have none.",
                                  situations[0].p, 5)),
                     where("volume", {"box", "ball"},
                           {"size", "size", "Half the edge of the box, or the radius of the ball, in world units.",
                            0.75, 0, 1e6, 0.25, 2}),
                     vector("eye", "eye", "The eye, in world units; it looks along x.", Vec3(-4, 0, 0), 6)},
      .group_by = "",
      .presets = presets(),
      .camera = {.azimuth = 0.35, .elevation = 0.8},
      .steps = walk,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"bounding-volumes", "hierarchy"},
      .ideas = {"half-space", "bounding volume hierarchy", "temporal coherence"},
      .shared = shared_ideas,
      .query = R"({"kind": "plane_box", "normal": [1, 1, 1], "d": -3,
 "lo": [0, 0, 0], "hi": [1, 1, 1]})",
  };
  return lesson;
}

}  // namespace isect::lessons::culling_lesson
