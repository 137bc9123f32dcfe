// Polygons in space against what has a test of triangles: they are cut into some.

#include <fmt/format.h>

#include <algorithm>

#include <isect/ask.h>
#include <isect/orient.h>

#include "app/query/reply.h"
#include "app/scene/in_plane.h"
#include "app/scene/pairs.h"
#include "app/scene/triangulated.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

/// Corners off one plane are told.
void tell_bent(const Shaped& o, Told& out) {
  const double off = o.off_plane();
  if (off == 0) return;
  out.result["off_plane"] = std::max(off, out.result.value("off_plane", 0.0));
  out.note += fmt::format(
      "{}The corners of {} lie up to {} off one plane: what is tested are the triangles that its outline is cut into.",
      out.note.empty() ? "" : " ", shown_name(o.object.name), viz::shown(off));
}

bool meet(const Triangles& triangles, const Shaped& b) {
  const auto meets = [&](const Triangle<double, 3>& t) {
    if (b.type() != Type::triangle && b.type() != Type::polygon) return by_core(t, b).meet;
    return std::ranges::any_of(b.surface(), [&](const auto& other) { return intersects(t, other); });
  };
  return std::ranges::any_of(triangles, meets);
}

/// A convex outline all in one plane, or a triangle, as half-spaces; nothing of another outline.
std::optional<HalfSpaces> plate(const Shaped& o) {
  if (o.type() == Type::triangle) return triangle_half_spaces::detail::solid_of(o.as<Triangle, 3>(), 3, NoTrace());
  const Ring<double, 3>& outline = o.ring();
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

/// Those of a ball's or a capsule's, a cylinder's or a cone's axis, where that is all of it.
HalfSpaces axis_of(const Capsule<double, 3>& x) { return half_spaces_of(Segment<double, 3>{x.p, x.q}); }
HalfSpaces axis_of(const Cylinder<double>& x) { return half_spaces_of(Segment<double, 3>{x.p, x.q}); }
HalfSpaces axis_of(const Cone<double>& x) { return half_spaces_of(Segment<double, 3>{x.apex, x.base}); }

/// Calls use(round) with what is round; false if it is not.
bool if_round(const Shaped& o, const auto& use) {
  if (o.type() == Type::sphere || o.type() == Type::capsule) return use(capsule_in_space(o.setting, o.object)), true;
  if (o.type() == Type::cylinder) return use(std::get<Cylinder<double>>(o.shape<3>())), true;
  if (o.type() == Type::cone) return use(std::get<Cone<double>>(o.shape<3>())), true;
  return false;
}

/// How they lie, where the exact test is at hand; else whether they meet.
void polygon_and(const Shaped& a, const Shaped& b, Told& out) {
  const Triangles& triangles = a.surface();
  const std::optional<HalfSpaces> flat = plate(a);
  std::optional<HalfSpaces> other;
  std::optional<Relation> to_round;
  const bool round = if_round(b, [&](const auto& x) {
    if (x.radius > 0)
      to_round = relate_surface(triangles, x);
    else
      other = axis_of(x);
  });
  if (to_round) return give(*to_round, out);
  if (b.type() == Type::triangle || b.type() == Type::polygon) {
    if (b.type() == Type::polygon) static_cast<void>(b.surface());  // refuses one without an area
    other = plate(b);
  } else if (!round) {
    other = b.faces();
  }
  if (other && flat) return give(relate(*flat, *other), out);
  if (other && half_spaces::detail::has_interior(other->faces, NoTrace()))
    return give(to_solid(triangles, *other), out);
  out.answer.meet = meet(triangles, b);
  out.result = {{"meet", out.answer.meet}};
}

/// How many triangles of the mesh have a point in the polygon.
void mesh_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  TriangleMesh<double> surface;
  for (const Triangle<double, 3>& t : b.surface()) {
    const int first = static_cast<int>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), t.vertices.begin(), t.vertices.end());
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  out.answer = isect::ask(a.mesh().mesh, surface);
  out.result = {{"triangles_met", *out.answer.triangles}};
}

bool holds(const Triangles& triangles, const Vec3& p) {
  return std::ranges::any_of(triangles, [&](const auto& t) { return isect::ask(p, t).meet; });
}
void point_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  out.answer.meet = holds(b.surface(), a.setting.point(a.object, "at"));
  out.result = {{"on", out.answer.meet}};
}
void cloud_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  std::vector<Location> where;
  for (const Vec3& p : a.points()) where.push_back(holds(b.surface(), p) ? Location::on : Location::out);
  tell_cloud_on(a, b, where, out);
}

template <void (*asked)(const Shaped&, const Shaped&, Told&)>
void bent_or_not(const Shaped& a, const Shaped& b, Told& out) {
  asked(a, b, out);
  tell_bent(a, out);
  tell_bent(b, out);
}

}  // namespace

Triangles surface_of(const Shaped& o) {
  if (o.type() == Type::triangle) return {o.as<Triangle, 3>()};
  if (o.ring().size() > most_corners)
    throw NotDecided(fmt::format("{} has more than {} corners", o.object.name, most_corners));
  Triangles all = triangulated(o.ring());
  if (all.empty()) refuse_outline(o.object);
  return all;
}

void along_surface(const Shaped& a, const Shaped& polygon, Told& out) {
  std::optional<double> least;
  for (const Triangle<double, 3>& x : polygon.surface()) {
    const std::optional<double> t = a.ray() ? first_hit(*a.ray(), x) : first_hit(a.as<Segment, 3>(), x);
    if (t && (!least || *t < *least)) least = t;
  }
  tell_first(least, out);
  tell_bent(polygon, out);
}

namespace {

Relation to_triangle(const Capsule<double, 3>& x, const Triangle<double, 3>& t) { return relate(x, t); }
template <class Round>
Relation to_triangle(const Round& x, const Triangle<double, 3>& t) {
  return relate(x, ask_pairs::solid_of(t));
}

}  // namespace

template <class Round>
Relation relate_surface(const Triangles& triangles, const Round& round) {
  bool inside = true, touch = false, overlap = false;
  for (const Triangle<double, 3>& t : triangles) {
    const Relation r = to_triangle(round, t);
    inside &= r == Relation::b_inside_a, touch |= r == Relation::touching;
    overlap |= r == Relation::b_inside_a || r == Relation::overlapping;
  }
  return inside    ? Relation::a_inside_b
         : overlap ? Relation::overlapping
         : touch   ? Relation::touching
                   : Relation::disjoint;
}

template Relation relate_surface(const Triangles&, const Capsule<double, 3>&);
template Relation relate_surface(const Triangles&, const Cylinder<double>&);
template Relation relate_surface(const Triangles&, const Cone<double>&);

std::vector<Pair> pairs_of_polygons() {
  using enum Type;
  const auto in = Pair::In::space;
  std::vector<Pair> table = {{point, polygon, nullptr, in, bent_or_not<point_and_polygon>},
                             {cloud, polygon, nullptr, in, bent_or_not<cloud_and_polygon>},
                             {mesh, polygon, nullptr, in, bent_or_not<mesh_and_polygon>}};
  for (const Type other : {sphere, box, obb, capsule, cylinder, cone, triangle, polygon, kdop, hull, frustum})
    table.push_back({polygon, other, nullptr, in, bent_or_not<polygon_and>});
  return table;
}

}  // namespace isect::program::scene
