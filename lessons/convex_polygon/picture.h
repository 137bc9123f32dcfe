#pragma once
// The two walks, and the picture they share.

#include <memory>

#include <isect/point_convex_polygon.h>
#include "lessons/shared/location.h"
#include "viz/lesson.h"

namespace isect::lessons::convex_polygon_lesson {

/// A convex polygon, and what is true of the point by the exact test.
struct Setup {
  /// The lesson's polygon with n vertices on an ellipse.
  Setup(int n, const Point<double, 2>& the_point);
  /// Any polygon: three vertices or more, counter-clockwise, no three on one line.
  Setup(ConvexPolygon<double>, const Point<double, 2>& the_point);

  std::shared_ptr<const ConvexPolygon<double>> own;  ///< null where the polygon is one of the lesson's
  const ConvexPolygon<double>& polygon;
  Point<double, 2> p;
  Location truth;

  int size() const { return static_cast<int>(polygon.vertices.size()); }
  const Point<double, 2>& vertex(int i) const { return polygon.vertices[i % size()]; }
};

viz::Walk fan(const Setup&);       ///< from vertex 0, exact
viz::Walk centroid(const Setup&);  ///< the note's, in plain floating point

/// What a step shows.
struct Shown {
  Point<double, 2> apex;  ///< v0 or the centroid
  std::string apex_name;
  int lo = -1, hi = -1;  ///< the wedge; -1: none yet
  int mid = -1;          ///< the ray asked; -1: none
  bool edge = false;     ///< the wedge's edge is asked
  bool on = false;
};
/// The most rays of the fan that are drawn; with more vertices some are left out.
inline constexpr int most_rays = 64;
viz::Scene picture(const Setup&, const Shown&);
std::string alt_text(const Setup&);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

}  // namespace isect::lessons::convex_polygon_lesson
