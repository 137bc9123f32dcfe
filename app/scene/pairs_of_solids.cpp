// Convex solids against each other and against balls, capsules, triangles, meshes and lines; lines in space; points
// beside what is thin or has no convex form.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <isect/bvh_pairs.h>
#include <isect/capsule_half_spaces.h>
#include <isect/convex_hull.h>
#include <isect/line_line.h>
#include <isect/line_triangle.h>
#include <isect/numbers/exact.h>
#include <isect/plane_sphere.h>
#include <isect/point_mesh.h>
#include <isect/point_polygon.h>
#include <isect/ray_capsule.h>
#include <isect/ray_half_spaces.h>
#include <isect/segment_polygon.h>
#include <isect/segment_sphere.h>
#include <isect/sphere_triangle.h>

#include "app/query/reply.h"
#include "app/scene/in_plane.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Vec3;
using viz::Verdict;

bool is_round(Type t) { return t == Type::sphere || t == Type::capsule; }

Relation relate_round(const Setting& s, const Object& o, const HalfSpaces& solid) {
  if (o.type == Type::sphere) return relate(sphere_of<3>(s, o), solid);
  return relate(capsule_in_space(s, o), solid);
}

// Hulls of many facets: their triangles are asked one by one.

std::vector<Triangle<double, 3>> facets(const Hull3<double>& hull) {
  std::vector<Triangle<double, 3>> all;
  for (const auto& [a, b, c] : hull.triangles)
    all.push_back({{hull.vertices[static_cast<std::size_t>(a)], hull.vertices[static_cast<std::size_t>(b)],
                    hull.vertices[static_cast<std::size_t>(c)]}});
  return all;
}

/// A ball or capsule, which is asked of each facet; without a radius it is a segment, which is a solid.
Relation relate_to_hull(const Capsule<double, 3>& capsule, const Hull3<double>& hull, const HalfSpaces& solid) {
  if (capsule.radius == 0) return relate(capsule, solid);
  const auto end_in = [&](const Vec3& end) {
    return sphere_half_spaces::detail::contained(end, capsule.radius, solid, NoTrace());
  };
  if (end_in(capsule.p) && end_in(capsule.q)) return Relation::a_inside_b;
  return reversed(relate_surface(facets(hull), capsule));
}

Json solids_result(const Setting& s, const Object& a, const Object& b) {
  if (is_round(b.type)) return as_relation(reversed(relate_round(s, b, faces_of(s, a))));
  if (is_round(a.type))
    return as_relation(b.type == Type::hull && !s.flat
                           ? relate_to_hull(capsule_in_space(s, a), hull_of(s, b), faces_of(s, b))
                           : relate_round(s, a, faces_of(s, b)));
  if (a.type == Type::triangle) return as_relation(relate(triangle_of(s, a), faces_of(s, b)));
  return as_relation(relate(faces_of(s, a), faces_of(s, b)));
}

Json round_and_triangle(const Setting& s, const Object& a, const Object& b) {
  return as_relation(relate(capsule_in_space(s, a), triangle_of(s, b)));
}

Json two_triangles(const Setting& s, const Object& a, const Object& b) {
  const auto solid = [&](const Object& o) {
    return triangle_half_spaces::detail::solid_of(triangle_of(s, o), 3, NoTrace());
  };
  return as_relation(relate(solid(a), solid(b)));
}

// Planes.

Json plane_result(const Setting& s, const Object& a, const Object& b) {
  const Plane<double, 3> plane = {s.point(a, "normal"), s.number(a, "d")};
  if (b.type != Type::capsule) return as_relation(relate(plane, faces_of(s, b)));
  const Capsule<double, 3> capsule = capsule_in_space(s, b);
  std::array<int, 2> signs = {};  // of the ends, 0 where the ball there meets the plane; and whether one is cut
  bool cut = false, touch = false;
  for (int i = 0; i < 2; ++i) {
    const Vec3 end = i == 0 ? capsule.p : capsule.q;
    const Relation r = relate(plane, Sphere<double, 3>{end, capsule.radius});
    cut |= r == Relation::overlapping, touch |= r != Relation::disjoint;
    signs[static_cast<std::size_t>(i)] =
        sign_of([&]<class W>() -> W { return dot(exactly<W>(plane.normal), exactly<W>(end)) + W(plane.d); });
  }
  cut |= signs[0] * signs[1] < 0;
  return as_relation(cut ? Relation::overlapping : touch ? Relation::touching : Relation::disjoint);
}
void tell_plane(const Setting& s, const Object& a, const Object& b, Answer& out) {
  relate(s, a, b, out);
  if (out.verdict.kind == Verdict::Kind::yes)
    out.verdict.text = fmt::format("{} cuts {}", shown_name(a.name), shown_name(b.name));
}

Json two_planes(const Setting& s, const Object& a, const Object& b) {
  const Vec3 m = s.point(a, "normal"), n = s.point(b, "normal");
  const double d = s.number(a, "d"), e = s.number(b, "d");
  const auto vanish = [](const auto& text) {
    for (std::size_t i = 0; i < 3; ++i)
      if (sign_of([&]<class W>() -> W { return text.template operator()<W>()[i]; }) != 0) return false;
    return true;
  };
  if (!vanish([&]<class W>() -> Components<W, 3> { return cross(exactly<W>(m), exactly<W>(n)); }))
    return {{"relation", s.flat ? "a point in common" : "a line in common"}};
  const bool equal = vanish([&]<class W>() -> Components<W, 3> {
    Components<W, 3> x;
    for (int i = 0; i < 3; ++i) x[static_cast<std::size_t>(i)] = W(m[i]) * W(e) - W(n[i]) * W(d);
    return x;
  });
  return {{"relation", equal ? "equal" : "parallel"}};
}
void tell_two_planes(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::string both = shown_name(a.name) + " and " + shown_name(b.name), r = out.result["relation"];
  if (r == "equal") out.verdict = {Verdict::Kind::on, both + " are the same"};
  if (r == "parallel") out.verdict = {Verdict::Kind::no, both + " are parallel"};
  if (r.ends_with("in common"))
    out.verdict = {Verdict::Kind::yes, both + (s.flat ? " meet in a point" : " meet in a line")};
}

// Meshes.

struct Extent {
  Vec3 lo, hi;

  bool meets(const Extent& x) const { return (lo.array() <= x.hi.array()).all() && (x.lo.array() <= hi.array()).all(); }
};
Extent extent(const Triangle<double, 3>& x) {
  const auto& [p, q, r] = x.vertices;
  return {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
}
/// Rounded outwards.
Extent extent(const Capsule<double, 3>& x) {
  Extent e = {x.p.cwiseMin(x.q).array() - x.radius, x.p.cwiseMax(x.q).array() + x.radius};
  for (int i = 0; i < 3; ++i) e.lo[i] = std::nextafter(e.lo[i], -HUGE_VAL), e.hi[i] = std::nextafter(e.hi[i], HUGE_VAL);
  return e;
}

/// How many triangles have a point in the other; that may also lie within the mesh and have none.
Json mesh_result(const Setting& s, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(a);
  const auto count = [&](const auto& meets) {
    int met = 0;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) met += meets(triangle(mesh, i));
    return Json{{"triangles_met", met}};
  };
  const auto count_near = [&](const Extent& near, const auto& meets) {
    return count([&](const Triangle<double, 3>& x) { return near.meets(extent(x)) && meets(x); });
  };
  if (is_round(b.type)) {
    const Capsule<double, 3> c = capsule_in_space(s, b);
    return count_near(extent(c), [&](const Triangle<double, 3>& x) {
      if (c.p == c.q) return intersects(Sphere<double, 3>{c.p, c.radius}, x);
      return intersects(c, x);
    });
  }
  if (b.type == Type::triangle) {
    const Triangle<double, 3> t = triangle_of(s, b);
    return count_near(extent(t), [&](const Triangle<double, 3>& x) { return intersects(x, t); });
  }
  return count([solid = faces_of(s, b)](const Triangle<double, 3>& x) { return intersects(x, solid); });
}

Json point_and_mesh(const Setting& s, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(b);
  const Vec3 p = s.point(a, "at");
  if (!point_mesh::closed(mesh)) {
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      if (intersects(Sphere<double, 3>{p, 0}, triangle(mesh, i))) return {{"location", "on"}};
    throw NotDecided(b.name + " is not closed, so that nothing is inside; the point is not on it");
  }
  static constexpr const char* words[] = {"in", "on", "out"};
  return {{"location", words[static_cast<int>(locate(p, mesh))]}};
}

// Points beside what is thin.

line_line::Straight straight(const Setting& s, const Object& o) {
  if (o.type == Type::segment) return Segment<double, 3>{s.point(o, "from"), s.point(o, "to")};
  return ray_in_space(s, o);
}
Json point_on(const Setting& s, const Object& a, const Object& b) { return {{"on", lies_on(s, s.point(a, "at"), b)}}; }

// What runs along a line.

Json two_lines(const Setting& s, const Object& a, const Object& b) {
  static constexpr const char* names[] = {"skew", "parallel", "apart", "point", "stretch"};
  const line_line::Result r = intersect(straight(s, a), straight(s, b));
  Json result = {{"meeting", names[static_cast<int>(r.meeting)]}};
  if (r.t) result["t"] = query::number(*r.t);
  return result;
}
void tell_two_lines(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::string both = shown_name(a.name) + " and " + shown_name(b.name), r = out.result["meeting"];
  if (out.result.contains("t")) add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  meets(a, b, out, r == "point" || r == "stretch");
  if (r == "point") out.verdict.text = both + " have one point in common";
  if (r == "stretch") out.verdict.text = both + " share a stretch";
  if (r == "skew") out.verdict.text = both + " are skew";
  if (r == "parallel") out.verdict.text = both + " are parallel";
}

Json part_of_line(const std::optional<Interval<double>>& part) {
  if (!part) return {{"hit", false}};
  return {{"hit", true}, {"t_in", query::number(part->lo)}, {"t_out", query::number(part->hi)}};
}
/// The hull by its facets: a thousand of them cost a thousand signs.
Json line_and_solid(const Setting& s, const Object& a, const Object& b) {
  const HalfSpaces solid = faces_of(s, b);
  return part_of_line(a.type == Type::segment ? intersect(segment_of(s, a), solid)
                                              : intersect(ray_in_space(s, a), solid));
}
void tell_line_and_solid(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const bool hit = out.result["hit"] == true;
  if (hit) {
    add_hit(s, a, out, "*t*_{in}", out.result["t_in"], viz::Mark::disc);
    add_hit(s, a, out, "*t*_{out}", out.result["t_out"], viz::Mark::ring);
  }
  meets(a, b, out, hit);
}

Json line_and_capsule(const Setting& s, const Object& a, const Object& b) {
  const Capsule<double, 3> capsule = capsule_in_space(s, b);
  return part_of_line(a.type == Type::segment ? intersect(segment_of(s, a), capsule)
                                              : intersect(ray_in_space(s, a), capsule));
}

// In the plane: outlines, which need not be convex, against what is no outline.

using Ring2 = Ring<double, 2>;

std::vector<Ring2> plane_rings(const Setting& s, const Object& o) {
  std::vector<Ring2> rings;
  for (const auto& ring : s.rings(o)) rings.push_back(points_of<2>(ring));
  return rings;
}

/// Where some point of it lies.
Location locate_some_point(const Setting& s, const Object& o, const std::vector<Ring2>& rings) {
  if (o.type == Type::kdop) return locate_corner(kdop_of<2>(s, o), rings);
  const Vec3 point = o.type == Type::obb ? s.point(o, "center") : capsule_in_space(s, o).p;
  return locate(point_of<2>(point), Polygon<double, 2>{rings});
}

Json outline_result(const Setting& s, const Object& a, const Object& b) {
  const std::vector<Ring2> rings = plane_rings(s, b);
  const bool solid = a.type == Type::obb || a.type == Type::kdop;
  const HalfSpaces other = solid ? faces_of(s, a) : HalfSpaces{};
  for (const Ring2& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 p = half_spaces::detail::in_space<double, 2>(ring[i]),
                 q = half_spaces::detail::in_space<double, 2>(ring[i + 1 < ring.size() ? i + 1 : 0]);
      if (solid ? intersects(Triangle<double, 3>{{p, q, q}}, other)
                : intersects(capsule_in_space(s, a), Capsule<double, 3>{p, q, 0}))
        return {{"meet", true}};
    }
  return {{"meet", locate_some_point(s, a, rings) != Location::out}};
}

/// How many triangles of one mesh have a point in the other; those of a closed one that hold the other have none.
Json two_meshes(const Setting&, const Object& a, const Object& b) {
  const TriangleMesh<double> mesh = mesh_of(a), other = mesh_of(b);
  const std::vector<Aabb<double, 3>> around = boxes(mesh), around_other = boxes(other);
  std::vector<char> met(mesh.triangles.size(), 0);
  for (const auto& [i, j] : overlapping_pairs(build_bvh(around), around, build_bvh(around_other), around_other))
    if (!met[static_cast<std::size_t>(i)])
      met[static_cast<std::size_t>(i)] = intersects(triangle(mesh, i), triangle(other, j));
  return {{"triangles_met", std::ranges::count(met, 1)}};
}

}  // namespace

Json as_relation(Relation r) {
  static constexpr const char* names[] = {"disjoint", "equal", "b_contains_a", "a_contains_b", "touch", "overlap"};
  return {{"relation", names[static_cast<int>(r)]}};
}

void tell_meeting(const Setting&, const Object& a, const Object& b, Answer& out) {
  const bool meet = out.result["meet"] == true;
  const std::string both = shown_name(a.name) + " and " + shown_name(b.name);
  out.verdict = meet ? Verdict{Verdict::Kind::yes, both + " have a common point"}
                     : Verdict{Verdict::Kind::no, both + " are disjoint"};
}

void tell_on(const Setting&, const Object& a, const Object& b, Answer& out) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  out.verdict = out.result["on"] == true ? Verdict{Verdict::Kind::on, fmt::format("{} lies on {}", na, nb)}
                                         : Verdict{Verdict::Kind::no, fmt::format("{} does not lie on {}", na, nb)};
}

bool lies_on(const Setting& s, const Vec3& p, const Object& o) {
  if (o.type == Type::triangle) return intersects(Sphere<double, 3>{p, 0}, triangle_of(s, o));
  if (runs_along_a_line(o.type)) return intersect(straight(s, o), Segment<double, 3>{p, p}).meets();
  const std::vector<Vec3> points = o.type == Type::point ? std::vector{s.point(o, "at")} : s.points(o);
  return std::ranges::find(points, p) != points.end();
}

void tell_mesh(const Setting&, const Object& a, const Object& b, Answer& out) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  const int met = out.result["triangles_met"];
  out.verdict = met > 0 ? Verdict{Verdict::Kind::yes, fmt::format("{} meets {} of {} triangles of {}", nb, met,
                                                                  a.fixed.triangles.size(), na)}
                        : Verdict{Verdict::Kind::no, fmt::format("{} meets no triangle of {}", nb, na)};
  out.values = {{"triangles met", static_cast<double>(met), "", Role::hit, true}};
}

Json relation_of_solids(const Setting& s, const Object& a, const Object& b) { return solids_result(s, a, b); }

namespace {

// Segments with both ends as given, told as queries tell rays.

Json segment_and_ball(const Segment<double, 3>& segment, const Sphere<double, 3>& ball) {
  const RaySphere<double> shared = intersect(segment, ball);
  const auto root = [&](double t) { return shared.line_roots > 0 ? query::number(t) : Json(nullptr); };
  return {{"line_roots", shared.line_roots},
          {"t0", root(shared.roots.lo)},
          {"t1", root(shared.roots.hi)},
          {"ray_hit", shared.solid.has_value()},
          {"t_enter_solid", shared.solid ? query::number(shared.solid->lo) : Json(nullptr)}};
}

Json segment_and_plane(const Segment<double, 3>& segment, const Plane<double, 3>& plane) {
  const auto height = [&](const Vec3& x) { return dot(exactly<Exact>(plane.normal), exactly<Exact>(x)) + plane.d; };
  const Exact p = height(segment.p), q = height(segment.q), fall = p - q;
  const bool parallel = fall.sign() == 0, coplanar = parallel && p.sign() == 0;
  return {{"parallel", parallel},
          {"coplanar", coplanar},
          {"line_hit", !parallel || coplanar},
          {"t", parallel ? Json(nullptr) : query::number(near_quotient(p, fall))},
          {"ray_hit", p.sign() * q.sign() <= 0}};
}

Json segment_and_outline(const Segment<double, 3>& segment, const Ring<double, 3>& outline) {
  const RayPolygon<double> shared = intersect(segment, outline);
  return {{"parallel", !shared.line},
          {"coplanar", shared.coplanar},
          {"hit", shared.flat || shared.coplanar ? Json(nullptr) : Json(shared.t.has_value())},
          {"t", query::number(shared.line)},
          {"plane_point_location", shared.line ? query::name(shared.location) : Json(nullptr)}};
}

Json segment_and_mesh(const Segment<double, 3>& segment, const TriangleMesh<double>& mesh) {
  Json result = {{"hit", false}};
  std::optional<double> first;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    if (const auto t = first_hit(segment, triangle(mesh, i)); t && (!first || *t < *first)) {
      first = t;
      result = {{"hit", true}, {"t", *t}, {"triangle", i}};
    }
  return result;
}

}  // namespace

std::optional<Json> exact_of_segment(const Setting& s, const Object& a, const Object& b) {
  const Segment<double, 3> segment = segment_of(s, a);
  switch (b.type) {
    case Type::sphere:
      return segment_and_ball(segment, sphere_of<3>(s, b));
    case Type::box:
    case Type::obb:
      return part_of_line(intersect(segment, faces_of(s, b)));
    case Type::plane:
      return segment_and_plane(segment, {s.point(b, "normal"), s.number(b, "d")});
    case Type::triangle:
    case Type::polygon:
      return segment_and_outline(segment, points_of<3>(s.rings(b).front()));
    case Type::mesh:
      return segment_and_mesh(segment, mesh_of(b));
    default:
      return {};
  }
}

std::vector<Pair> pairs_of_solids() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table;
  const auto add = [&](Type a, Type b, In in, auto written, auto tell) {
    table.push_back({a, b, nullptr, in, written, tell});
  };
  for (const Type a :
       {box, obb, kdop, frustum, hull})  // in both orders, so that they are named as they are asked about
    for (const Type b : {box, obb, kdop, frustum, hull}) {
      const bool in_plane = a != frustum && b != frustum && !(a == hull && b == box) && !(a == box && b == hull) &&
                            !(a == hull && b == hull);
      const bool has_query = a == b && (a == box || a == obb);
      const bool culls = (a == frustum && b == box) || (a == box && b == frustum);
      if (!has_query && !culls && !(a == kdop && b == kdop))
        add(a, b, in_plane ? In::both : In::space, solids_result, relate);
    }
  for (const Type round : {sphere, capsule}) {
    for (const Type solid : {box, obb, kdop, frustum, hull}) {
      if (round == sphere && (solid == box || solid == frustum)) continue;
      add(round, solid, solid == frustum ? In::space : In::both, solids_result, relate);
    }
    add(round, triangle, In::space, round_and_triangle, relate);
    for (const Type outline : {triangle, polygon}) add(round, outline, In::plane, outline_result, tell_meeting);
    add(mesh, round, In::space, mesh_result, tell_mesh);
  }
  for (const Type solid : {obb, kdop, frustum, hull}) {
    add(triangle, solid, solid == obb || solid == kdop ? In::both : In::space, solids_result, relate);
    add(mesh, solid, In::space, mesh_result, tell_mesh);
    if (solid != hull) add(plane, solid, solid == frustum ? In::space : In::both, plane_result, tell_plane);
  }
  for (const Type solid : {obb, kdop}) add(solid, polygon, In::plane, outline_result, tell_meeting);
  add(mesh, triangle, In::space, mesh_result, tell_mesh);
  add(triangle, triangle, In::space, two_triangles, relate);
  add(mesh, mesh, In::space, two_meshes, tell_mesh);
  add(plane, capsule, In::both, plane_result, tell_plane);
  add(plane, plane, In::both, two_planes, tell_two_planes);
  add(point, mesh, In::space, point_and_mesh,
      [](const Setting&, const Object& a, const Object& b, Answer& out) { locate(a, b, out, out.result["location"]); });
  add(point, triangle, In::space, point_on, tell_on);
  for (const Type along : {ray, line, segment}) {
    add(point, along, In::space, point_on, tell_on);
    for (const Type other : {ray, line, segment})
      add(along, other, along == segment && other == segment ? In::space : In::both, two_lines, tell_two_lines);
    add(along, kdop, In::both, line_and_solid, tell_line_and_solid);
    add(along, frustum, In::space, line_and_solid, tell_line_and_solid);
    add(along, hull, In::space, line_and_solid, tell_line_and_solid);
    add(along, capsule, In::both, line_and_capsule, tell_line_and_solid);
  }
  return table;
}

}  // namespace isect::program::scene
