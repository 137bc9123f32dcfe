// Convex polygon in O(lg n): wedges, bisection, one edge (N23); by the core's fan from a vertex, and by the note's
// wedges around a centroid.

#include <isect/methods/point_convex_polygon.h>
#include <isect/methods/point_polygon.h>
#include <isect/point_polygon.h>
#include "lessons/convex_polygon/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::convex_polygon_lesson {
namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  int vertices;
  Vec3 p;
};
const Situation situations[] = {
    {"inside", "inside", 12, {-0.75, 0.5, 0}},
    {"outside", "outside", 12, {1.75, 1.5, 0}},
    {"outside-fan", "outside the fan", 12, {2.75, 1.25, 0}},
    {"beyond-last", "beyond the last edge", 4, {-1.5, 1.25, 0}},
    {"near-boundary", "near the boundary", 12, {-2.125, 0.375, 0}},
    {"on-vertex", "on a vertex", 4, {0, 1.75, 0}},
    {"on-edge", "on an edge", 4, {-1.125, 0.875, 0}},
    {"five", "n = 5", 5, {-0.75, 1, 0}},
    {"thousand", "n = 1000", 1000, {-2.1875, 0.375, 0}},
    {"million", "n = 1\u2009000\u2009000", 1000000, {-2.1875, 0.375, 0}},
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const std::string method : {"fan", "centroid"})
    for (const Situation& s : situations)
      all.push_back({method == "fan" ? s.id : std::string(s.id) + "-centroid",
                     s.title,
                     method,
                     {{"method", method}, {"n", std::to_string(s.vertices)}, {"p", s.p}}});
  return all;
}

Walk walk(const Parameters& values) {
  const Setup setup(std::stoi(std::get<std::string>(values.at("n"))), flat_point(values, "p"));
  return std::get<std::string>(values.at("method")) == "fan" ? fan(setup) : centroid(setup);
}

std::vector<Opinion> opinions(const Parameters& values) {
  const Setup s(std::stoi(std::get<std::string>(values.at("n"))), flat_point(values, "p"));
  LocationOpinions all(s.truth);
  all.add("wedges around a centroid", point_convex_polygon::wedge_naive(s.p, s.polygon));
  all.add("crossings, every edge", point_polygon::crossings_naive(s.p, s.polygon.vertices));
  return all.take();
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "convex-polygon",
      .title = "Point in convex polygon",
      .rows = "N23",
      .summary =
          "Whether a point lies in a convex polygon, by bisecting wedges: at most twenty times for a million "
          "vertices.",
      .parameters = {choice("method", "method", "Wedges from a vertex, or around a centroid.", {"fan", "centroid"}),
                     choice("n", "*n*", "How many vertices the polygon has.", {"4", "5", "12", "64", "1000", "1000000"},
                            2),
                     vector("p", "**p**", "The point, in world units; its third coordinate is not used.",
                            Vec3(0, 0, 0))},
      .group_by = "method",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .opening = opening(),
      .closing = &closing(),
      .after = {"crossings"},
      .ideas = {"bisection", "orientation"},
      .shared = shared_ideas,
      .query = R"({"kind": "pip", "variant": "convex", "point": [2, 2],
 "rings": [[[0, 0], [4, 0], [4, 4], [0, 4]]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::convex_polygon_lesson
