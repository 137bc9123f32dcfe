#pragma once
// What a plane lesson draws: its points have z = 0.

#include <vector>

#include <isect/shapes.h>
#include "viz/scene.h"

namespace isect::lessons {

inline viz::Vec3 flat(const Point<double, 2>& p) { return {p.x(), p.y(), 0}; }

inline std::vector<viz::Vec3> flat(const Ring<double, 2>& ring) {
  std::vector<viz::Vec3> points;
  for (const Point<double, 2>& p : ring) points.push_back(flat(p));
  return points;
}

/// Counter-clockwise from the lower corner.
inline std::vector<viz::Vec3> corners(const Aabb<double, 2>& b) {
  return flat(Ring<double, 2>{b.lo, {b.hi.x(), b.lo.y()}, b.hi, {b.lo.x(), b.hi.y()}});
}

inline viz::Vec3 middle(const Aabb<double, 2>& b) { return flat((b.lo + b.hi) / 2); }

}  // namespace isect::lessons
