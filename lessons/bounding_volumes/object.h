#pragma once
// An object as a mesh, and the volumes around it.

#include <string>
#include <vector>

#include <isect/convex_hull_3d.h>
#include <isect/counted.h>
#include <isect/triangle_mesh.h>
#include "viz/lesson.h"

namespace isect::lessons::bounding_volumes_lesson {

inline const std::vector<std::string> objects = {"pin", "bracket", "ball"};
inline const std::vector<std::string> sizes_of_dops = {"6", "14", "18", "26"};

/// The mesh of an object whose long axis runs from -tip to tip, in coordinates of 32 binary places.
TriangleMesh<double> object(const std::string& name, const viz::Vec3& tip);

/// The volumes around a mesh. Every one holds all of its vertices, exactly.
struct Fitted {
  Fitted(const TriangleMesh<double>&, int k);

  double object;  ///< its volume
  Hull3<double> hull;
  Sphere<double, 3> ball;
  Aabb<double, 3> aabb;
  Obb<double, 3> obb;
  Kdop<double, 3> kdop;
};

/// One volume in numbers.
struct Measured {
  std::string name;
  double volume, void_volume;  ///< the latter: what the object in it leaves empty
  std::size_t numbers;         ///< kept
  Tally tally;                 ///< of one overlap test with a copy that it meets; nothing for the hull
  viz::Item drawn;

  int operations() const { return tally.mul + tally.add + tally.div + tally.sqrt + tally.compare; }
};
/// Around an object of this volume.
Measured measured(const Kdop<double, 3>&, double object);
/// The k-DOPs of all sizes around an object of this hull and volume.
std::vector<Measured> measured_kdops(const Hull3<double>&, double object);
/// Sphere, AABB, OBB, k-DOP, hull.
std::vector<Measured> measured(const Fitted&, const Measured& kdop);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::bounding_volumes_lesson
