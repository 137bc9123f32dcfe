// What a reader takes along from a ray and a polygon, and what there is to do.

#include "lessons/ray_polygon/telling.h"

namespace isect::lessons::ray_polygon_lesson {

using namespace viz;

namespace {

bool in_notch(const Parameters& p) {
  const Setup s = setup(p);
  const Ring<double, 3> hull = {s.ring[0], s.ring[1], s.ring[2], s.ring[4]};
  return !s.truth.t && intersect(s.ray, hull).t;
}

bool hits_soon(const Parameters& p) {
  const RayPolygon<double> truth = setup(p).truth;
  return truth.t && *truth.t < 1;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Does a ray hit a polygon in space? Ray tracers and editors need this for walls, floors and faces.\n"
      "First find where the line meets the polygon's plane. Then drop one coordinate: this leaves a point and a "
      "planar polygon, as the lecture note *Intersection Detection* does.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The ray hits if *t* ≥ 0 and its point lies in the polygon: in the plane, without the coordinate of the "
          "largest "
          "|*n_i*|.",
      .cost =
          "O(*n*) for *n* vertices: one pass for **n**, one for the crossings, by the half-open rule. With **n** "
          "stored, only the crossings.",
      .choose =
          "For polygons of any shape, with notches and many vertices. For triangles use a triangle test. "
          "Non-planar polygons must be split into triangles.",
      .used =
          "Room and portal engines, CAD picking, radiosity, collision with level geometry. Most renderers split "
          "polygons into triangles first.",
      .bug = "Always dropping the same coordinate: a vertical polygon collapses to a segment.",
      .bug_preset = "upright",
      .reading = {"Ivan Sutherland et al., A Characterization of Ten Hidden-Surface Algorithms, *ACM Computing "
                  "Surveys* 6, 1974, pages 1–55.",
                  "Eric Haines, Point in Polygon Strategies, in: *Graphics Gems IV*, 1994, pages 24–46.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13."},
      .exercises = {
          {"Drag the ray until it passes through the notch.",
           "Its point must lie in the hull of the polygon, but above the notch's corner. There two edges lie on its "
           "right.",
           "hit",
           in_notch,
           {{"o", "-1.796875,1.125,1.0234375"}}},
          {"Drag **o** along the ray until *t* < 1.",
           "A step by **d** lowers *t* by 1. From *t* = 2, more than one step is needed.",
           "hit",
           hits_soon,
           {{"o", "-1.046875,-0.25,0.0234375"}}},
          {"A plane has **n** = (1, −2, 0.5) and goes through (0, 1, 0). Which coordinate is dropped, and which is "
           "*D*? And what if **n** · **d** is 0 but for rounding?",
           "*y*, as |−2| is the largest. *D* = −**n** · **p**_0 = 2.\n"
           "Then the quotient *t* may have any size and either sign, though the line is parallel to the plane. The "
           "exact test takes the sign of **n** · **d** without rounding."},
          {"Why may a coordinate be dropped without changing in and out?",
           "With *n_i* ≠ 0, each point of the plane has a projection of its own, and segments stay segments. An area "
           "keeps |*n_i*| / |**n**| of its size, so the largest |*n_i*| keeps most."},
          {"A stored normal comes from the first corner alone. On which polygon does the test break? And what if the "
           "corners lie in no common plane?",
           "On one whose first three vertices lie on one line: **n** = 0. The sum over all corners does not break "
           "there. On a bow tie of equal lobes it does: it is 0, too.\n"
           "Corners in no common plane have no single normal. At the common edge of two such polygons a ray may miss "
           "both, or hit both."},
      }};
  return closing;
}

}  // namespace isect::lessons::ray_polygon_lesson
