#pragma once
// The solid that a closed mesh bounds, against a convex body: a ball, a capsule, a cylinder, a cone, a box, an oriented
// box, a hull, or any half-spaces.
//
// Where no triangle has a point inside the convex body, the body's inside lies wholly in the solid or wholly out of it,
// and any point of it tells which. Where one has, the solid's inside and the body's meet, and the body does not lie in
// the solid. The solid lies in the body where all corners of its triangles do. Source: as in isect/point_mesh.h.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#include <isect/mesh_mesh.h>
#include <isect/parts/inner_point.h>
#include <isect/point_aabb.h>
#include <isect/point_capsule.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/point_mesh.h>
#include <isect/point_obb.h>
#include <isect/point_sphere.h>
#include <isect/sphere_triangle.h>
#include <isect/triangle_aabb.h>

namespace isect {

namespace mesh_convex::detail {

using mesh_surface::Corners;
using mesh_surface::Point3;
using mesh_surface::Surface;

/// How the solid (A) lies to a body (B) that has a volume. `reach` of a triangle is -1 where it has a point inside the
/// body, 0 where it touches it, else 1; `in` tells where a point lies; `inner_in` where a place inside the body lies to
/// a surface that has no point there.
template <class S, class Reach, class In, class InnerIn>
Relation relation(const TriangleMesh<S>& mesh, const Reach& reach, const In& in, const InnerIn& inner_in) {
  const Surface surface(mesh);
  int least = 1;
  for (std::size_t i = 0; i < surface.triangles.size() && least >= 0; ++i)
    least = std::min(least, reach(surface.triangles[i]));
  const bool holds = least >= 0 && inner_in(surface) == Location::in;
  const bool held = std::ranges::all_of(surface.triangles, [&](const Corners& x) {
    return std::ranges::all_of(x.vertices, [&](const Point3& v) { return in(v) != Location::out; });
  });
  if (held) return holds ? Relation::equal : Relation::a_inside_b;
  if (holds) return Relation::b_inside_a;
  return least < 0 ? Relation::overlapping : least == 0 ? Relation::touching : Relation::disjoint;
}
template <class S, class InnerIn>
Relation relation(const TriangleMesh<S>& mesh, const HalfSpaces& body, const InnerIn& inner_in) {
  return relation(
      mesh, [&](const Corners& x) { return -triangle_half_spaces::detail::common(x, body.faces, NoTrace()); },
      [&](const Point3& p) { return isect::locate(p, body); }, inner_in);
}
/// Returns a function that tells where the mean of some points, which must outlive it, lies to a surface.
inline auto mean_in(std::span<const Point3> points) {
  return [points](const Surface& surface) { return mesh_surface::locate(mesh_surface::Mean{points}, surface); };
}
/// Relates the solid (A) to a cylinder or a cone.
template <class S, class Solid>
Relation round_relation(const TriangleMesh<S>& mesh, const Solid& solid) {
  const auto reach = [&](const Corners& x) {
    return round_half_spaces::detail::meeting(solid, triangle_half_spaces::detail::solid_of(x, 3, NoTrace()),
                                              NoTrace());
  };
  const std::array<round_solid::Disc, 2> discs = round_solid::discs(solid);
  const std::array<Point3, 2> ends = {discs[0].center, discs[1].center};
  return relation(
      mesh, reach, [&](const Point3& p) { return locate(p, solid); }, mean_in(ends));
}

}  // namespace mesh_convex::detail

// Whether a body has a volume; what is empty, NaN or infinite has none.

template <class S>
bool has_volume(const Sphere<S, 3>& ball) {
  return finite(ball) && ball.radius > 0;
}
template <class S>
bool has_volume(const Capsule<S, 3>& capsule) {
  return finite(capsule) && capsule.radius > 0;
}
template <class S>
bool has_volume(const Aabb<S, 3>& box) {
  return finite(box) && (box.lo.array() < box.hi.array()).all();
}
template <class S>
bool has_volume(const Obb<S, 3>& box) {
  return half_spaces::detail::has_interior(half_spaces_of(box).faces, NoTrace());
}
template <class S>
bool has_volume(const Hull3<S>& hull) {
  return hull.dimension == 3;
}
template <class S>
bool has_volume(const Cylinder<S>& cylinder) {
  return round_solid::exists(cylinder) && cylinder.radius > 0;
}
template <class S>
bool has_volume(const Cone<S>& cone) {
  return round_solid::exists(cone) && cone.radius > 0;
}
inline bool has_volume(const HalfSpaces& solid) { return half_spaces::detail::has_interior(solid.faces, NoTrace()); }

// How a solid (A) that a mesh bounds (see bounds_solid) lies to a convex body (B). Exact. The body has a volume, or is
// a ball of radius 0; any other without one, or an empty mesh: disjoint.

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Sphere<S, 3>& sphere) {
  if (mesh.triangles.empty() || !finite(sphere) || !(sphere.radius >= 0)) return Relation::disjoint;
  if (sphere.radius == 0)
    return locate(sphere.center, mesh) == Location::out ? Relation::disjoint : Relation::b_inside_a;
  const Sphere<double, 3> ball = cast<double>(sphere);
  const auto reach = [&](const mesh_surface::Corners& x) {
    return sphere_triangle::detail::compare(ball.center, ball.radius, x, NoTrace());
  };
  return mesh_convex::detail::relation(
      mesh, reach, [&](const Point<double, 3>& p) { return locate(p, ball); },
      mesh_convex::detail::mean_in({&ball.center, 1}));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Capsule<S, 3>& capsule) {
  if (mesh.triangles.empty() || !has_volume(capsule)) return Relation::disjoint;
  const Capsule<double, 3> wide = cast<double>(capsule);
  const auto reach = [&](const mesh_surface::Corners& x) {
    return sphere_triangle::detail::compare(wide, x, NoTrace());
  };
  return mesh_convex::detail::relation(
      mesh, reach, [&](const Point<double, 3>& p) { return locate(p, wide); },
      mesh_convex::detail::mean_in({&wide.p, 1}));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Aabb<S, 3>& box) {
  if (mesh.triangles.empty() || !has_volume(box)) return Relation::disjoint;
  const Aabb<double, 3> wide = cast<double>(box);
  const auto reach = [&](const mesh_surface::Corners& x) { return triangle_aabb::detail::outer(x, wide, NoTrace()); };
  const std::array<Point<double, 3>, 2> ends = {wide.lo, wide.hi};
  return mesh_convex::detail::relation(
      mesh, reach, [&](const Point<double, 3>& p) { return locate(p, wide); }, mesh_convex::detail::mean_in(ends));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Obb<S, 3>& box) {
  if (mesh.triangles.empty() || !has_volume(box)) return Relation::disjoint;
  const Point<double, 3> center = box.center.template cast<double>();
  return mesh_convex::detail::relation(mesh, half_spaces_of(box), mesh_convex::detail::mean_in({&center, 1}));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Hull3<S>& hull) {
  if (mesh.triangles.empty() || !has_volume(hull)) return Relation::disjoint;
  std::vector<Point<double, 3>> inner;
  for (const Point<S, 3>& v : hull.vertices) inner.push_back(v.template cast<double>());
  return mesh_convex::detail::relation(mesh, half_spaces_of(hull), mesh_convex::detail::mean_in(inner));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Cylinder<S>& cylinder) {
  if (mesh.triangles.empty() || !has_volume(cylinder)) return Relation::disjoint;
  return mesh_convex::detail::round_relation(mesh, cast<double>(cylinder));
}

template <class S>
Relation relate(const TriangleMesh<S>& mesh, const Cone<S>& cone) {
  if (mesh.triangles.empty() || !has_volume(cone)) return Relation::disjoint;
  return mesh_convex::detail::round_relation(mesh, cast<double>(cone));
}

/// The half-spaces may be unbounded: then no solid of a mesh holds them.
template <class S>
Relation relate(const TriangleMesh<S>& mesh, const HalfSpaces& solid) {
  if (mesh.triangles.empty() || !has_volume(solid)) return Relation::disjoint;
  const std::optional<InnerPoint> inner = inner_point(solid);  // without corners that span it, it is unbounded
  return mesh_convex::detail::relation(mesh, solid, [&](const mesh_surface::Surface& surface) {
    return inner ? mesh_surface::locate(*inner, surface) : Location::out;
  });
}

}  // namespace isect
