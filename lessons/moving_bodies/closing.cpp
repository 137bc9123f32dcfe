// What a reader takes along from moving bodies, and what there is to do.

#include "lessons/moving_bodies/picture.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

bool slide_along(const Parameters& p) { return setup(p).truth == Meeting::grazing; }
bool tunnel(const Parameters& p) { return setup(p).truth == Meeting::unseen; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Two bodies move at constant velocities. Do they meet within a given time, and when first? Physics engines ask "
      "this of fast bodies.\n"
      "The lecture note *Intersection Detection* lets rays stand in for moving objects. This lesson goes on from "
      "there: "
      "two bodies that move are one that moves.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Only the relative velocity **d** counts. Boxes first meet at the latest begin of all axes' times, unless an "
          "end is earlier. Balls meet where a ray enters a ball of radius *R* = *r*_a + *r*_b.",
      .cost =
          "Boxes: two divisions for each axis. Balls: one square root and one division. Conservative steps: a distance "
          "and a division each.",
      .choose =
          "Boxes and balls at constant velocities: compute the time. Discrete times for slow bodies only. Conservative "
          "advancement for other convex bodies, and if they turn.",
      .used = "Continuous collision detection in physics engines such as Box2D; bullets in games; robots' motion.",
      .bug = "Comparing each body's own step with its size, not the relative one.",
      .bug_preset = "tunnels",
      .reading =
          {"Lecture note *Intersection Detection*, rays, and collision detection.",
           "Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.5: dynamic intersection tests.",
           "Brian Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, dissertation, University of "
           "California at Berkeley, 1996: conservative advancement.",
           "Erin Catto, Continuous Collision, *Game Developers Conference*, 2013."},
      .exercises = {
          {"Drag **b** until the boxes slide along each other: they touch, and do not overlap.",
           "On *y* they do not move against each other. There *b* must be 0.75 + 0.5 = 1.25 higher than *a*, or lower.",
           "head-on",
           slide_along,
           {{"b", "2.25,0.75,0"}}},
          {"A test sees the two boxes. Give b a velocity with which they tunnel.",
           "The contact must be shorter than dt = 0.25, and lie between two tests. At a relative speed of 10 it lasts "
           "for 1 / 10 = 0.1, from 0.275 to 0.375.",
           "seen",
           tunnel,
           {{"v_b", "-8,0,0"}}},
          {"Balls of radius 1 start at (0, 0) and (10, 0), with velocities (2, 0) and (−3, 0). When do they meet?",
           "The relative speed is 5. Of the distance 10 only 8 must be covered, as *R* = 2. So *t* = 8 / 5 = 1.6."},
          {"Why is the test of two boxes that of a ray against slabs?",
           "Seen from a, **b** is a point on a ray along **d**, once a is expanded by b: their Minkowski sum. On each "
           "axis that box is a slab, and *t*_1 and *t*_2 are where the ray enters and leaves it."},
          {"With the bound along the line of centres, why does no step pass the contact?",
           "The distance is a convex function of *t*. The step ends where its tangent is 0, and a tangent lies nowhere "
           "above such a function. It is Newton's method, and converges quadratically unless b grazes a."},
      }};
  return closing;
}

}  // namespace isect::lessons::moving_bodies_lesson
