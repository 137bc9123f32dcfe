// Polygons in space against what has a test of triangles: they are cut into some.

#include <fmt/format.h>

#include <algorithm>

#include <isect/bvh_pairs.h>
#include <isect/line_triangle.h>
#include <isect/orient.h>
#include <isect/ray_polygon.h>
#include <isect/sphere_triangle.h>

#include "app/query/reply.h"
#include "app/scene/in_plane.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "app/scene/triangulated.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;
using Triangles = std::vector<Triangle<double, 3>>;

Ring<double, 3> outline_in_space(const Setting& s, const Object& o) { return points_of<3>(s.rings(o).front()); }

/// Corners off one plane are told.
void tell_surface(const Setting& s, const Object& o, Answer& out) {
  if (o.type != Type::polygon) return;
  const double off = off_plane(outline_in_space(s, o));
  if (off == 0) return;
  out.result["off_plane"] = std::max(off, out.result.value("off_plane", 0.0));
  out.note += fmt::format(
      "{}The corners of {} lie up to {} off one plane: what is tested are the triangles that its outline is cut into.",
      out.note.empty() ? "" : " ", shown_name(o.name), viz::shown(off));
}
template <void (*tell)(const Setting&, const Object&, const Object&, Answer&)>
void tell_it(const Setting& s, const Object& a, const Object& b, Answer& out) {
  tell(s, a, b, out);
  tell_surface(s, a, out);
  tell_surface(s, b, out);
}

bool some_meets(const Triangles& triangles, const auto& meets) { return std::ranges::any_of(triangles, meets); }

bool meet(const Setting& s, const Triangles& triangles, const Object& b) {
  switch (b.type) {
    case Type::sphere:
      return some_meets(triangles, [ball = sphere_of<3>(s, b)](const auto& t) { return intersects(ball, t); });
    case Type::capsule:
      return some_meets(triangles, [c = capsule_in_space(s, b)](const auto& t) { return intersects(c, t); });
    case Type::triangle:
    case Type::polygon: {
      const Triangles others = surface_of(s, b);
      return some_meets(triangles, [&](const auto& t) {
        return some_meets(others, [&](const auto& other) { return intersects(t, other); });
      });
    }
    default:
      return some_meets(triangles, [faces = faces_of(s, b)](const auto& t) { return intersects(t, faces); });
  }
}

/// A convex outline all in one plane, or a triangle, as half-spaces; nothing of another outline.
std::optional<HalfSpaces> plate(const Setting& s, const Object& o) {
  if (o.type == Type::triangle) return triangle_half_spaces::detail::solid_of(triangle_of(s, o), 3, NoTrace());
  const Ring<double, 3> outline = outline_in_space(s, o);
  const Projection along = projection(outline);
  const auto seen = [&](const Vec3& v) { return Point<double, 2>(v[along.x], v[along.y]); };
  Ring<double, 2> shadow;
  for (const Vec3& v : outline) shadow.push_back(seen(v));
  const std::optional<Ring<double, 2>> convex = convex_corners(shadow);
  if (!convex) return {};
  Ring<double, 3> corners;
  for (const Point<double, 2>& c : *convex) corners.push_back(*std::ranges::find(outline, c, seen));
  const auto at = [&](std::size_t i) { return corners[i % corners.size()]; };
  if (!std::ranges::all_of(outline, [&](const Vec3& v) { return orient3d(at(0), at(1), at(2), v) == 0; })) return {};
  using half_spaces::Behind, half_spaces::Beside;
  HalfSpaces result = {{{Behind{at(0), at(1), at(2)}}, {Behind{at(0), at(1), at(2)}, true}}};
  for (std::size_t i = 0; i < corners.size(); ++i) result.faces.push_back({Beside{at(i), at(i + 1), at(i + 2)}});
  return result;
}

/// A convex solid that has a volume: the surface reaches into it iff one of its triangles does.
Relation to_solid(const Triangles& triangles, const HalfSpaces& solid) {
  const auto in_solid = [&](const Triangle<double, 3>& t) {
    return std::ranges::all_of(t.vertices, [&](const Vec3& v) { return locate(v, solid) != Location::out; });
  };
  if (std::ranges::all_of(triangles, in_solid)) return Relation::a_inside_b;
  int most = -1;
  for (const Triangle<double, 3>& t : triangles)
    most = std::max(most, triangle_half_spaces::detail::common(t, solid.faces, NoTrace()));
  return most > 0 ? Relation::overlapping : most == 0 ? Relation::touching : Relation::disjoint;
}

/// How they lie, where the exact test is at hand; else whether they meet.
Json polygon_result(const Setting& s, const Object& a, const Object& b) {
  const Triangles triangles = surface_of(s, a);
  const bool round = b.type == Type::sphere || b.type == Type::capsule;
  if (round && capsule_in_space(s, b).radius > 0) return as_relation(relate_surface(triangles, capsule_in_space(s, b)));

  const std::optional<HalfSpaces> flat = plate(s, a);
  std::optional<HalfSpaces> other;
  if (round) {
    const Capsule<double, 3> segment = capsule_in_space(s, b);
    other = half_spaces_of(Segment<double, 3>{segment.p, segment.q});
  } else if (b.type == Type::triangle || b.type == Type::polygon) {
    if (b.type == Type::polygon) static_cast<void>(surface_of(s, b));  // refuses one without an area
    other = plate(s, b);
  } else {
    other = faces_of(s, b);
  }
  if (other && flat) return as_relation(relate(*flat, *other));
  if (other && half_spaces::detail::has_interior(other->faces, NoTrace()))
    return as_relation(to_solid(triangles, *other));
  return {{"meet", meet(s, triangles, b)}};
}

/// How many triangles of the mesh have a point in the polygon.
Json mesh_and_polygon(const Setting& s, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(a);
  const Triangles triangles = surface_of(s, b);
  std::vector<Aabb<double, 3>> around;
  for (const Triangle<double, 3>& t : triangles)
    around.push_back({t.vertices[0].cwiseMin(t.vertices[1]).cwiseMin(t.vertices[2]),
                      t.vertices[0].cwiseMax(t.vertices[1]).cwiseMax(t.vertices[2])});
  const std::vector<Aabb<double, 3>> around_mesh = boxes(mesh);
  std::vector<char> met(mesh.triangles.size(), 0);
  for (const auto& [i, j] : overlapping_pairs(build_bvh(around_mesh), around_mesh, build_bvh(around), around))
    if (!met[static_cast<std::size_t>(i)])
      met[static_cast<std::size_t>(i)] = intersects(triangle(mesh, i), triangles[static_cast<std::size_t>(j)]);
  return {{"triangles_met", std::ranges::count(met, 1)}};
}

bool holds(const Triangles& triangles, const Vec3& p) {
  return some_meets(triangles, [&](const auto& t) { return intersects(Sphere<double, 3>{p, 0}, t); });
}
Json point_and_polygon(const Setting& s, const Object& a, const Object& b) {
  return {{"on", holds(surface_of(s, b), s.point(a, "at"))}};
}
Json cloud_and_polygon(const Setting& s, const Object& a, const Object& b) {
  Json result = {{"on", Json::array()}, {"out", Json::array()}};
  const Triangles triangles = surface_of(s, b);
  const std::vector<Vec3> points = s.points(a);
  for (std::size_t i = 0; i < points.size(); ++i) result[holds(triangles, points[i]) ? "on" : "out"].push_back(i);
  return result;
}

}  // namespace

std::vector<Triangle<double, 3>> surface_of(const Setting& s, const Object& o) {
  if (o.type == Type::triangle) return {triangle_of(s, o)};
  const Ring<double, 3> outline = outline_in_space(s, o);
  if (outline.size() > most_corners) throw NotDecided(fmt::format("{} has more than {} corners", o.name, most_corners));
  Triangles all = triangulated(outline);
  if (all.empty()) refuse_outline(o);
  return all;
}

bool is_bent(const Setting& s, const Object& polygon) { return off_plane(outline_in_space(s, polygon)) > 0; }

Answer along_surface(const Setting& s, const Object& a, const Object& polygon) {
  const Triangles triangles = surface_of(s, polygon);
  const auto first = [&](const auto& along) {
    std::optional<double> least;
    for (const Triangle<double, 3>& x : triangles)
      if (const std::optional<double> t = first_hit(along, x); t && (!least || *t < *least)) least = t;
    return least;
  };
  const std::optional<double> t = a.type == Type::segment ? first(segment_of(s, a)) : first(ray_in_space(s, a));
  Answer out;
  out.result = {{"hit", t.has_value()}};
  if (t) {
    out.result["t"] = query::number(*t);
    add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  }
  meets(a, polygon, out, t.has_value());
  tell_surface(s, polygon, out);
  return out;
}

Relation relate_surface(const std::vector<Triangle<double, 3>>& triangles, const Capsule<double, 3>& round) {
  bool inside = true, touch = false, overlap = false;
  for (const Triangle<double, 3>& t : triangles) {
    const Relation r = relate(round, t);
    inside &= r == Relation::b_inside_a, touch |= r == Relation::touching;
    overlap |= r == Relation::b_inside_a || r == Relation::overlapping;
  }
  return inside    ? Relation::a_inside_b
         : overlap ? Relation::overlapping
         : touch   ? Relation::touching
                   : Relation::disjoint;
}

std::vector<Pair> pairs_of_polygons() {
  using enum Type;
  const auto in = Pair::In::space;
  std::vector<Pair> table = {{point, polygon, nullptr, in, point_and_polygon, tell_it<tell_on>},
                             {cloud, polygon, nullptr, in, cloud_and_polygon, tell_it<tell_cloud_on>},
                             {mesh, polygon, nullptr, in, mesh_and_polygon, tell_it<tell_mesh>}};
  for (const Type other : {sphere, box, obb, capsule, triangle, polygon, kdop, hull, frustum})
    table.push_back({polygon, other, nullptr, in, polygon_result, tell_it<relate>});
  return table;
}

}  // namespace isect::program::scene
