// What a reader takes along from distances, and what there is to do.

#include "lessons/distance/picture.h"

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

bool now_second_end(const Parameters& p) {
  const Setup s = setup(p);
  return s.is("point") && s.pairs.front().on_a == Nearest::q;
}
bool now_interval(const Parameters& p) {
  const Setup s = setup(p);
  return s.is("segments") && s.kind() == Kind::interval;
}
bool now_corners(const Parameters& p) {
  const Setup s = setup(p);
  return s.is("boxes") && s.kind() == Kind::ends;
}
bool now_misled(const Parameters& p) {
  const Setup s = setup(p);
  return s.is("capsules") && s.beyond > 0 &&
         nearest_features::within_by_squares(s.capsule(0), s.capsule(1), s.clearance);
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "How far apart are two shapes, and where are they nearest? Whoever must keep a clearance asks more than whether "
      "shapes meet.\n"
      "The idea: find the features that contain the nearest points. Squared distances are compared, without a root.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The distance of two convex sets is one number, but many pairs of points may be that far apart. "
          "Compare squares: *d*^2 with the square of a bound that is at least 0.",
      .cost =
          "A point and a segment: one division at most. Two segments: two at most. Two boxes: three squares. "
          "No root until the number itself is wanted.",
      .choose =
          "If a bound is known, compare squares. Take the root for a clearance or a safe step. For general convex "
          "shapes use GJK.",
      .used =
          "Clearance of parts in CAD and of robots, conservative advancement of moving bodies. "
          "Sphere tracing and soft shadows step along a ray by such a distance.",
      .bug = "Clamping both places of two lines each by itself. After one has moved, the other has to be found anew.",
      .bug_preset = "clamped-once",
      .reading =
          {"Christer Ericson, *Real-Time Collision Detection*, 2005, section 5.1: closest-point computations.",
           "Vladimir Lumelsky, On Fast Computation of Distance Between Line Segments, *Information Processing Letters* "
           "21, 1985, pages 55–61.",
           "Brian Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, dissertation, University of "
           "California at Berkeley, 1996: conservative advancement.",
           "Ming Lin and John Canny, A Fast Algorithm for Incremental Distance Calculation, *IEEE International "
           "Conference on Robotics and Automation*, 1991, pages 1008–1014.",
           "Brian Mirtich, V-Clip: Fast and Robust Polyhedral Collision Detection, *ACM Transactions on Graphics* 17, "
           "1998, pages 177–208.",
           "John C. Hart, Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing of Implicit Surfaces, "
           "*The Visual Computer* 12, 1996, pages 527–545.",
           "Inigo Quilez, Soft Shadows in Raymarched SDFs, *iquilezles.org*."},
      .exercises = {
          {"Move **c** until the second end of the segment is nearest.",
           "(**c** − **p**_a) · **d** must be at least **d** · **d**. (3, 1, 0) is such a place.",
           "interior",
           now_second_end,
           {{"c", "3,1,0"}}},
          {"Place b so that a whole interval of pairs is nearest.",
           "b must be parallel to a, and reach alongside it: such as from (0, 1, 0) to (3, 1, 0). If b shrinks to a "
           "point, **d**_b · **d**_b is 0. Lines 5 and 7 do not show what the code does then: it divides only where "
           "the numerator lies between 0 and the denominator. So it takes *t*_b = 0.\n"
           "In the plane, two edges of disjoint convex polygons are nearest between their ends only if they are "
           "parallel. So a vertex is among the nearest features. In space two edges may be nearest alone, as of two "
           "tetrahedra.",
           "end-and-interior",
           now_interval,
           {{"p_b", "0,1,0"}, {"q_b", "3,1,0"}}},
          {"Move a corner of the box b, until two corners are nearest.",
           "A gap on each axis does it. With the lower corner (0.75, 1, 1) there are three, if the upper one is above "
           "it.\n"
           "For convex polyhedra that move little, Lin and Canny test the last pair of nearest features. If it is not "
           "nearest any more, they walk to neighbours of its features until it is. Where bodies penetrate, the "
           "walk may cycle (Mirtich).\n"
           "The pair is right while each of its points lies in the region of the other's feature. If the bodies have "
           "moved by less than a feature, a step or two is enough, however many there are: O(1). With dents the walk "
           "may stop at a pair that is not nearest. So compare it with all pairs, now and then.",
           "faces",
           now_corners,
           {{"b_min", "0.75,1,1"}, {"b_max", "2.5,2,2"}}},
          {"A capsule from (0, 0, 0) to (4, 0, 0) has radius 1, one from (2, 3, 4) to (2, 6, 8) radius 2. How far "
           "apart are their surfaces? And how is a distance checked without another program?",
           "The end (2, 3, 4) is nearest, to (2, 0, 0): *d* = 5. The surfaces are 5 − 3 = 2 apart.\n"
           "No two points, one of each segment, may be less than *d* apart: try many. Exchanged segments must have the "
           "same distance, but for rounding. If one moves by 0.01, it may change by 0.01 at most. A jump may "
           "show a division by a *det* of nearly 0."},
          {"Find a clearance for which squares alone say near, and wrongly so.",
           "The bound must be below 0 and large in size: with a clearance of −2.5 it is −1.75, while *d* is 1.25.",
           "near",
           now_misled,
           {{"clearance", "-2.5"}}},
      }};
  return closing;
}

}  // namespace isect::lessons::distance_lesson
