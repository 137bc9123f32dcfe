// Ray against polygon (N20, N21): the plane, the coordinate to drop, and the crossings of what is left.
//
// The steps stand in ray_polygon/telling.

#include <fmt/format.h>

#include <isect/methods/ray_polygon.h>
#include "lessons/course.h"
#include "lessons/ray_polygon/telling.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::ray_polygon_lesson {
namespace {

using namespace viz;

const Vec3 inwards = {1, -0.25, -0.5};

Walk walk(const Parameters& p) { return tell(setup(p)); }

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(verdict_text(s.truth));
  const auto add = [&](const std::string& method, bool hit) {
    const std::string by_choice = s.truth.coplanar && !hit ? ", by choice" : "";
    all.add(method, (hit ? "HIT" : "MISS") + by_choice, hit == s.truth.t.has_value());
  };
  add("projected (the note)", ray_polygon::projected(s.ray, s.ring).has_value());
  add("fan of triangles", ray_polygon::fan(s.ray, s.ring).has_value());
  if (s.truth.line && *s.truth.line >= 0)
    for (int axis = 0; axis < 3; ++axis)
      add(fmt::format("*{}* dropped", "xyz"[axis]), flattened(s, s.ray.at(*s.truth.line), axis).inside);
  return all.take();
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = {choice("polygon", "polygon", "The pose of the polygon.", {"tilted", "upright"}),
                                vector("o", "**o**", "Origin of the ray, in world units.", Vec3(-2.5, 0, 1), 6),
                                vector("d", "**d**", "Direction of the ray, of any length but 0.", inwards)};
  for (int i = 0; i < corner_count; ++i) {
    all.push_back(movable("p", i, "corner"));
    all.back().help = fmt::format(
        "Corner number {}, where it was moved: along both sides of the plane, in steps of 1/64; its third coordinate "
        "is "
        "not used.",
        i);
  }
  return all;
}

std::vector<Condition> conditions() {
  std::vector<Condition> all = {not_zero("d")};
  for (int i = 0; i < corner_count; ++i) {
    const std::string name = "p" + std::to_string(i);
    all.push_back({name, "corners that enclose an area",
                   [name](const Parameters& p) { return !p.contains(name) || !setup(p).truth.flat; }});
  }
  return all;
}

/// A ray along d that reaches the point (a, b) of the polygon's plane at the given t, or a point `off` normals beside
/// it.
Preset preset_of(const char* id, const char* title, const char* polygon, const Vec2& at, double t, const Vec3& d,
                 double off = 0) {
  Parameters p = {{"polygon", std::string(polygon)}, {"o", Vec3(0, 0, 0)}, {"d", d}};
  const Setup plane = setup(p);
  const Vec3 normal(-0.5, 0.125, 1);
  p["o"] = Vec3(at.x() * plane.across + at.y() * plane.up + off * normal - t * d);
  return {id, title, "", p};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "ray-polygon",
      .title = "Ray and polygon",
      .rows = "N21, N20",
      .summary = "Whether a ray hits a polygon in space: its plane, a coordinate to drop, and crossings.",
      .parameters = parameters(),
      .conditions = conditions(),
      .group_by = "",
      .presets = {preset_of("hit", "a hit", "tilted", {-0.5, -0.375}, 2, inwards),
                  preset_of("notch", "through the notch", "tilted", {0.125, 0.625}, 2, inwards),
                  preset_of("behind", "behind", "tilted", {-0.5, -0.375}, -0.75, inwards),
                  preset_of("parallel", "parallel", "tilted", {-0.25, -1.75}, 0, {0.125, 1, -0.0625}, 1.25),
                  preset_of("coplanar", "coplanar", "tilted", {-2.25, -0.5}, 0, {1, 0, 0.5}),
                  preset_of("upright", "two coordinates left", "upright", {-0.5, -0.375}, 2, inwards),
                  preset_of("on-edge", "on an edge", "tilted", {1.125, 0}, 2, inwards)},
      .camera = {},
      .steps = walk,
      .opinions = opinions,
      .opening = opening(),
      .closing = &closing(),
      .errata =
          {{"if the count is odd: return HIT, t",
            "if r(t) is on an edge: return ON, t; if the count is odd: return HIT, t",
            "A point on the outline belongs to the polygon. The count takes it for inside or outside: ask before.",
            "on-edge"},
           {"if n · d = 0: return MISS", "if n · d = 0: return n · (p₀ − o) = 0 ? IN THE PLANE : MISS",
            "A ray in the polygon's plane may cross the polygon: that takes a test in the plane.", "coplanar"}},
      .after = {"rays", "crossings"},
      .ideas = {"half-open rule", "projection"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_polygon", "origin": [1, 1, 5], "dir": [0, 0, -1],
 "polygon": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]})",
  };
  return lesson;
}

}  // namespace isect::lessons::ray_polygon_lesson
