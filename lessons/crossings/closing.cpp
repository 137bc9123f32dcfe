// What a reader takes along from counting crossings, and what there is to do.

#include "lessons/crossings/telling.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;

namespace {

bool closed_rule_is_wrong(const Parameters& values) {
  const Setup s(values);
  int count = 0;
  for (const Ring<double, 2>& ring : s.polygon.rings) count += point_polygon::crossings_closed(s.p, ring);
  return s.truth.even_odd != Location::on && (count % 2 != 0) != (s.truth.even_odd == Location::in);
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Does a point lie in a polygon? Maps test regions this way, text renderers every pixel.\n"
      "The lecture note *Intersection Detection* walks along a ray from the point to infinity. Each edge crossed "
      "switches between inside and outside.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Off the boundary **p** lies inside if and only if a ray from it crosses an odd number of edges. Half-open "
          "edges give the count of a ray raised by *ε*, which meets no vertex.",
      .cost =
          "O(*n*): two comparisons for each edge, and one orientation where it straddles the ray's line. No "
          "preprocessing.",
      .choose =
          "For few points, or polygons that change. Convex polygons allow bisection in O(lg *n*). For many points, "
          "prepare slabs or trapezoids.",
      .used =
          "Map queries (PNPOLY), ray against polygon after projection. Filling: fonts by the non-zero rule, PDF and "
          "SVG by either.",
      .bug = "Edges that count with both ends: a vertex on the ray counts twice, and inside becomes outside.",
      .bug_preset = "vertex-passed-closed",
      .reading =
          {"M. Shimrat, Algorithm 112: Position of Point Relative to Polygon, *Communications of the ACM* 5, 1962, "
           "page 434.",
           "W. Randolph Franklin, PNPOLY: Point Inclusion in Polygon Test, 1970.",
           "Eric Haines, Point in Polygon Strategies, in: *Graphics Gems IV*, 1994, pages 24–46.",
           "Kai Hormann and Alexander Agathos, The Point in Polygon Problem for Arbitrary Polygons, *Computational "
           "Geometry* 20, 2001, pages 131–144."},
      .exercises = {
          {"Drag **p** to a place where the closed rule gives a wrong answer.",
           "At the height −0.5 the ray passes the vertex (2.25, −0.5), which counts twice. So (−0.75, −0.5) seems to "
           "lie outside.",
           "inside-closed",
           closed_rule_is_wrong,
           {{"p", "-0.75,-0.5,0"}}},
          wrong_line(),
          {"A square has the corners (0, 0), (2, 0), (2, 2), (0, 2). Which edges count for **p** = (−1, 2), and which "
           "for (−1, 0)?",
           "At the height 2 none: the upper corners count as below, so no end lies above. At the height 0 the two "
           "vertical ones: each joins a lower corner, below, to an upper one, above. Two is even: OUT. Compare the "
           "coordinates as given. To subtract **p** from the vertices first would round, and move each by itself."},
          {"A font draws a letter as two strokes that overlap, both counter-clockwise. Which rule must fill it? And "
           "which loops of a figure eight does each rule fill?",
           "The non-zero rule: where the strokes overlap, the winding number is 2. Even-odd would leave a hole there. "
           "Both rules fill both loops of a figure eight, where it is 1 and −1.",
           "figure-eight"},
          {"Why does the half-open rule count what a ray raised by *ε* crosses? And why not shift **p** at random?",
           "Choose *ε* smaller than the rise to the next vertex. Vertices at the ray's height lie below the raised "
           "ray, all others keep their side.\n"
           "A random shift makes vertices on the ray rare, not impossible, and two runs may differ. It may also carry "
           "**p** over an edge. Far from the origin rounding may swallow it. With whole numbers vertices often lie "
           "just at the height of **p**: a wrong row of a grid shows it."},
      }};
  return closing;
}

const std::vector<Erratum>& errata() {
  static const std::vector<Erratum> all = {
      {"    if both above or both below p: next edge", "    if neither or both are above p: next edge",
       "A vertex on the ray belongs to two edges. Counted as below, it lies on one side.", "vertex-passed-closed"},
      {"    if not p.x < x: next edge", "    if p on a b: return ON; if not p.x < x: next edge",
       "A point on the boundary belongs to the polygon. The count takes it for inside or outside.", "on-edge-closed"}};
  return all;
}

}  // namespace isect::lessons::crossings_lesson
