// What a reader takes along from three ways to locate a point, and what there is to do.

#include <algorithm>

#include "lessons/concave_polygon/picture.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

bool on_the_boundary(const Parameters& p) { return Setup(p).truth == Location::on; }

bool level_with_a_vertex(const Parameters& p) {
  const Setup s(p);
  return s.truth == Location::in &&
         std::ranges::any_of(s.ring, [&](const Point<double, 2>& v) { return v.y() == s.p.y(); });
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Can a point be located in a *concave* polygon in O(lg *n*), too? The lecture note *Intersection Detection* "
      "leaves "
      "that open.\n"
      "Yes, after preprocessing: split the plane into simple pieces, mark each inside or outside, and search for the "
      "piece.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result = "Every simple polygon can be preprocessed so that any point is located in O(lg *n*).",
      .cost =
          "Slabs, swept: O(*n*^2) time and space. Trapezoids: O(*n* lg *n*) and O(*n*), expected. Kirkpatrick: the "
          "same, guaranteed. A query: O(lg *n*); in slabs by bisection, in trapezoids expected.",
      .choose =
          "Few points: count crossings, without preprocessing. Many points, one fixed polygon: trapezoids. Slabs "
          "only for small *n*.",
      .used =
          "Map services, locating points in meshes and Voronoi diagrams. CGAL prepares arrangements with a trapezoidal "
          "map.",
      .bug =
          "Slabs that leave out both of their lines: a point level with a vertex lies in none, and counts as outside.",
      .bug_preset = "slabs-level",
      .reading =
          {"David Kirkpatrick, Optimal Search in Planar Subdivisions, *SIAM Journal on Computing* 12, 1983, pages "
           "28–35.",
           "David Dobkin and Richard Lipton, Multidimensional Searching Problems, *SIAM Journal on Computing* 5, 1976, "
           "pages 181–186.",
           "Franco Preparata and Michael Shamos, *Computational Geometry: An Introduction*, 1985, section 2.2.2.",
           "Raimund Seidel, A Simple and Fast Incremental Randomized Algorithm for Computing Trapezoidal "
           "Decompositions and for Triangulating Polygons, *Computational Geometry* 1, 1991, pages 51–64.",
           "Mark de Berg et al., *Computational Geometry: Algorithms and Applications*, 3rd edition, 2008, chapter 6."},
      .exercises = {
          {"Drag **p** exactly onto the boundary.",
           "Vertices are easy to meet: (−0.875, −0.25) is one.",
           "slabs",
           on_the_boundary,
           {{"p", "-0.875,-0.25,0"}}},
          {"Drag **p** to an interior point level with a vertex.",
           "A vertex has the height −0.25, so (−1.5, −0.25) will do. By the half-open rule a slab includes its lower "
           "line: it must look there, too.",
           "slabs",
           level_with_a_vertex,
           {{"p", "-1.5,-0.25,0"}}},
          {"How many edges can the slabs of a polygon with 200 vertices store at most?",
           "*n*^2/2 = 20 000: between the *k*-th height and the next run at most 2 min(*k*, 200 − *k*) edges. A "
           "sweep that keeps the order from slab to slab takes O(*n*^2) time. Sorting each slab anew takes O(*n*^2 "
           "lg *n*)."},
          {"Why can at least one vertex in 18 be removed each round, the box's corners not counted?",
           "*n* vertices in a box of 4 corners have 3*n* + 5 edges. At least 12 of their ends lie at the corners, so "
           "fewer than 6*n* at the others. At each of these 3 or more meet, so at least half have 8 edges or fewer. Of "
           "these, each one chosen rules out itself and at most 8 others."},
          {"Why does a polygon with *n* vertices, no two at one *x*-coordinate, have 2*n* + 1 trapezoids?",
           "Where the boundary passes a vertex, two trapezoids begin. Where it opens to the right, three begin; where "
           "it closes one. As it opens as often as it closes, that is 2*n*; one begins nowhere. For *n* disjoint "
           "segments it is 3*n* + 1 at most: two begin at a left end, one at a right end. A query takes O(lg *n*) "
           "in the mean over random orders. In sorted order, long spikes make it grow as *n*."},
      }};
  return closing;
}

}  // namespace isect::lessons::concave_polygon_lesson
