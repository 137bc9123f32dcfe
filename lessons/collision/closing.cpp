// What a reader takes along from collisions, and what there is to do.

#include <isect/many/all_pairs.h>
#include "lessons/collision/telling.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

/// Box 0 overlaps no other box.
bool box_0_alone(const Parameters& p) {
  bool alone = true;
  all_pairs::brute_force(few(p), [&](int i, int j) { alone = alone && i != 0 && j != 0; });
  return alone;
}

bool tunnels(const Parameters& p) {
  const Encounter e = encounter(std::get<Vec3>(p.at("p")), std::get<double>(p.at("speed")));
  return e.contact && !e.seen && !e.grazes;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Which of many bodies touch, and when? Games, robots and simulations need this in every frame.\n"
      "The lecture note *Intersection Detection* calls collision detection an intersection test among moving objects. "
      "The key idea is to leave most pairs untested.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result = "Where few boxes overlap, sorting or a hierarchy leaves few tests. Discrete times may miss a hit.",
      .cost =
          "Brute force O(*n*^2). Sweep: sort, then pairs that meet on an axis. Hierarchy: O(*n* lg *n*) if few meet.",
      .choose =
          "Brute force below a few dozen bodies. Sweep where little moves between frames; a bounding volume hierarchy "
          "or grid for large scenes. Continuous collision detection for fast bodies.",
      .used = "Broad phase (all pairs), narrow phase (GJK, contacts), continuous: Bullet, Box2D, Jolt, PhysX.",
      .bug = "Testing at discrete times only: a step longer than wall and body together can tunnel.",
      .bug_preset = "tunnelling",
      .reading = {"Christer Ericson, *Real-Time Collision Detection*, 2005, section 7.5 and section 5.5.",
                  "Jonathan Cohen et al., I-COLLIDE, *Symposium on Interactive 3D Graphics*, 1995, pages 189–196: "
                  "sweep and prune.",
                  "Gino van den Bergen, *Collision Detection in Interactive 3D Environments*, 2004, chapter 5."},
      .exercises = {
          {"Drag box 0 until it overlaps no other box.",
           "Some axis must separate it from each of the others. Separating axes need convex shapes: cut a body with "
           "dents into convex parts (a compound), and test each pair of parts. The hull alone would fill the dents: a "
           "bowl would have a lid.",
           "brute-force",
           box_0_alone,
           {{"p", "-2.5,-1.5,0"}}},
          {"The slow box does not tunnel. Choose speed and **p** so that it does.",
           "The step must be longer than 0.7, and the box must be before the wall at one time and past it at the next.",
           "slow",
           tunnels,
           {{"speed", "5"}}},
          {"A body 0.1 m long flies at 30 m/s towards a wall of 0.45 m. Tests run at 60 Hz. Can it tunnel?",
           "One step is 30 / 60 = 0.5 m. Wall and body together are 0.55 m. As 0.5 < 0.55, it cannot. At 120 Hz every "
           "body takes twice as many tests. One faster than 0.55 · 120 = 66 m/s still can."},
          {"Of 1000 bodies, 900 never move. How many pairs are left to test? And where does a uniform grid save "
           "little?",
           "Pairs of two bodies at rest are dropped: 900 · 899 / 2. Of 499 500 pairs, 94 950 are left.\n"
           "A grid lists each body in every cell that it meets, and tests the pairs within a cell. Where one cell "
           "holds almost all bodies, almost all pairs are left. A body much larger than the cells is listed in very "
           "many. Count the tests in each frame: near *n* (*n* − 1) / 2, nothing is saved."},
          {"Find boxes for which sweep and prune tests all pairs, though none overlap.",
           "Wide, flat boxes on a gentle slope. The sweep runs along the axis on which their centres spread most: "
           "there all intervals meet, and on the other one gaps part them. That spread is the variance of the centres. "
           "Where little has moved since the last frame, insertion sort renews the order at little cost: O(*n* + "
           "inversions). Where one box ends and another begins at the same number, let the other begin first: they "
           "touch. Else that pair is lost."},
      }};
  return closing;
}

const std::vector<Erratum>& errata() {
  static const std::vector<Erratum> all = {{"    for j ← i to n − 1", "    for j ← i + 1 to n − 1",
                                            "From *i* on, each box is tested against itself, and overlaps it.",
                                            "brute-force"}};
  return all;
}

}  // namespace isect::lessons::collision_lesson
