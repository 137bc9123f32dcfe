// Ray and triangle: by Cramer's rule, by signed volumes and after a shear; and a seam that must have no holes.
//
// What is true stands in ray_triangle/setup, the picture in ray_triangle/picture, what the walks share in
// ray_triangle/telling, and each walk in a file of its own: moller_trumbore, volumes, shear, seam.

#include "lessons/course.h"
#include "lessons/ray_triangle/telling.h"
#include "lessons/shared/microscope.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;

/// A point of the plane that most presets have; short numbers, so that plain methods do not round.
Vec3 on_plane(double x, double y) { return x * Vec3(1, 0, 0.5) + y * Vec3(0.125, 1, -0.0625); }

struct Corners {
  Vec3 a = on_plane(-1.25, -1), b = on_plane(1.25, -0.75), c = on_plane(-0.25, 1.125), q = on_plane(1.5, 1);
};
const Vec3 inwards = {1, -0.25, -0.5};

Preset preset_of(const char* id, const char* title, const char* method, const Vec3& o, const Vec3& d,
                 const Corners& corners = {}, double t_max = 0, double right = 0, double up = 0) {
  return {id,
          title,
          method,
          {{"method", std::string(method)},
           {"extent", std::string(t_max > 0 ? "segment" : "ray")},
           {"o", o},
           {"d", d},
           {"t_max", t_max > 0 ? t_max : 1.0},
           {"a", corners.a},
           {"b", corners.b},
           {"c", corners.c},
           {"q", corners.q},
           {"right", right},
           {"up", up}}};
}

/// A ray that crosses the plane at t, where b and c have the weights u and v.
Preset aimed(const char* id, const char* title, const char* method, double u, double v, double t = 2,
             const Vec3& d = inwards, double t_max = 0) {
  const Corners at;
  return preset_of(id, title, method, at.a + u * (at.b - at.a) + v * (at.c - at.a) - t * d, d, at, t_max);
}

std::vector<Preset> presets() {
  const Vec3 along = on_plane(1, 0);
  const Vec3 above = on_plane(-2, -0.5) + 0.75 * Vec3(-0.5, 0.125, 1), beside = on_plane(-2.25, -0.25);
  Corners no_area;
  no_area.c = on_plane(0, -0.875);
  const Corners grazed = {{-1.3, -1.1, -0.6}, {1.2, -0.7, 0.6}, {-0.1, 1.1, -0.2}};
  const Corners sewn = {{-1.23, -1.12, -0.66}, {1.09, -0.57, 0.72}, {-0.26, 0.92, -0.28}, {1.37, 1.19, 0.89}};
  const Vec3 o(-1.49, 1.95, 1.35), d(1.905, -1.775, -1.1300000000000001);
  const Corners few_bits = {on_plane(-1.25, -1.125), on_plane(1.375, -1), on_plane(-0.125, 1.25),
                            on_plane(1.375, 0.75)};
  const Vec3 half_way = (few_bits.b + few_bits.c) / 2, down(1, -1, -0.5);
  const char *const cramer = "moller-trumbore", *const by_volumes = "volumes", *const after_shear = "shear";
  return {aimed("face", "through the face", cramer, 0.375, 0.25),
          aimed("beside-bc", "beside bc", cramer, 0.75, 0.5),
          aimed("beside-ca", "beside ca", cramer, -0.25, 0.625),
          aimed("beside-ab", "beside ab", cramer, 0.5, -0.25),
          aimed("behind", "behind the origin", cramer, 0.375, 0.25, -0.75),
          aimed("beyond", "ends before it", cramer, 0.375, 0.25, 2, inwards, 1.25),
          preset_of("parallel", "parallel", cramer, above, along),
          preset_of("coplanar", "in the plane", cramer, beside, along),
          aimed("on-edge", "through an edge", cramer, 0.5, 0.5),
          aimed("vertex", "through a vertex", cramer, 1, 0),
          aimed("back-face", "back face", cramer, 0.375, 0.25, 2, -inwards),
          preset_of("degenerate", "no area", cramer, on_plane(0.25, -0.5) - 2 * inwards, inwards, no_area),
          preset_of("grazing", "nearly parallel", cramer, {-2.28734591336137, -1.06521557774735, -1.09082131691652},
                    {1.120000000000248, 0.379999999999956, 0.519999999999498}, grazed),

          aimed("volumes-face", "through the face", by_volumes, 0.375, 0.25),
          aimed("volumes-a", "beyond a", by_volumes, -0.25, -0.25),
          aimed("volumes-edge", "through an edge", by_volumes, 0, 0.5),
          aimed("volumes-back-face", "back face", by_volumes, 0.375, 0.25, 2, -inwards),
          aimed("volumes-behind", "behind the origin", by_volumes, 0.25, 0.25, -0.75),
          preset_of("volumes-coplanar", "in the plane", by_volumes, beside, along),

          aimed("shear-face", "through the face", after_shear, 0.375, 0.25),
          aimed("shear-b", "beyond b", after_shear, 1.375, -0.25),
          aimed("shear-c", "beyond c", after_shear, -0.25, 1.375),
          aimed("shear-beyond", "ends before it", after_shear, 0.375, 0.25, 2, inwards, 1.25),
          preset_of("shear-coplanar", "in the plane", after_shear, beside, along),

          preset_of("seam-hole", "through a hole", "seam", o, d, sewn),
          preset_of("seam-beside", "beside the seam", "seam", o, d, sewn, 0, 12, 12),
          preset_of("seam-watertight", "few bits: no hole", "seam", half_way - 2 * down, down, few_bits)};
}

Walk walk(const Parameters& p) {
  const Setup s = setup(p);
  if (s.method == "moller-trumbore") return moller_trumbore(s);
  if (s.method == "volumes") return volumes(s);
  return s.method == "shear" ? shear(s) : seam(s);
}

std::vector<Parameter> parameters() {
  const Corners corners;
  return {choice("method", "method", "How the ray is tested; or a seam of two triangles, under a microscope.",
                 {"moller-trumbore", "volumes", "shear", "seam"}),
          choice("extent", "extent", "A ray has no end; a segment ends at t_max.", {"ray", "segment"}),
          vector("o", "**o**", "Origin of the ray, in world units.", Vec3(-2.109375, 0.125, 0.9921875), 6),
          vector("d", "**d**", "Direction of the ray, of any length but 0.", inwards),
          where("extent", {"segment"},
                {"t_max", "*t*_{max}", "End of a segment, in lengths of the direction.", 1.0, 0, 1e6, 0, 4}),
          vector("a", "**a**", "First vertex of the triangle, in world units.", corners.a),
          vector("b", "**b**", "Second vertex of the triangle, in world units.", corners.b),
          vector("c", "**c**", "Third vertex of the triangle, in world units.", corners.c),
          where("method", {"seam"},
                vector("q", "**q**", "The vertex of the neighbour that does not lie on bc.", corners.q)),
          where("method", {"seam"}, microscope::steps_towards("right")),
          where("method", {"seam"}, microscope::steps_towards("up"))};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "ray-triangle",
      .title = "Ray and triangle",
      .rows = "N21, beyond the note",
      .summary = "Where a ray meets a triangle, by three methods, and whether any ray slips between two triangles.",
      .parameters = parameters(),
      .conditions = {not_zero("d")},
      .group_by = "method",
      .presets = presets(),
      .camera = {},
      .steps = walk,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"rays", "ray-polygon", "robustness", "rounding-bound"},
      .ideas = {"exact predicate", "projection"},
      .shared = shared_ideas,
      .query = R"({"kind": "line_triangle", "origin": [-2, 0, 1], "dir": [1, -0.25, -0.5],
 "tri": [[-1, -1, 0], [2, -1, 0], [0, 2, 0]], "tmin": 0})",
  };
  return lesson;
}

}  // namespace isect::lessons::ray_triangle_lesson
