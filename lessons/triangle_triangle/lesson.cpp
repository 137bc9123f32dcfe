// Triangle and triangle in space (beyond the note): planes first, then the line that both have in common.
//
// What is true stands in triangle_triangle/setup, the picture in triangle_triangle/picture, what the walks share in
// triangle_triangle/telling, and each walk in a file of its own: intervals, signs.

#include "lessons/course.h"
#include "lessons/shared/parameters.h"
#include "lessons/triangle_triangle/telling.h"

namespace isect::lessons::triangle_triangle_lesson {
namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  std::array<Vec3, 3> b;
  std::array<Vec3, 3> a = {Vec3(-2, 0, 1.5), Vec3(2, 0, 1.5), Vec3(0, 0, -2)};
  const char* method = "intervals";
};

const std::array<Vec3, 3> lying = Situation().a;
const std::array<Vec3, 3> crossing = {Vec3(0, 1, 0), Vec3(0.5, -1, 0.5), Vec3(2, -0.25, 0.25)};
const std::array<Vec3, 3> on_face = {Vec3(0, 0, 0.25), Vec3(-1, 1.5, 0.5), Vec3(1, 1.25, 0.75)};
const std::array<Vec3, 3> above = {Vec3(0.25, 0.25, 0), Vec3(1.25, 1.25, 0.5), Vec3(-1, 1, 0.25)};
const std::array<Vec3, 3> parallel = {Vec3(-1, 1, 1), Vec3(2, 1, 1), Vec3(0.5, 1, -1.5)};
const std::array<Vec3, 3> in_plane_apart = {Vec3(1.5, 0, -0.5), Vec3(3.5, 0, 0), Vec3(2.5, 0, -2)};
const std::array<Vec3, 3> beyond = {Vec3(2, 1, 0), Vec3(2.5, -1, 0.5), Vec3(4, -0.75, 0.25)};
const std::array<Vec3, 3> before = {Vec3(-4.5, 1, 0), Vec3(-3, -1, 0.5), Vec3(-2.5, -0.75, 0.25)};
const std::array<Vec3, 3> tilted = {Vec3(0.8, -0.3, 1.6), Vec3(-0.9, 0.4, -0.8), Vec3(1.8, 0.2, 0)};
const std::array<Vec3, 3> at_edge = {Vec3(-0.56, 0.26, -0.32), Vec3(-0.8, 0.7, 0), Vec3(1.7, 1.1, -1.7)};

const Situation situations[] = {
    {"crossing", "they cross", crossing},
    {"piercing", "one pierces the other", {Vec3(-0.5, 1.25, 0.5), Vec3(1, 1, 0.75), Vec3(0, -1, 0)}},
    {"edge-on-edge", "an edge touches", {Vec3(0.5, 1, 2), Vec3(-0.5, -1, 1), Vec3(0.5, 0.25, 3)}},
    {"vertex-on-face", "a corner touches", on_face},
    {"vertex-on-vertex", "corner on corner", {Vec3(2, 0, 1.5), Vec3(1, 1.5, 0.5), Vec3(3, 1.25, 0.5)}},
    {"neighbours", "neighbours", {Vec3(-2, 0, 1.5), Vec3(0.25, 1.5, 2), Vec3(2, 0, 1.5)}},
    {"on-plane", "a corner in the plane", {Vec3(0, 0, 0), Vec3(1, 1, 0.5), Vec3(0.5, -1, 0.75)}},
    {"parallel", "parallel planes", parallel},
    {"above", "beside a plane", above},
    {"gap", "intervals apart", beyond},
    {"one-plane", "one plane, overlapping", {Vec3(-1, 0, 0.5), Vec3(3, 0, 0.25), Vec3(1.5, 0, 2.5)}},
    {"one-plane-apart", "one plane, apart", in_plane_apart},
    {"one-plane-inside", "one plane, inside", {Vec3(-0.75, 0, 1), Vec3(0.75, 0, 1), Vec3(0, 0, -0.5)}},
    {"segment", "b is a segment", {Vec3(0.5, 1.5, 0.5), Vec3(3, -0.25, -1.5), Vec3(1.75, 0.625, -0.5)}},
    {"rounding-apart", "rounding: apart?", at_edge, tilted},
    {"rounding-gap",
     "rounding: a gap?",
     {Vec3(0.27, 0.32, 0.81), Vec3(-1.8, 0.9, 1.9), Vec3(-0.2, 1.2, 1.5)},
     {Vec3(0.9, -0.4, 0), Vec3(0.2, 0.4, 0.9), Vec3(1.6, -0.5, -0.7)}},
    {"rounding-meet",
     "rounding: they meet?",
     {Vec3(1.45, 0.39, -1.53), Vec3(0.3, 0.7, -0.3), Vec3(-0.4, 1.2, 2)},
     {Vec3(1.8, 0.4, -1.8), Vec3(-1.7, 0.3, 0.9), Vec3(0.7, -0.2, 0.4)}},
    {"decimals", "decimals", {Vec3(-0.5, 0.2, -0.3), Vec3(-0.8, 0.7, 0), Vec3(1.7, 1.1, -1.7)}, tilted},

    {"signs-crossing", "they cross", crossing, lying, "signs"},
    {"signs-touching", "a corner touches", on_face, lying, "signs"},
    {"signs-parallel", "parallel planes", parallel, lying, "signs"},
    {"signs-above", "beside a plane", above, lying, "signs"},
    {"signs-gap", "b to the right", beyond, lying, "signs"},
    {"signs-gap-too", "b to the left", before, lying, "signs"},
    {"signs-one-plane", "one plane, apart", in_plane_apart, lying, "signs"},
    {"signs-decimals", "no rounding", at_edge, tilted, "signs"},
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const Situation& s : situations)
    all.push_back({s.id,
                   s.title,
                   s.method,
                   {{"method", std::string(s.method)},
                    {"a0", s.a[0]},
                    {"a1", s.a[1]},
                    {"a2", s.a[2]},
                    {"b0", s.b[0]},
                    {"b1", s.b[1]},
                    {"b2", s.b[2]}}});
  return all;
}

Walk walk(const Parameters& p) {
  const Setup s = setup(p);
  return s.method == "signs" ? signs(s) : intervals(s);
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = {choice(
      "method", "method", "By intervals on the line of both planes, or by signs of volumes.", {"intervals", "signs"})};
  for (const int which : {0, 1})
    for (int i = 0; i < 3; ++i)
      all.push_back(
          vector(std::string(1, "ab"[which]) + std::to_string(i), corner_name(which, i),
                 "Corner " + std::to_string(i) + " of the triangle " + triangle_name(which) + ", in world units.",
                 (which == 0 ? lying : crossing)[static_cast<std::size_t>(i)]));
  return all;
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "triangle-triangle",
      .title = "Triangle and triangle",
      .rows = "beyond the note",
      .summary = "Whether two triangles in space meet, and what a mesh needs to know of them.",
      .parameters = parameters(),
      .group_by = "method",
      .presets = presets(),
      .camera = camera(),
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"intervals", "obb-obb", "convex-hull", "ray-polygon"},
      .ideas = {"orientation", "exact predicate"},
      .shared = shared_ideas,
      .query = R"({"objects": [
 {"triangle": "A", "points": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]},
 {"triangle": "B", "points": [[1, 1, -1], [1, 1, 2], [3, 3, 1]]}],
 "ask": [["A", "B"]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::triangle_triangle_lesson
