// Convex solids with each other and with balls, capsules, triangles, planes and lines; lines in space; points beside
// thin objects.

#include <fmt/format.h>

#include <isect/polygon_in_space.h>

#include "app/query/reply.h"
#include "app/scene/pairs.h"

namespace isect::program::scene {

namespace {

/// Asks a ball or capsule and each facet of a hull. Without a radius it is a segment, which is a solid.
void round_and_hull(const Shaped& a, const Shaped& b, Told& out) {
  const Capsule<double, 3> capsule = capsule_in_space(a.numbers, a.object);
  if (a.flat() || capsule.radius == 0) return relate(a, b, out);
  const auto end_in = [&](const viz::Vec3& end) {
    return sphere_half_spaces::detail::contained(end, capsule.radius, b.faces(), NoTrace());
  };
  Relation r = Relation::a_inside_b;
  if (!end_in(capsule.p) || !end_in(capsule.q)) {
    const TriangleMesh<double> facets = {b.hull().vertices, b.hull().triangles};
    r = reversed(polygon_in_space::detail::to_round(facets, capsule));
  }
  give(r, out);
}

void two_planes(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  const char* crossing = a.flat() ? "a point in common" : "a line in common";
  out.result = {{"relation", !out.answer.parallel ? crossing : out.answer.meet ? "equal" : "parallel"}};
}

void point_on(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"on", out.answer.meet}};
}

void two_lines(const Shaped& a, const Shaped& b, Told& out) {
  const Answer& x = out.answer = by_core(a, b);
  out.result = {{"meeting", x.meet       ? x.one_point ? "point" : "stretch"
                            : x.parallel ? "parallel"
                            : x.coplanar ? "apart"
                                         : "skew"}};
  if (x.t) out.result["t"] = query::number(*x.t);
}

void line_and_solid(const Shaped& a, const Shaped& b, Told& out) { tell_part(by_core(a, b).part, out); }

}  // namespace

std::vector<Pair> pairs_of_solids() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table;
  const auto add = [&](Type a, Type b, In in, auto asked) { table.push_back({a, b, nullptr, in, asked}); };
  for (const Type a :
       {box, obb, kdop, frustum, hull})  // in both orders, so that they are named as they are asked about
    for (const Type b : {box, obb, kdop, frustum, hull}) {
      const bool in_plane = a != frustum && b != frustum && !(a == hull && b == box) && !(a == box && b == hull) &&
                            !(a == hull && b == hull);
      const bool has_query = a == b && (a == box || a == obb);
      const bool culls = (a == frustum && b == box) || (a == box && b == frustum);
      if (!has_query && !culls && !(a == kdop && b == kdop)) add(a, b, in_plane ? In::both : In::space, relate);
    }
  for (const Type round : {sphere, capsule}) {
    for (const Type solid : {box, obb, kdop, frustum}) {
      if (round == sphere && (solid == box || solid == frustum)) continue;
      add(round, solid, solid == frustum ? In::space : In::both, relate);
    }
    add(round, hull, In::both, round_and_hull);
    for (const Type outline : {triangle, polygon}) add(round, outline, In::plane, relate);
    add(round, triangle, In::space, relate);
  }
  for (const Type solid : {obb, kdop, frustum, hull}) {
    add(triangle, solid, solid == obb || solid == kdop ? In::both : In::space, relate);
    if (solid != hull) add(plane, solid, solid == frustum ? In::space : In::both, relate);
  }
  for (const Type round : {cylinder, cone}) {
    for (const Type solid : {box, obb, kdop, frustum, hull}) add(round, solid, In::space, relate);
    add(triangle, round, In::space, relate);
  }
  for (const Type solid : {obb, kdop}) add(solid, polygon, In::plane, relate);
  add(triangle, triangle, In::space, relate);
  add(plane, capsule, In::both, relate);
  add(plane, plane, In::both, two_planes);
  add(point, triangle, In::space, point_on);
  for (const Type along : {ray, line, segment}) {
    add(point, along, In::space, point_on);
    for (const Type other : {ray, line, segment})
      add(along, other, along == segment && other == segment ? In::space : In::both, two_lines);
    add(along, kdop, In::both, line_and_solid);
    add(along, capsule, In::both, line_and_solid);
    add(along, frustum, In::space, line_and_solid);
    add(along, hull, In::space, line_and_solid);
  }
  return table;
}

}  // namespace isect::program::scene
