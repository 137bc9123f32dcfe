#pragma once
// The ways to give a ray, the walk of each, and the picture they share.

#include <isect/ray_aabb.h>
#include <isect/ray_plane.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::rays_lesson {

enum class Made { direction, unit, points };

struct Setup {
  Made made;
  std::string extent;  ///< "segment", "ray", "line"
  viz::Vec3 o, d, q;   ///< as given: `q` for points, `d` otherwise
  double wall;         ///< its x
  Ray<double, 2> ray;
  Plane<double, 2> plane;
  RayPlane<double> truth;
};
Setup setup(const viz::Parameters&);

/// What a step shows.
struct Shown {
  bool marks = false;    ///< t along the line
  bool range = false;    ///< the part that belongs to the ray
  bool wall = false;     ///< shown only after its question, as a mark of t may stand at it
  bool hit = false;      ///< t in the wall
  bool settled = false;  ///< and whether it counts
};
viz::Scene picture(const Setup&, const Shown&);

const viz::CaseMap& cases();                                      ///< of the wall's place and the direction
viz::Walk tell(const Setup&);                                     ///< a ray against the wall
viz::Walk bullet(const viz::Vec3& p, const viz::Vec3& velocity);  ///< a moving point, as a ray
/// Whether the point is in the wall between the frames, and in neither of them.
bool tunnels(const viz::Vec3& p, const viz::Vec3& velocity);

/// Why the line's hit counts, or does not. (verdict.cpp)
std::string verdict_caption(const Setup&);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::rays_lesson
