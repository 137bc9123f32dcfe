#pragma once
// Polygons and points in which the crossings' special cases occur, each exactly.

#include <string>
#include <vector>

#include <isect/point_polygon.h>
#include "viz/lesson.h"

namespace isect::lessons::crossings_lesson {

struct Situation {
  const char* id;
  const char* title;
  Point<double, 2> p;
  Polygon<double, 2> polygon;
  const char* note;  ///< one sentence on what is special about the given point
};

/// All situations, the first of which is shown at the start.
const std::vector<Situation>& situations();
const Situation& situation(const std::string& id);
/// The largest number of corners of any polygon here.
int most_corners();

/// A situation with its point and its corners perhaps moved, and what is true of it by the exact test.
struct Setup {
  explicit Setup(const viz::Parameters&);
  /// For any polygon; its situation has no corners and no note.
  Setup(const Point<double, 2>&, const Polygon<double, 2>&);

  const Situation& situation;
  Point<double, 2> p;
  Polygon<double, 2> polygon;
  bool simple;  ///< one ring that neither crosses nor meets itself, as Jordan's theorem requires
  Winding truth;

  /// Whether nothing was moved.
  bool as_given() const { return p == situation.p && polygon.rings == situation.polygon.rings; }

  /// The vertices on the ray, its origin left out.
  int vertices_on_ray() const;
};

}  // namespace isect::lessons::crossings_lesson
