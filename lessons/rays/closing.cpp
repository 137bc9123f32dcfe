// What a reader takes along from rays, and what there is to do.

#include "lessons/rays/picture.h"

namespace isect::lessons::rays_lesson {

using namespace viz;

namespace {

bool ends_in_the_wall(const Parameters& p) { return setup(p).truth.t == 1.0; }
bool flies_through(const Parameters& p) { return tunnels(std::get<Vec3>(p.at("o")), std::get<Vec3>(p.at("d"))); }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "What does a ray hit, and where? Ray tracing, picking, line of sight and bullets need this.\n"
      "All points of a ray are **r**(*t*) = **o** + *t* **d**. A hit is one number *t*, and a range of *t* says which "
      "hits count.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "A line meets a plane at *t* = −(**n** · **o** + *D*) / (**n** · **d**). The hit counts if and only if "
          "*t* lies in the closed range.",
      .cost =
          "In space: six products, five sums and one division. Normalising **d** takes three products, two sums, a "
          "square root and three divisions more, once per ray.",
      .choose =
          "Segments for line of sight and moving points. Rays for light and picking. Unit **d** where *t* must be "
          "a distance or many projections follow.",
      .used =
          "Primary and shadow rays of renderers, pick rays of editors, bullets and ground checks in games, "
          "continuous collision detection.",
      .bug = "Sampling a moving point frame by frame. A fast bullet may never be seen in a thin wall.",
      .bug_preset = "bullet",
      .reading = {"Lecture note *Intersection Detection*, rays.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.3: intersecting lines, rays and "
                  "segments."},
      .exercises = {
          {"Drag the wall until the segment just ends in it.",
           "The wall must pass through **p**_2, so that *t* = 1 = *t*_{max}.",
           "segment",
           ends_in_the_wall,
           {{"wall", "0.5"}}},
          {"Make the bullet fast enough to be in the wall between two frames, but in neither frame.",
           "In one frame it must travel beyond the far side of the wall.",
           "slow-bullet",
           flies_through,
           {{"d", "4.5,1.5,0"}}},
          {"**o** = (1, 2), **d** = (3, 4), wall at *x* = 7. Find *t* and the distance. And what does a small **n** · "
           "**d** do to the errors of *t*?",
           "1 + 3 *t* = 7 gives *t* = 2. As |**d**| = 5, the distance is 10. To take *t* for it is a usual mistake.\n"
           "With **n** = (1, 0), **n** · **d** = 3 > 0: the line crosses to the side to which **n** points. Below 0 it "
           "comes from that side.\n"
           "An error of **n** · **o** + *D* is divided by **n** · **d**. A relative error of **n** · **d** is one "
           "of *t*. Let both vectors have length 1, **o** be 1 above the plane, and **n** · **d** = −10^{−4}. Then "
           "*t* = 10^4. An error of 10^{−7} in **n** · **o** + *D* moves it by 0.001, one of 10^{−8} in **n** · **d** "
           "by 1. So limit *t*, or compute **n** · **d** with more digits."},
          {"Project **v** = (4, 2) onto a ray along **d** = (3, 4), with **d** as given and with unit **u**.",
           "**v** · **d** / |**d**| = 20 / 5 = 4, and **v** · **u** = 4 · 0.6 + 2 · 0.8 = 4. The unit vector saves the "
           "division."},
          {"Why is a ray's range closed at *t* = 0?",
           "Then a ray is a closed set, and meets a surface on which it starts. Renderers that do not want that start "
           "at a small *t*."},
      }};
  return closing;
}

}  // namespace isect::lessons::rays_lesson
