#pragma once
// Kirkpatrick's hierarchy of triangulations, for polygons of a few vertices: finest level first. Exact in its
// decisions: orientations, and the core's tests of convex polygons.
//
// Source: Kirkpatrick, Optimal search in planar subdivisions, SIAM J. Comput. 12 (1983).

#include <array>
#include <vector>

#include <isect/shapes.h>

namespace isect::lessons::concave_polygon_lesson {

struct Triangle {
  std::array<int, 3> corners;   ///< counter-clockwise
  bool inside = false;          ///< of the polygon; on the finest level
  std::vector<int> links = {};  ///< triangles of the finer level with which it shares area
};
struct Level {
  std::vector<Triangle> triangles;
  std::vector<int> removed;  ///< vertices that the next level lacks: no two joined by an edge
};
struct Hierarchy {
  std::vector<Point<double, 2>> vertices;  ///< the polygon's, then the four corners of the box
  std::vector<Level> levels;               ///< finest first; the last one has two triangles

  Ring<double, 2> triangle(const Triangle& t) const;
};

/// Builds the hierarchy of a simple polygon, counter-clockwise, in the interior of a box.
Hierarchy make_hierarchy(const Ring<double, 2>& ring, const Aabb<double, 2>& box);

/// The triangle that holds the point on each level, from the coarsest to the finest; nothing outside of the box.
std::vector<int> descend(const Hierarchy&, const Point<double, 2>&);

}  // namespace isect::lessons::concave_polygon_lesson
