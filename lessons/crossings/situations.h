#pragma once
// Polygons and points in which the crossings' special cases occur, each exactly.

#include <string>
#include <vector>

#include <isect/point_polygon.h>

namespace isect::lessons::crossings_lesson {

struct Situation {
  const char* id;
  const char* title;
  Point<double, 2> p;
  Polygon<double, 2> polygon;
  const char* note;    ///< one sentence on what is special, with the point where it is given
  bool simple = true;  ///< one ring that neither crosses nor meets itself: what Jordan's theorem speaks of
};

/// The first is the one to start with.
const std::vector<Situation>& situations();
const Situation& situation(const std::string& id);

/// A situation with its point perhaps moved, and what is true of it by the exact test.
struct Setup {
  Setup(const Situation& the_situation, const Point<double, 2>& the_point)
      : situation(the_situation), p(the_point), truth(winding(p, situation.polygon)) {}

  const Situation& situation;
  Point<double, 2> p;
  Winding truth;

  /// The vertices on the ray, its origin left out.
  int vertices_on_ray() const;
};

}  // namespace isect::lessons::crossings_lesson
