// Convex hull (N05): built point by point, then compared with the other volumes: no convex one is tighter.
//
// The steps stand in convex_hull/telling, the picture in convex_hull/picture.

#include <algorithm>

#include "lessons/convex_hull/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::convex_hull_lesson {
namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  Ring<double, 2> points;
  Vec3 moved;  ///< where the point that can be dragged stands
};

const std::vector<Situation>& situations() {
  static const std::vector<Situation> all = {
      {"scattered",
       "scattered",
       {{-2.25, -0.5}, {-1.5, 1.25}, {-1, -1.5}, {-0.5, 0.25}, {0.25, 1.75}, {0.75, -0.25}, {1.25, -1.5}, {2.25, 0.5}},
       {1.5, 1.25, 0}},
      {"in-line",
       "points on edges",
       {{-2, -1.25}, {-2, 0}, {-2, 1.25}, {0, -1.25}, {0.25, 0.25}, {2, -1.25}, {2, 1.25}},
       {0, 1.25, 0}},
      {"on-circle",
       "all on a circle",
       {{-2, 0}, {-1.6, 1.2}, {-1.2, -1.6}, {0, 2}, {0, -2}, {1.2, 1.6}, {1.6, -1.2}},
       {2, 0, 0}},
      {"one-line", "all on one line", {{-2, -1}, {-1, -0.5}, {0, 0}, {1, 0.5}}, {2, 1, 0}},
      {"twice", "a point twice", {{-1.5, -1}, {-1.5, -1}, {0, 1.5}, {0, 1.5}, {1.5, -1}}, {0, 0, 0}},
  };
  return all;
}

Walk walk(const Parameters& values) { return tell(points_of(values)); }

}  // namespace

Ring<double, 2> points_of(const Parameters& values) {
  const std::string& id = std::get<std::string>(values.at("points"));
  Ring<double, 2> points = std::ranges::find_if(situations(), [&](const Situation& s) { return s.id == id; })->points;
  move_vertices(values, "v", points);
  const Vec3& moved = std::get<Vec3>(values.at("p"));
  points.push_back({moved.x(), moved.y()});
  return points;
}

const Lesson& lesson() {
  static const Lesson lesson = [] {
    std::vector<std::string> names;
    std::vector<Preset> presets;
    for (const Situation& s : situations()) {
      names.emplace_back(s.id);
      presets.push_back({s.id, s.title, {}, {{"points", std::string(s.id)}, {"p", s.moved}}});
    }
    std::vector<Parameter> parameters = {
        choice("points", "points", "The kind of point set.", names),
        vector("p", "**p**", "One more point, in world units; its third coordinate is not used.",
               situations().front().moved)};
    std::size_t most = 0;
    for (const Situation& s : situations()) most = std::max(most, s.points.size());
    for (std::size_t i = 0; i < most; ++i) parameters.push_back(movable("v", static_cast<int>(i), "point"));
    return Lesson{
        .id = "convex-hull",
        .title = "Convex hull",
        .rows = "N05",
        .summary = "The hull of points, built step by step, and why no convex volume is tighter.",
        .parameters = parameters,
        .group_by = {},
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .steps = walk,
        .flat = true,
        .opening = opening(),
        .closing = &closing(),
        .after = {"bounding-volumes"},
        .ideas = {"orientation", "exact predicate"},
        .shared = shared_ideas,
        .query = R"({"kind": "convex_hull2d", "points":
 [[0, 0], [2, 0], [1, 0], [1, 1], [2, 2], [0, 2]]})",
    };
  }();
  return lesson;
}

}  // namespace isect::lessons::convex_hull_lesson
