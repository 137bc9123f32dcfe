// Concave polygon in O(lg n) (N24): slabs, the trapezoidal map, and Kirkpatrick's hierarchy: built, searched, and what
// they keep.

#include <isect/methods/point_polygon.h>
#include <isect/methods/slab_map.h>
#include "lessons/concave_polygon/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::concave_polygon_lesson {
namespace {

using namespace viz;

Preset preset_of(const char* id, const char* title, const std::string& method, const std::string& polygon,
                 const Vec3& p, const std::string& order = "random") {
  return {id, title, method, {{"method", method}, {"polygon", polygon}, {"p", p}, {"order", order}}};
}

std::vector<Preset> presets() {
  const Vec3 inside = {-0.875, 1, 0}, level = {-1.5, -0.25, 0}, on_edge = {-0.375, 1, 0}, spikes = {-0.5, 0.25, 0};
  return {preset_of("slabs", "inside", "slabs", "concave", inside),
          preset_of("slabs-level", "level with a vertex", "slabs", "concave", level),
          preset_of("slabs-vertex", "on a vertex", "slabs", "concave", {-0.875, -0.25, 0}),
          preset_of("slabs-edge", "on an edge", "slabs", "concave", on_edge),
          preset_of("slabs-spiky", "long spikes", "slabs", "spiky", spikes),
          preset_of("trapezoids", "inside", "trapezoids", "concave", {0.375, 0, 0}),
          preset_of("trapezoids-edge", "on an edge", "trapezoids", "concave", {0.5625, -0.375, 0}),
          preset_of("trapezoids-sorted", "from left to right", "trapezoids", "spiky", {0.5, 0, 0}, "sorted"),
          preset_of("hierarchy", "inside", "hierarchy", "concave", inside)};
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = {
      choice("method", "method", "How the polygon is preprocessed.", {"slabs", "trapezoids", "hierarchy"}),
      choice("polygon", "polygon", "With notches, or with long spikes.", {"concave", "spiky"}),
      vector("p", "**p**", "The point, in world units; its third coordinate is not used.", Vec3(-0.875, 1, 0)),
      where("method", {"trapezoids"},
            choice("order", "order", "How the edges are added: in random order, or sorted from left to right.",
                   {"random", "sorted"}))};
  for (int i = 0; i < most_corners(); ++i) all.push_back(movable("v", i, "polygon's corner"));
  return all;
}

/// Edges that cross or corners beyond the frame are refused.
std::vector<Condition> conditions() {
  std::vector<Condition> all;
  for (int i = 0; i < most_corners(); ++i) {
    const std::string name = "v" + std::to_string(i);
    all.push_back({name, "a corner within the frame, where no two edges cross or touch",
                   [name](const Parameters& values) { return !values.contains(name) || can_be_prepared(values); }});
  }
  return all;
}

Walk walk(const Parameters& values) {
  const std::string& method = std::get<std::string>(values.at("method"));
  const Setup setup(values);
  if (method == "slabs") return slabs(setup);
  return method == "trapezoids" ? trapezoids(setup) : hierarchy(setup);
}

std::vector<Opinion> opinions(const Parameters& values) {
  using slab_map::Abscissa, slab_map::make_naive_slabs;
  const Setup s(values);
  LocationOpinions all(s.truth);
  all.add("slabs, *x* = *m* *y* + *k*", slabs_naive(s.p, make_naive_slabs(s.ring, Abscissa::line)));
  all.add("slabs, interpolated", slabs_naive(s.p, make_naive_slabs(s.ring, Abscissa::interpolated)));
  all.add("crossings, every edge", point_polygon::crossings_naive(s.p, s.ring));
  return all.take();
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "concave-polygon",
      .title = "Point in concave polygon",
      .rows = "N24",
      .summary = "Whether a point lies in a concave polygon, in O(lg n), after preprocessing in three ways.",
      .parameters = parameters(),
      .conditions = conditions(),
      .group_by = "method",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .opening = opening(),
      .closing = &closing(),
      .after = {"crossings", "convex-polygon"},
      .ideas = {"bisection", "half-open rule"},
      .shared = shared_ideas,
      .query = R"({"kind": "pip", "variant": "trapezoids", "point": [2, 3],
 "rings": [[[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::concave_polygon_lesson
