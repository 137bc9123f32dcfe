#pragma once
// Points, chains, the hull and a bounding volume around it.

#include <isect/shapes.h>
#include "viz/lesson.h"

namespace isect::lessons::convex_hull_lesson {

enum class Bounding { none, ball, aabb, obb };

struct Drawn {
  Ring<double, 2> points;
  std::vector<Ring<double, 2>> done;  ///< finished chains
  Ring<double, 2> chain, removed;
  Ring<double, 2> hull;
  bool upper = false;
  Bounding bounding = Bounding::none;
};
viz::Scene picture(const Drawn&);

/// A bounding volume of points: its names, how many numbers store it, and its area.
struct Measured {
  const char *slug, *name;
  std::size_t numbers;
  double area;
};
Measured measured(const Ring<double, 2>& points, Bounding);
double area(const Ring<double, 2>& convex);

viz::Walk tell(const Ring<double, 2>& points);  // telling.cpp
/// The points of a setting; the last one can be dragged. (lesson.cpp)
Ring<double, 2> points_of(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::convex_hull_lesson
