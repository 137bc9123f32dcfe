#pragma once
// A shape whose type is known only when the program runs. isect/ask.h asks any two of them.

#include <type_traits>
#include <variant>

#include <isect/convex_hull_3d.h>
#include <isect/half_spaces.h>
#include <isect/polygon_triangles.h>
#include <isect/shapes.h>
#include <isect/triangle_mesh.h>

namespace isect {

namespace any_shape {

template <class S, int N, class... More>
using Variant = std::variant<Point<S, N>, Segment<S, N>, Ray<S, N>, Plane<S, N>, Sphere<S, N>, Capsule<S, N>,
                             Aabb<S, N>, Obb<S, N>, Kdop<S, N>, Triangle<S, N>, HalfSpaces, More...>;

}  // namespace any_shape

/// Any shape in the plane (N = 2) or in space. Half-spaces are any other convex solid, of dimension N; a hull has a
/// volume, and a mesh valid indices.
template <class S, int N>
using AnyShape = std::conditional_t<
    N == 2, any_shape::Variant<S, N, Polygon<S, 2>>,
    any_shape::Variant<S, N, Frustum<S>, Hull3<S>, TriangleMesh<S>, TriangulatedPolygon<S>, Cylinder<S>, Cone<S>>>;

}  // namespace isect
