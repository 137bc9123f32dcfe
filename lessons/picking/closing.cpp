// What a reader takes along from picking, and what there is to do.

#include "lessons/picking/picture.h"

namespace isect::lessons::picking_lesson {

using namespace viz;
using namespace viewing;

namespace {

Pointed setup(const Parameters& p) { return Pointed(std::get<Vec3>(p.at("pointer"))); }

bool tied(const Parameters& p) {
  const Pointed s = setup(p);
  int at_least_t = 0;
  for (const Object& o : s.world.objects) at_least_t += s.truth && first_hit(s.ray, o.shape) == s.truth->t;
  return at_least_t > 1;
}

/// A bounding ball is met, but not the object in it, and another object is picked.
bool through_void(const Parameters& p) {
  const Pointed s = setup(p);
  for (int i = 0; i < s.size(); ++i)
    if (s.truth && s.met(i) && !first_hit(s.ray, s.world.object(i).shape)) return true;
  return false;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "A user clicks: which object is meant? Every editor, map and game must answer that, within a frame.\n"
      "The lecture note *Intersection Detection* turns the click into a ray. The first object hit is the one seen.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The object under the pointer is the one at the smallest *t* ≥ 0 of the pick ray. A tie needs a rule of its "
          "own.",
      .cost =
          "O(*n*) bounding volumes, most trivial rejects; full tests where met. In a hierarchy tests grow as lg *n* if "
          "boxes overlap little.",
      .choose =
          "Pick by a ray where you need the point or the triangle. Where only the GPU knows the shapes, draw ids into "
          "a buffer and read one pixel.",
      .used =
          "Modelling and CAD programs, strategy games, pointers in virtual reality; Raycaster in three.js, "
          "Physics.Raycast in Unity.",
      .bug = "With *t* alone the order of tests decides a tie: the selection flickers when a hierarchy is rebuilt.",
      .bug_preset = "tie",
      .reading = {"Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.3."},
      .exercises = {
          {"Drag the pointer to where the ray hits two objects at the same *t*.",
           "The two balls touch in a point that the eye sees at the height 0.25: (0.25, 0.5625) on the image plane.",
           "front",
           tied,
           {{"pointer", "-1.5,0.25,0.5625"}}},
          {"Drag the pointer to where the ray meets a bounding ball but not the object in it.",
           "The gem's ball contains void: at (0.5, −0.75) the ray misses the gem and picks the crate.",
           "front",
           through_void,
           {{"pointer", "-1.5,0.5,-0.75"}}},
          {
              "A window has 1920 × 1080 pixels and a vertical field of view of 90°. Which **d** belongs to pixel (960, "
              "0)?",
              "Half the height is 540 pixels, and tan 45° = 1. The pixel's centre lies 0.5 right and 539.5 above: "
              "**d** = **forward** + (0.5/540) **right** + (539.5/540) **up**.\n"
              "A window counts its rows from the top, against **up**. Without the change of sign a click picks what "
              "lies as far on the other side of the middle row.",
          },
          {"10 000 objects have 500 triangles each, and the ray meets 12 bounding balls. How many tests are needed?",
           "10 000 + 12 · 500 = 16 000, instead of 5 000 000. All 12 are tested: the first in a list that is hit may "
           "lie behind another."},
          {"A cable is drawn as a line, at a depth of 50. With *φ* = 60° and 1080 rows, how close to it must a pick "
           "ray pass to be within 5 pixels?",
           "There half the image spans 50 · tan 30° = 28.87, and 540 pixels. So a pixel is 0.0535, and five are 0.267. "
           "That grows with the depth: a fixed length is many pixels close by, and less than one far away. So compare "
           "the distance of ray and segment with five pixels at that depth. Or project the segment, and measure in the "
           "window.\n"
           "The ray itself passes beside most lines thinner than a pixel. Of several within five pixels a rule must "
           "choose. What the ray itself hits comes first, and hides what lies behind. Else take the least distance in "
           "pixels, then the least depth."},
      }};
  return closing;
}

}  // namespace isect::lessons::picking_lesson
