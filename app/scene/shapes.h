#pragma once
// The objects of a scene as the core's shapes.

#include <isect/convex_hull_3d.h>
#include <isect/half_spaces.h>
#include <isect/shapes.h>
#include <isect/triangle_mesh.h>

#include "app/scene/objects.h"
#include "viz/solids.h"

namespace isect::program::scene {

/// The first N coordinates.
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

template <int N>
Aabb<double, N> box_of(const Setting& s, const Object& o) {
  return {point_of<N>(s.point(o, "lo")), point_of<N>(s.point(o, "hi"))};
}
template <int N>
Sphere<double, N> sphere_of(const Setting& s, const Object& o) {
  return {point_of<N>(s.point(o, "center")), s.number(o, "radius")};
}
template <int N>
Obb<double, N> obb_of(const Setting& s, const Object& o) {
  Obb<double, N> box;
  box.center = point_of<N>(s.point(o, "center")), box.half = point_of<N>(s.point(o, "half"));
  const char* const axes[] = {"u", "v", "w"};
  for (int i = 0; i < N; ++i)  // in the plane there is no w
    box.axes.col(i) = point_of<N>(s.has(o, axes[i]) ? s.point(o, axes[i]) : viz::Vec3::UnitZ());
  return box;
}
template <int N>
Kdop<double, N> kdop_of(const Setting& s, const Object& o) {
  Kdop<double, N> kdop;
  for (std::size_t i = 0; i < o.fixed.normals.size(); ++i) {
    const std::string slab = std::to_string(i + 1);
    kdop.normals.push_back(point_of<N>(o.fixed.normals[i]));
    kdop.slabs.push_back({s.number(o, "lo" + slab), s.number(o, "hi" + slab)});
  }
  return kdop;
}
/// Its planes as rounded: what is said of it is true of these.
Frustum<double> frustum_of(const Setting&, const Object&);
Hull3<double> hull_of(const Setting&, const Object&);
TriangleMesh<double> mesh_of(const Object&);
Triangle<double, 3> triangle_of(const Setting&, const Object&);
/// A ball is a capsule whose ends coincide.
Capsule<double, 3> capsule_in_space(const Setting&, const Object&);
/// A box, an OBB, a k-DOP, a frustum, or a hull, which throws viz::BadInput where it has no volume, in the plane no
/// area.
HalfSpaces faces_of(const Setting&, const Object&);

/// A k-DOP or a hull in space. Throws viz::BadInput where it has no volume to be drawn.
viz::Solid solid_of(const Setting&, const Object&);
/// The same in the plane: its corners, counter-clockwise.
std::vector<viz::Vec3> outline_of(const Setting&, const Object&);

}  // namespace isect::program::scene
