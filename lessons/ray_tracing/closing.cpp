// What a reader takes along from ray tracing, and what there is to do.

#include "lessons/ray_tracing/picture.h"

namespace isect::lessons::ray_tracing_lesson {

using namespace viz;

namespace {

bool in_shadow(const Parameters& p) {
  const OnePixel s = setup(p);
  return s.traced.blocker && !s.acne;
}

bool turned_away(const Parameters& p) {
  const OnePixel s = setup(p);
  return s.traced.hit && !(s.traced.cosine > 0);
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "What colour is each pixel of an image? Film renderers find out by millions of intersection tests per second.\n"
      "The lecture note *Intersection Detection* names this use: send a ray through each pixel, and take the closest "
      "hit.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "A pixel shows the object at the smallest *t* ≥ 0 of its primary ray. The point is lit if it faces the light "
          "and no object lies between.",
      .cost =
          "A primary ray a pixel, then at most one shadow ray a light. In a hierarchy their tests grow as lg *n* if "
          "boxes overlap little.",
      .choose =
          "For shadows, mirrors and glass. Rasterisation is faster for what the eye sees directly; many engines use "
          "both.",
      .used =
          "Film renderers such as RenderMan and Arnold, baked light maps, shadows and reflections in games (DXR, "
          "Vulkan "
          "ray tracing).",
      .bug = "A shadow ray that starts at its rounded hit point may hit its own object: spots of shadow acne.",
      .bug_preset = "acne",
      .reading =
          {"Arthur Appel, Some Techniques for Shading Machine Renderings of Solids, *AFIPS Spring Joint Computer "
           "Conference*, 1968, pages 37–45.",
           "Turner Whitted, An Improved Illumination Model for Shaded Display, *Communications of the ACM* 23, "
           "1980, pages 343–349.",
           "Matt Pharr, Wenzel Jakob and Greg Humphreys, *Physically Based Rendering*, 4th edition, 2023, sections 1.2 "
           "and 6.8."},
      .exercises = {
          {"Drag the pixel to a point that lies in the shadow of another object.",
           "The floor lies in the shadow of ball **a**, low in the middle of the picture.",
           "lit",
           in_shadow,
           {{"pixel", "-1.5,-0.2292,0.0208"}}},
          {"Keep the pixel, and drag the light source so that the surface faces away from it.",
           "Behind and below the objects, at (5, −3, 0), the light source reaches nothing that the eye sees here.",
           "lit",
           turned_away,
           {{"lamp", "5,-3,0"}}},
          {"A picture has 640 × 480 pixels and a vertical field of view of 90°. Where does pixel (0, 0) look?",
           "tan 45° = 1, so **d** = **forward** + *u* **right** + *v* **up** with *u* = (0.5/320 − 1) · 4/3 = −1.3313 "
           "and "
           "*v* = 1 − 0.5/240 = 0.9979."},
          {"Each hit spawns a reflected and a refracted ray, to depth three. How many rays does a pixel take? And how "
           "is one mesh hit that stands in many places?",
           "1 + 2 + 4 + 8 = 15 if all hit, as the primary ray has depth 0. At each hit a shadow ray for every light "
           "source is added. Of three levels, the primary ray being the first, there are 1 + 2 + 4 = 7.\n"
           "All places share the mesh and its bounding volume hierarchy. Each place, an instance, has a matrix. Take "
           "**o** and **d** through its inverse, and do not normalise "
           "**d**: then *t* stays the same."},
          {"Why is a shadow ray a segment, and why may its search stop early?",
           "What lies beyond the light source casts no shadow on the point. One object between them is enough; the "
           "nearest is not needed. A start moved along the normal, by a little that grows with the coordinates, avoids "
           "acne if it exceeds the rounding error of the point. Moved too far it skips near blockers: light leaks in "
           "where objects touch."},
      }};
  return closing;
}

}  // namespace isect::lessons::ray_tracing_lesson
