#pragma once
// The core's convex shapes as solids of a scene.

#include <isect/shapes.h>
#include "viz/scene.h"

namespace isect {
template <class S>
struct Hull3;  // isect/convex_hull_3d.h
template <class S, int N>
struct Polytope;  // isect/kdop_polytope.h
}  // namespace isect

namespace isect::viz {

/// The box whose corner number i is corners[i], bit k of i telling on which side of axis k it lies.
Solid hexahedron(const std::array<Vec3, 8>& corners, Role);

Solid solid(const Aabb<double, 3>&, Role);
Solid solid(const Obb<double, 3>&, Role);
Solid solid(const Polytope<double, 3>&, Role);
Solid solid(const Kdop<double, 3>&, Role);  ///< without vertices when it is empty
Solid solid(const Hull3<double>&,
            Role);  ///< faces of one plane stay triangles; no edge is drawn between them
/// Its corners are those of three planes each. Assumes that opposite planes are not parallel to the ones beside them.
Solid solid(const Frustum<double>&, Role);

/// With so many sides that it looks round.
Solid solid(const Cylinder<double>&, Role);
Solid solid(const Cone<double>&, Role);

/// The box's faces as the core numbers its axes: what the plane x_axis = coordinate cuts out of the box.
Region face(const Aabb<double, 3>&, int axis, double coordinate, Role);

}  // namespace isect::viz
