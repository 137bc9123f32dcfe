// What a reader takes along from a convex polygon, and what there is to do.

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;

namespace {

Setup setup_of(const Parameters& values) {
  return {std::stoi(std::get<std::string>(values.at("n"))), flat_point(values, "p")};
}

bool on_the_boundary(const Parameters& values) { return setup_of(values).truth == Location::on; }

bool rejected_by_two_orientations(const Parameters& values) {
  const Setup s = setup_of(values);
  Record<point_convex_polygon::Event> record;
  locate(s.p, s.polygon, record);
  return std::holds_alternative<point_convex_polygon::Fan>(record.events.back());  // nothing was asked after it
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Must every edge be tested? Not for a convex polygon: the lecture note *Intersection Detection* finds a point in "
      "O(lg *n*).\n"
      "Seen from one place, the vertices come in angular order. So bisection finds the one edge that decides.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Seen from a vertex, the others come in angular order within half a turn. Bisection finds the wedge of "
          "**p**; its far edge decides.",
      .cost =
          "At most 3 + 3 ⌈lg (*n* − 2)⌉ orientations, 63 for a million vertices. Checking that the polygon is convex "
          "takes O(*n*), once: left turns alone, and once around. A pentagram goes twice around.",
      .choose =
          "For convex polygons of many vertices, in an array. With only a few, test every edge. Wedges around **q** "
          "serve "
          "star-shaped ones, too, if **q** sees their whole boundary. Other concave ones need crossings, or a prepared "
          "map.",
      .used =
          "Hit tests on convex regions, Voronoi cells, projected faces of convex solids, support points by the "
          "same bisection.",
      .bug = "Trusting a rounded yes or no on the boundary. Methods that agree elsewhere differ there.",
      .bug_preset = "on-vertex",
      .reading =
          {"Michael Ian Shamos, Geometric Complexity, *ACM Symposium on Theory of Computing*, 1975, pages 224–233.",
           "Franco Preparata and Michael Shamos, *Computational Geometry: An Introduction*, 1985, section 2.2.1."},
      .exercises = {
          {"Drag **p** exactly onto the boundary.",
           "The middle of an edge has coordinates without rounding here: (−1.125, 0.875).",
           "beyond-last",
           on_the_boundary,
           {{"p", "-1.125,0.875,0"}}},
          {"Drag **p** to where two orientations are enough to reject it. And what do all of them say?",
           "Outside one of the two edges at **v**_0, as (2.75, 1.25) is.\n"
           "Counter-clockwise, **p** lies in the polygon if and only if no orientation of **v**_i, **v**_{i+1} and "
           "**p** is negative. In clockwise order the signs turn, and also where *y* points down. So "
           "take the sign of the polygon's area first.",
           "inside",
           rejected_by_two_orientations,
           {{"p", "2.75,1.25,0"}}},
          {"How many orientations can a polygon of 1000 vertices take? And how many a test of every edge?",
           "lg 998 is a little less than 10, rounded up 10. So at most 3 + 3 · 10 = 33.\n"
           "Testing every edge takes 1000 for a point inside. Outside it may stop at the first edge that has **p** on "
           "its "
           "outer side. Seen from far away about half of the edges of a round polygon have. A bounding box rejects "
           "such points first."},
          {"Why does a vertex as apex need no angles, while an interior point needs a case distinction? And what goes "
           "wrong with atan2?",
           "The centroid weighs three vertices by 1/3 each, so it lies inside their triangle. A convex polygon "
           "contains that.\n"
           "From a vertex all directions lie within half a turn, where one sign orders any two. Around an interior "
           "point they fill the whole turn, and at that point itself **p** is inside, at once. On a ray between "
           "two wedges either gives the same verdict. Vertices in no order are sorted first, by angle around an "
           "interior point, or by taking their hull: O(*n* lg *n*).\n"
           "The case distinction asks whether **v** and **p** lie on one side of the line from **q** through "
           "**v**_0. If so, one cross product orders them; else the left one comes first.\n"
           "atan2 gives angles from −*π* to *π*. It jumps from one to the other where a direction points straight "
           "to the left. Bisection takes angles for sorted, so it may choose a wrong wedge there. Subtract the "
           "angle of **v**_0, and add 2*π* if the result is negative."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::convex_polygon_lesson
