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

/// Returns the box with corners[i] as corner i; bit k of i says on which side of axis k it lies.
Solid hexahedron(const std::array<Vec3, 8>& corners, Role);

Solid solid(const Aabb<double, 3>&, Role);
Solid solid(const Obb<double, 3>&, Role);
Solid solid(const Polytope<double, 3>&, Role);
Solid solid(const Kdop<double, 3>&, Role);  ///< without vertices when it is empty
Solid solid(const Hull3<double>&,
            Role);  ///< coplanar faces stay triangles; no edge is drawn between them
/// Each corner is the intersection of three planes. Assumes that opposite planes are not parallel to those beside them.
Solid solid(const Frustum<double>&, Role);

/// Returns a solid with so many sides that it looks round.
Solid solid(const Cylinder<double>&, Role);
Solid solid(const Cone<double>&, Role);

/// Returns a face of the box, with axes numbered as in the core: the part of the plane x_axis = coordinate in the box.
Region face(const Aabb<double, 3>&, int axis, double coordinate, Role);

}  // namespace isect::viz
