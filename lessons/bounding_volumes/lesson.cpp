// Bounding volumes (N03, N04, N06-N08): one object in a sphere, an AABB, an OBB and k-DOPs: what defines each, how
// tight it fits, what it takes to keep and to test. Second walk: the cheap test first.
//
// The object and its volumes stand in bounding_volumes/object, the two walks in
// bounding_volumes/fit_and_cost and bounding_volumes/cheap_first.

#include "lessons/bounding_volumes/cheap_first.h"
#include "lessons/bounding_volumes/fit_and_cost.h"
#include "lessons/bounding_volumes/picture.h"
#include "lessons/course.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::bounding_volumes_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) {
  const std::string& name = std::get<std::string>(p.at("object"));
  const Vec3& tip = std::get<Vec3>(p.at("tip"));
  if (std::get<std::string>(p.at("walk")) == "fit")
    return fit_and_cost(name, tip, std::stoi(std::get<std::string>(p.at("k"))));
  const TriangleMesh<double> mesh = object(name, tip);
  return cheap_first(mesh, tip, std::get<Vec3>(p.at("q")), std::get<double>(p.at("reach")));
}

const Vec3 tilted = {0.875, 1.25, -0.625};

Preset fit_preset(const char* id, const char* title, const char* name, const Vec3& tip, const char* k) {
  return {id,
          title,
          "",
          {{"walk", std::string("fit")},
           {"object", std::string(name)},
           {"tip", tip},
           {"k", std::string(k)},
           {"q", Vec3(2, 0, 0)},
           {"reach", 0.5}}};
}
Preset test_preset(const char* id, const char* title, const Vec3& q, double reach, const Vec3& tip = tilted) {
  return {id,
          title,
          "",
          {{"walk", std::string("test")},
           {"object", std::string("pin")},
           {"tip", tip},
           {"k", std::string("14")},
           {"q", q},
           {"reach", reach}}};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "bounding-volumes",
      .title = "Bounding volumes",
      .rows = "N03, N04, N06-N08",
      .summary = "One object in a sphere, boxes and k-DOPs: fit, storage, cost, and the cheap test first.",
      .parameters = {choice("walk", "walk", "How the volumes fit, or how they save tests.", {"fit", "test"}),
                     choice("object", "object", "What is bounded.", objects),
                     vector("tip", "tip",
                            "Where the object's long axis ends, in units; its midpoint is the origin, and its half at "
                            "least 0.125 long.",
                            tilted, 3),
                     where("walk", {"fit"}, choice("k", "*k*", "How many planes the k-DOP has.", sizes_of_dops, 1)),
                     where("walk", {"test"},
                           vector("q", "**q**", "Centre of the box b that the object is tested against, in units.",
                                  Vec3(2, 0, 0))),
                     where("walk", {"test"},
                           {"reach", "reach of b", "Half the side of the box b, in units.", 0.5, 0, 1e6, 0.25, 3})},
      .group_by = "",
      .presets = {fit_preset("tilted", "a tilted pin", "pin", tilted, "14"),
                  fit_preset("upright", "a vertical pin", "pin", {0, 1.625, 0}, "14"),
                  fit_preset("bracket", "a bracket", "bracket", {1.25, 0.75, 0.75}, "26"),
                  fit_preset("ball", "nearly a ball", "ball", {1.25, 0.5, 0}, "18"),
                  test_preset("reject", "trivial reject", {1.625, -0.75, 0}, 0.5),
                  test_preset("accept", "trivial accept", {0, 0, 0}, 1.25, tilted / 2),
                  test_preset("overlap", "a true overlap", {0.625, 1, 0}, 0.5),
                  test_preset("void", "only void overlaps", {1, -1, -0.25}, 0.5),
                  test_preset("within", "b inside the object", {-0.3125, -0.3125, 0}, 0.125)},
      .camera = camera,
      .steps = walk,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"relations", "aabb-aabb", "sphere-sphere", "obb-obb"},
      .ideas = {"trivial reject", "slab"},
      .shared = shared_ideas,
      .query = R"({"kind": "bounding_volume_fit", "volume": "sphere",
 "points": [[0, 0, 0], [1, 2, 3], [-1, 0, 2]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::bounding_volumes_lesson
