#pragma once
// The view volume, what stands in and around it, and how a volume is drawn when its answer is known.

#include <isect/aabb_frustum.h>
#include <isect/sphere_frustum.h>
#include "viz/lesson.h"

namespace isect::lessons::culling_lesson {

using Box = Aabb<double, 3>;
using Ball = Sphere<double, 3>;
using Volume = std::variant<Box, Ball>;

viz::Walk one_volume(const Frustum<double>&, const viz::Vec3& eye, const Volume& asked);
viz::Walk whole_scene(const Frustum<double>&, const viz::Vec3& eye);
viz::Walk hierarchy(const Frustum<double>&, const viz::Vec3& eye);

const viz::CaseMap& cases();  ///< of one box
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

/// The eye looks along +x. All planes have small dyadic coordinates, so that touching is exact.
Frustum<double> frustum(const viz::Vec3& eye);
/// left, right, bottom, top, near, far
extern const char* const plane_names[6];

/// The inner side of a plane: "3 *x* + 8 *z* + 12 ≥ 0".
std::string inner_side(const Plane<double, 3>&);
/// The inner sides of all six planes at once: "−2.5 ≤ *x* ≤ 3, 4 |*y*| ≤ *x* + 4 and 8 |*z*| ≤ 3 (*x* + 4)".
std::string inner_side(const viz::Vec3& eye);

/// The core's answer, and each plane that it tested on the way.
struct Answer {
  Culling culling;
  std::vector<frustum_planes::Tested> tested = {};

  /// The plane beyond which the volume lies; -1: none.
  int rejecting_plane() const { return culling == Culling::outside && !tested.empty() ? tested.back().plane : -1; }
};
Answer ask(const Volume&, const Frustum<double>&);

/// The parts of the box's faces that lie in the frustum, rounded, for a picture; none if the box contains the frustum
/// or lies outside it.
std::vector<Ring<double, 3>> faces_inside(const Box&, const Frustum<double>&);
/// Whether they have a common point, touching included. Exact for the planes as given. Finite box, not empty.
bool meet(const Box&, const Frustum<double>&);

viz::Vec3 middle(const Volume&);
const char* word(Culling);  ///< "inside"
viz::Role role_of(Culling);
viz::Mark mark_of(Culling);
void add(const Volume&, viz::Role, viz::Scene&);
/// Adds the volume with its answer's sign in the middle, and beside it the name of the plane that rejects it.
void add(const Volume&, const Answer&, viz::Scene&);
/// Adds the eye, dashed lines to the near corners, and the frustum itself.
void add_view(const Frustum<double>&, const viz::Vec3& eye, viz::Scene&);
/// Adds one plane's face with its normal.
void add_plane(const Frustum<double>&, int plane, viz::Scene&);

}  // namespace isect::lessons::culling_lesson
