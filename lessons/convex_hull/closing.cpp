// What a reader takes along from the convex hull, and what there is to do.

#include <algorithm>

#include <isect/convex_hull.h>
#include "lessons/convex_hull/picture.h"

namespace isect::lessons::convex_hull_lesson {

using namespace viz;

namespace {

bool is_vertex(const Ring<double, 2>& points, const Point<double, 2>& p) {
  return std::ranges::count(isect::convex_hull(points), p) > 0;
}

/// The point that can be dragged lies within the hull of the others.
bool swallowed(const Parameters& p) {
  const Ring<double, 2> points = points_of(p);
  return !is_vertex(points, points.back());
}

bool triangle(const Parameters& p) { return isect::convex_hull(points_of(p)).size() == 3; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Which is the tightest convex volume around given points? Collision tests want it, as convex sets are easy to "
      "separate.\n"
      "Sort the points, then walk along them and keep only left turns. The lecture note *Intersection Detection* names "
      "the hull; this method builds it.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The hull is the intersection of all convex sets that contain the points. Where it has an area, its "
          "boundary goes round once and turns left at every vertex.",
      .cost =
          "O(*n* lg *n*) for the sort. The scan is linear, as a point leaves a chain at most once. Output-sensitive "
          "methods take O(*n* lg *h*) for *h* vertices.",
      .choose = "For rigid bodies whose hull is small. A box or ball is cheaper to keep, to test and to update.",
      .used =
          "Physics engines wrap bodies in hulls of few vertices; GJK and the separating axis test run on them. "
          "Also shadow and occlusion volumes.",
      .bug = "An **if** instead of the **while**: one point is dropped where several must be.",
      .bug_preset = "scattered",
      .reading = {"Alex M. Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions, *Information "
                  "Processing Letters* 9, 1979, pages 216–219.",
                  "David Kirkpatrick and Raimund Seidel, The Ultimate Planar Convex Hull Algorithm?, *SIAM Journal on "
                  "Computing* 15, 1986, pages 287–299.",
                  "Donald Knuth, *The Art of Computer Programming*, volume 3, 2nd edition, 1998, section 5.3.1: "
                  "minimum-comparison sorting.",
                  "Michael Ben-Or, Lower Bounds for Algebraic Computation Trees, *Symposium on Theory of Computing*, "
                  "1983, pages 80–86.",
                  "Timothy Chan, Optimal Output-Sensitive Convex Hull Algorithms in Two and Three Dimensions, "
                  "*Discrete & Computational Geometry* 16, 1996, pages 361–368.",
                  "Franco Preparata and Michael Shamos, *Computational Geometry: An Introduction*, 1985, chapter 3.",
                  "Mark de Berg et al., *Computational Geometry: Algorithms and Applications*, 3rd edition, 2008, "
                  "section 1.1."},
      .exercises = {
          {"Drag **p** until it is no vertex of the hull.",
           "Any place inside the hull of the other points will do, or one on its boundary.",
           "scattered",
           swallowed,
           {{"p", "0,0,0"}}},
          {"Drag **p** until the hull is a triangle.",
           "Any place off the line will do: **p** and the two ends of the row are the vertices.",
           "one-line",
           triangle,
           {{"p", "0,1.5,0"}}},
          {"Why is the scan linear despite its nested loops?",
           "A point is appended once to a chain and dropped from it at most once. So each of the two chains takes at "
           "most 2*n* steps."},
          {"Why does no method find every hull faster than it sorts?",
           "Map the numbers *x* to the parabola *y* = *x*^2. All points are vertices, and the hull lists them in "
           "order. That is the worst case.\n"
           "There are *n*! orders, and each comparison has an answer that leaves at least half of those still "
           "possible. So at worst sorting takes lg(*n*!) comparisons or more: of order *n* lg *n* (Knuth). Signs of "
           "polynomials "
           "of bounded degree, such as orientations, do not lower that order (Ben-Or).\n"
           "Where only *h* of the points are vertices, Kirkpatrick and Seidel's and "
           "Chan's methods take O(*n* lg *h*): output-sensitive time."},
          {"Rounding makes one orientation wrong. What can happen to the hull?",
           "It may lose a true vertex or keep a dent, so that it is not convex. An exact predicate for the orientation "
           "prevents both."},
      }};
  return closing;
}

}  // namespace isect::lessons::convex_hull_lesson
