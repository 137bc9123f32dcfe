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
  const char* note;  ///< one sentence on what is special, with the point where it is given
};

/// The first is the one to start with.
const std::vector<Situation>& situations();
const Situation& situation(const std::string& id);
/// So many corners has the polygon with most of them.
int most_corners();

/// A situation with its point and its corners perhaps moved, and what is true of it by the exact test.
struct Setup {
  explicit Setup(const viz::Parameters&);
  /// Of any polygon; the situation then has no corners and no note.
  Setup(const Point<double, 2>&, const Polygon<double, 2>&);

  const Situation& situation;
  Point<double, 2> p;
  Polygon<double, 2> polygon;
  bool simple;  ///< one ring that neither crosses nor meets itself: what Jordan's theorem speaks of
  Winding truth;

  /// Nothing was moved.
  bool as_given() const { return p == situation.p && polygon.rings == situation.polygon.rings; }

  /// The vertices on the ray, its origin left out.
  int vertices_on_ray() const;
};

}  // namespace isect::lessons::crossings_lesson
