// Meshes and clouds of points with other objects; frusta and k-DOPs that report more than how they lie.

#include <algorithm>

#include <isect/aabb_frustum.h>
#include <isect/kdop_kdop.h>
#include <isect/line_triangle.h>
#include <isect/many/bvh_ray.h>
#include <isect/point_mesh.h>
#include <isect/point_polygon.h>
#include <isect/sphere_frustum.h>

#include "app/query/reply.h"
#include "app/scene/pairs.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

// Where points lie.

Location place(const Vec3& p, const Shaped& o) {
  if (o.type() == Type::mesh) return isect::locate(p, o.mesh().mesh);
  if (o.type() == Type::hull && o.flat()) return isect::locate(point_of<2>(p), o.outline());
  return *by_core(p, o).location;
}
void require_inside(const Shaped& o) {
  if (o.type() == Type::mesh && !o.mesh().closed)
    throw NotDecided(viz::tr("{a} is not closed, so that nothing is inside", {{"a", o.object.name}}));
}

void point_in(const Shaped& a, const Shaped& b, Told& out) {
  const Vec3 p = a.numbers.point(a.object, "at");
  out.answer = answer(Location::on);
  if (b.type() != Type::mesh || b.mesh().closed)
    out.answer = answer(place(p, b));
  else if (!by_core(p, b).meet)
    throw NotDecided(
        viz::tr("{a} is not closed, so that nothing is inside; the point is not on it", {{"a", b.object.name}}));
  out.result = {{"location", query::name(*out.answer.location)}};
}

std::vector<Location> places(const Shaped& cloud, const auto& place_of) {
  std::vector<Location> all;
  for (const Vec3& p : cloud.points()) all.push_back(place_of(p));
  return all;
}
void cloud_in(const Shaped& a, const Shaped& b, Told& out) {
  require_inside(b);
  tell_cloud(a, b, places(a, [&](const Vec3& p) { return place(p, b); }), out);
}
void cloud_on(const Shaped& a, const Shaped& b, Told& out) {
  const auto on = [&](const Vec3& p) { return lies_on(p, b) ? Location::on : Location::out; };
  tell_cloud_on(a, b, places(a, on), out);
}

// Meshes.

/// Counts triangles with a point in the other; tells how that lies to the solid that the mesh bounds, if it bounds one.
void triangles_met(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"triangles_met", *out.answer.triangles}};
  if (out.answer.relation) out.result["relation"] = query::name(*out.answer.relation);
}

void line_and_mesh(const Shaped& a, const Shaped& b, Told& out) {
  const Shaped::Mesh& all = b.mesh();
  std::optional<BvhHit<double>> hit;
  if (const auto& ray = a.ray()) {
    hit = closest_hit(all.hierarchy, *ray, [&](int i) { return first_hit(*ray, triangle(all.mesh, i)); });
  } else {
    for (int i = 0; i < static_cast<int>(all.mesh.triangles.size()); ++i)
      if (const auto t = first_hit(a.as<Segment, 3>(), triangle(all.mesh, i)); t && (!hit || *t < hit->t))
        hit = BvhHit<double>{*t, i};
  }
  tell_first(hit ? std::optional(hit->t) : std::nullopt, out);
  if (hit) out.result["triangle"] = hit->primitive;
}

// Frusta and k-DOPs.

/// Asks the six planes, as a renderer does, and how they lie. Only "outside" and "inside" are certain: see
/// isect/aabb_frustum.h.
void frustum_and(const Shaped& a, const Shaped& b, Told& out) {
  relate(a, b, out);
  const Frustum<double> frustum = frustum_of(a.numbers, a.object);
  const Culling culling = b.type() == Type::box ? cull(b.as<Aabb, 3>(), frustum) : cull(b.as<Sphere, 3>(), frustum);
  out.result["culling"] = culling == Culling::inside ? "inside" : culling == Culling::outside ? "outside" : "crossing";
  if (!out.answer.meet && culling == Culling::crossing)
    out.note = viz::tr("No single plane of {a} has {b} beyond it, so the test by planes would draw it.",
                       {{"a", shown_name(a.object.name)}, {"b", shown_name(b.object.name)}});
}

/// Asks how they lie; and their slabs, if their normals are equal.
void two_kdops(const Shaped& a, const Shaped& b, Told& out) {
  relate(a, b, out);
  if (a.object.fixed.normals != b.object.fixed.normals) return;
  const bool overlap = may_intersect(kdop_of<3>(a.numbers, a.object), kdop_of<3>(b.numbers, b.object));
  out.result["slabs"] = overlap ? "overlap" : "disjoint";
  if (!out.answer.meet && overlap)
    out.note =
        viz::tr("{both} overlap on every slab, so the test by slabs would not tell.", {{"both", both_names(a, b)}});
}

}  // namespace

std::vector<Pair> pairs_of_sets() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table = {
      {kdop, kdop, nullptr, In::both, two_kdops},         {frustum, box, nullptr, In::space, frustum_and},
      {frustum, sphere, nullptr, In::space, frustum_and}, {mesh, mesh, nullptr, In::space, triangles_met},
      {point, mesh, nullptr, In::space, point_in},        {point, frustum, nullptr, In::space, point_in},
      {cloud, frustum, nullptr, In::space, cloud_in},     {cloud, mesh, nullptr, In::space, cloud_in},
      {cloud, triangle, nullptr, In::space, cloud_on}};
  for (const Type shape : {box, sphere, capsule, obb, kdop, frustum, hull, triangle})
    table.push_back({mesh, shape, nullptr, In::space, triangles_met});
  for (const Type shape : {kdop, hull, capsule}) table.push_back({point, shape, nullptr, In::both, point_in});
  for (const Type shape : {box, sphere, obb, kdop, hull, capsule})
    table.push_back({cloud, shape, nullptr, In::both, cloud_in});
  for (const Type shape : {cylinder, cone}) {
    table.push_back({cloud, shape, nullptr, In::space, cloud_in});
    table.push_back({mesh, shape, nullptr, In::space, triangles_met});
  }
  for (const Type shape : {triangle, polygon}) table.push_back({cloud, shape, nullptr, In::plane, cloud_in});
  for (const Type thin : {point, ray, line, segment, cloud})
    table.push_back({cloud, thin, nullptr, In::both, cloud_on});
  for (const Type along : {ray, line, segment}) table.push_back({along, mesh, nullptr, In::space, line_and_mesh});
  return table;
}

}  // namespace isect::program::scene
