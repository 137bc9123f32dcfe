// k-DOPs, frusta, hulls, meshes and clouds of points against others.

#include <fmt/format.h>

#include <functional>
#include <memory>

#include <isect/aabb_frustum.h>
#include <isect/bvh_ray.h>
#include <isect/half_spaces.h>
#include <isect/kdop_kdop.h>
#include <isect/line_triangle.h>
#include <isect/point_aabb.h>
#include <isect/point_capsule.h>
#include <isect/point_kdop.h>
#include <isect/point_mesh.h>
#include <isect/point_obb.h>
#include <isect/point_polygon.h>
#include <isect/point_sphere.h>
#include <isect/sphere_frustum.h>
#include <isect/triangle_aabb.h>

#include "app/query/reply.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Vec3;
using viz::Verdict;

// Where points lie.

Polygon<double, 2> polygon_of(const std::vector<std::vector<Vec3>>& rings) {
  Polygon<double, 2> polygon;
  for (const auto& ring : rings) polygon.rings.push_back(points_of<2>(ring));
  return polygon;
}

using Locator = std::function<Location(const Vec3&)>;

template <int N>
Locator locator(const Setting& s, const Object& o) {
  const auto of = [](const auto& shape) {
    return Locator([shape](const Vec3& p) { return isect::locate(point_of<N>(p), shape); });
  };
  switch (o.type) {
    case Type::box:
      return of(box_of<N>(s, o));
    case Type::sphere:
      return of(sphere_of<N>(s, o));
    case Type::obb:
      return of(obb_of<N>(s, o));
    case Type::kdop:
      return of(kdop_of<N>(s, o));
    case Type::capsule:
      return of(Capsule<double, N>{point_of<N>(s.point(o, "p")), point_of<N>(s.point(o, "q")), s.number(o, "r")});
    case Type::frustum:
      return [solid = half_spaces_of(frustum_of(s, o))](const Vec3& p) { return isect::locate(p, solid); };
    case Type::mesh:
      if (!point_mesh::closed(mesh_of(o))) throw NotDecided(o.name + " is not closed, so that nothing is inside");
      return [mesh = mesh_of(o)](const Vec3& p) { return isect::locate(p, mesh); };
    case Type::hull:
      if constexpr (N == 3) {
        static_cast<void>(solid_of(s, o));  // refuses one without a volume
        return [solid = half_spaces_of(hull_of(s, o))](const Vec3& p) { return isect::locate(p, solid); };
      } else {
        return of(Polygon<double, 2>{{points_of<2>(outline_of(s, o))}});
      }
    default:
      if constexpr (N == 2) return of(polygon_of(s.rings(o)));
      throw std::logic_error("no points lie in such an object");
  }
}

Locator located_in(const Setting& s, const Object& o) { return s.flat ? locator<2>(s, o) : locator<3>(s, o); }

const char* word(Location where) { return where == Location::in ? "in" : where == Location::on ? "on" : "out"; }

Json point_result(const Setting& s, const Object& a, const Object& b) {
  return {{"location", word(located_in(s, b)(s.point(a, "at")))}};
}
void tell_point(const Setting&, const Object& a, const Object& b, Answer& out) {
  locate(a, b, out, out.result["location"]);
}

Json cloud_result(const Setting& s, const Object& a, const Object& b) {
  std::array<std::vector<int>, 3> lists;
  const Locator where = located_in(s, b);
  const std::vector<Vec3> points = s.points(a);
  for (std::size_t i = 0; i < points.size(); ++i)
    lists[static_cast<std::size_t>(where(points[i]))].push_back(static_cast<int>(i));
  Json result;
  for (const Location l : {Location::in, Location::on, Location::out}) {
    const std::vector<int>& list = lists[static_cast<std::size_t>(l)];
    result[word(l)] = list;
  }
  return result;
}

/// The points by their places: filled inside, diamonds on the boundary, rings outside.
void tell_cloud(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::vector<Vec3> points = s.points(a);
  const auto mark = [&](const char* where, viz::Mark kind, Role role) {
    for (const int i : out.result[where])
      out.marks.push_back(viz::Dot{points[static_cast<std::size_t>(i)], kind, role});
  };
  mark("out", viz::Mark::ring, Role::miss);
  mark("in", viz::Mark::disc, Role::hit);
  mark("on", viz::Mark::diamond, Role::hit);
  const std::size_t in = out.result["in"].size(), on = out.result["on"].size();
  out.verdict = {in > 0   ? Verdict::Kind::yes
                 : on > 0 ? Verdict::Kind::on
                          : Verdict::Kind::no,
                 fmt::format("{} of {} points of {} {} inside {}", in, points.size(), shown_name(a.name),
                             in == 1 ? "lies" : "lie", shown_name(b.name))};
  if (on > 0) out.verdict.text += fmt::format(", {} on its boundary", on);
  out.values = {{"inside", static_cast<double>(in), "points", Role::hit, true},
                {"on the boundary", static_cast<double>(on), "points", Role::hit, true},
                {"outside", static_cast<double>(out.result["out"].size()), "points", Role::miss, true}};
}

/// Those that lie on what has no inside, or are points of another cloud.
Json cloud_on_result(const Setting& s, const Object& a, const Object& b) {
  Json result = {{"on", Json::array()}, {"out", Json::array()}};
  const std::vector<Vec3> points = s.points(a);
  for (std::size_t i = 0; i < points.size(); ++i) result[lies_on(s, points[i], b) ? "on" : "out"].push_back(i);
  return result;
}

// What a ray meets first of many triangles.

Json ray_and_mesh(const Setting& s, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(b);
  const Ray<double, 3> ray = ray_in_space(s, a);
  const auto hit = closest_hit(build_bvh(boxes(mesh)), ray, [&](int i) { return first_hit(ray, triangle(mesh, i)); });
  if (!hit) return {{"hit", false}};
  return {{"hit", true}, {"t", query::number(hit->t)}, {"triangle", hit->primitive}};
}
void tell_ray(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const bool hit = out.result["hit"] == true;
  if (hit) add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  meets(a, b, out, hit);
  if (!hit)  // it may lie within
    out.verdict.text = fmt::format("{} meets no triangle of {}", shown_name(a.name), shown_name(b.name));
}

// Frusta and k-DOPs.

Json culled(Culling culling) {
  return {{"culling", culling == Culling::inside ? "inside" : culling == Culling::outside ? "outside" : "crossing"}};
}
/// The triangles that have a point in the box; a box within the mesh has none.
Json mesh_and_box(const Setting& s, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(a);
  const Aabb<double, 3> box = box_of<3>(s, b);
  int met = 0;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) met += intersects(triangle(mesh, i), box);
  return {{"triangles_met", met}};
}
/// What six planes tell, as a renderer asks, and how they lie.
Json frustum_and_box(const Setting& s, const Object& a, const Object& b) {
  Json result = relation_of_solids(s, a, b);
  result.update(culled(cull(box_of<3>(s, b), frustum_of(s, a))));
  return result;
}
Json frustum_and_sphere(const Setting& s, const Object& a, const Object& b) {
  Json result = relation_of_solids(s, a, b);
  result.update(culled(cull(sphere_of<3>(s, b), frustum_of(s, a))));
  return result;
}
/// Only "outside" and "inside" are certain: see isect/aabb_frustum.h.
void tell_culling(const Setting& s, const Object& a, const Object& b, Answer& out) {
  relate(s, a, b, out);
  if (out.result["relation"] == "disjoint" && out.result["culling"] == "crossing")
    out.note = fmt::format("No single plane of {} has {} beyond it, so the test by planes would draw it.",
                           shown_name(a.name), shown_name(b.name));
}

/// How they lie; and what their slabs tell, where these are the same.
Json two_kdops(const Setting& s, const Object& a, const Object& b) {
  Json result = relation_of_solids(s, a, b);
  if (a.fixed.normals == b.fixed.normals)
    result["slabs"] = may_intersect(kdop_of<3>(s, a), kdop_of<3>(s, b)) ? "overlap" : "disjoint";
  return result;
}
void tell_kdops(const Setting& s, const Object& a, const Object& b, Answer& out) {
  relate(s, a, b, out);
  if (out.result["relation"] == "disjoint" && out.result.value("slabs", "") == "overlap")
    out.note = fmt::format("{} and {} overlap on every slab, so the test by slabs would not tell.", shown_name(a.name),
                           shown_name(b.name));
}

}  // namespace

void tell_cloud_on(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::vector<Vec3> points = s.points(a);
  for (const auto& [where, kind, role] :
       {std::tuple{"out", viz::Mark::ring, Role::miss}, {"on", viz::Mark::diamond, Role::hit}})
    for (const std::size_t i : out.result[where]) out.marks.push_back(viz::Dot{points[i], kind, role});
  const std::size_t on = out.result["on"].size();
  const bool one = on == 1;
  const std::string place = b.type == Type::point   ? one ? "is" : "are"
                            : b.type == Type::cloud ? one ? "is also in" : "are also in"
                            : one                   ? "lies on"
                                                    : "lie on";
  out.verdict = {
      on > 0 ? Verdict::Kind::on : Verdict::Kind::no,
      fmt::format("{} of {} points of {} {} {}", on, points.size(), shown_name(a.name), place, shown_name(b.name))};
  out.values = {{"on it", static_cast<double>(on), "points", Role::hit, true},
                {"beside it", static_cast<double>(out.result["out"].size()), "points", Role::miss, true}};
}

std::vector<Pair> pairs_of_many_numbers() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table = {{kdop, kdop, nullptr, In::both, two_kdops, tell_kdops},
                             {frustum, box, nullptr, In::space, frustum_and_box, tell_culling},
                             {frustum, sphere, nullptr, In::space, frustum_and_sphere, tell_culling}};
  table.push_back({mesh, box, nullptr, In::space, mesh_and_box, tell_mesh});
  for (const Type shape : {kdop, hull, capsule, frustum})
    table.push_back({point, shape, nullptr, shape == frustum ? In::space : In::both, point_result, tell_point});
  for (const Type shape : {frustum, mesh})
    table.push_back({cloud, shape, nullptr, In::space, cloud_result, tell_cloud});
  for (const Type shape : {box, sphere, obb, kdop, hull, capsule})
    table.push_back({cloud, shape, nullptr, In::both, cloud_result, tell_cloud});
  for (const Type shape : {triangle, polygon})
    table.push_back({cloud, shape, nullptr, In::plane, cloud_result, tell_cloud});
  for (const Type thin : {point, ray, line, segment, cloud})
    table.push_back({cloud, thin, nullptr, In::both, cloud_on_result, tell_cloud_on});
  table.push_back({cloud, triangle, nullptr, In::space, cloud_on_result, tell_cloud_on});
  for (const Type along : {ray, line, segment}) {
    table.push_back({along, mesh, nullptr, In::space, ray_and_mesh, tell_ray});
  }
  return table;
}

}  // namespace isect::program::scene
