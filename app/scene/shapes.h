#pragma once
// The objects of a scene as the core's shapes.

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include <isect/any_shape.h>
#include <isect/described.h>
#include <isect/many/bvh.h>

#include "app/scene/objects.h"
#include "viz/solids.h"

namespace isect::program::scene {

/// Returns the first N coordinates.
template <int N>
Point<double, N> point_of(const viz::Vec3& p) {
  return p.head<N>();
}
template <int N>
std::vector<Point<double, N>> points_of(const std::vector<viz::Vec3>& points) {
  std::vector<Point<double, N>> all;
  all.reserve(points.size());
  for (const viz::Vec3& p : points) all.push_back(point_of<N>(p));
  return all;
}
std::vector<viz::Vec3> in_space(const std::vector<Point<double, 2>>&);

/// Returns the shape whose fields the object has (isect/described.h).
template <class X>
X made(const NamedValues& s, const Object& o) {
  X x = {};
  if constexpr (requires { x.axes; }) x.axes.setIdentity();  // in the plane there is no w
  each_field(x, [&](const auto& field, auto&& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if (!s.has(o, field.name)) return;
    if constexpr (std::is_floating_point_v<T>)
      value = s.number(o, field.name);
    else
      value = s.point(o, field.name).template head<T::RowsAtCompileTime>();
  });
  return x;
}
template <int N>
Kdop<double, N> kdop_of(const NamedValues& s, const Object& o) {
  Kdop<double, N> kdop;
  for (std::size_t i = 0; i < o.fixed.normals.size(); ++i) {
    const std::string slab = std::to_string(i + 1);
    kdop.normals.push_back(point_of<N>(o.fixed.normals[i]));
    kdop.slabs.push_back({s.number(o, "lo" + slab), s.number(o, "hi" + slab)});
  }
  return kdop;
}
/// Returns a frustum of rounded planes: statements about it are exact for these.
Frustum<double> frustum_of(const NamedValues&, const Object&);
Hull3<double> hull_of(const NamedValues&, const Object&);
TriangleMesh<double> mesh_of(const NamedValues&, const Object&);
Triangle<double, 3> triangle_of(const NamedValues&, const Object&);
/// Returns a capsule; a ball is one whose ends coincide.
Capsule<double, 3> capsule_in_space(const NamedValues&, const Object&);
/// Returns the faces of a box, an OBB, a k-DOP, a frustum, or a hull. Throws viz::BadInput for a hull without volume,
/// in the plane without area.
HalfSpaces faces_of(const NamedValues&, const Object&);

/// Returns a k-DOP or a hull in space. Throws viz::BadInput if it has no volume to be drawn.
viz::Solid solid_of(const NamedValues&, const Object&);
/// Returns it in the plane: its corners, counter-clockwise.
std::vector<viz::Vec3> outline_of(const NamedValues&, const Object&);

/// Returns a ray or a line, or a segment as a ray: none if the difference of its ends is no vector of floating-point
/// numbers, as the ray would be another segment.
std::optional<Ray<double, 3>> ray_in_space(const NamedValues&, const Object&);

/// An object as shapes of the core, each made when it is first needed, and then kept.
class Shaped {
 public:
  Shaped(const NamedValues& s, const Object& o) : numbers(s), object(o) {}

  NamedValues numbers;
  const Object& object;
  Type type() const { return object.type; }
  bool flat() const { return numbers.flat; }

  /// Returns the shape in N dimensions. k-DOPs, frusta and hulls are half-spaces, segments have both ends as given.
  /// Objects made of several outlines or of points have no such shape.
  template <int N>
  const AnyShape<double, N>& shape() const;
  template <template <class, int> class X, int N>
  const X<double, N>& as() const {
    return std::get<X<double, N>>(shape<N>());
  }

  /// See faces_of.
  const HalfSpaces& faces() const;
  const Hull3<double>& hull() const;
  /// Returns a triangle, a polygon, a box or a hull in the plane; a segment as a ring without inside.
  const Polygon<double, 2>& outline() const;
  /// Returns a triangle or a polygon in space: its first outline.
  const Ring<double, 3>& ring() const;
  /// Throws NotDecided if the outline of a polygon in space has no area, crosses or touches itself, or has too many
  /// corners.
  const TriangulatedPolygon<double>& polygon() const;
  /// Returns how far the corners of a polygon in space lie off one plane (isect/polygon_triangles.h); 0 for a triangle.
  double off_plane() const;
  const std::optional<Ray<double, 3>>& ray() const;
  const std::vector<viz::Vec3>& points() const;

  struct Mesh {
    TriangleMesh<double> mesh;
    std::vector<Aabb<double, 3>> boxes;
    Bvh<double, 3> hierarchy;
    bool closed;
  };
  const Mesh& mesh() const;

 private:
  struct Made;
  template <class X, class Make>
  const X& kept(std::optional<X> Made::*, const Make&) const;

  mutable std::shared_ptr<Made> made_;
};
template <>
const AnyShape<double, 2>& Shaped::shape<2>() const;
template <>
const AnyShape<double, 3>& Shaped::shape<3>() const;

}  // namespace isect::program::scene
