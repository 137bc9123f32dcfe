// In the plane: outlines against outlines, and whatever runs along a line against outlines and segments. Points and
// corners beside a line or a plane.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <isect/convex_hull.h>
#include <isect/convex_polygons.h>
#include <isect/numbers/exact.h>
#include <isect/orient.h>
#include <isect/point_line.h>
#include <isect/point_plane.h>
#include <isect/point_polygon.h>
#include <isect/polygon_polygon.h>
#include <isect/ray_outline.h>
#include <isect/segment_segment.h>

#include "app/query/reply.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;
using viz::Verdict;
using Ring2 = Ring<double, 2>;

/// A box, a hull, a triangle or a polygon; a segment as one that has no inside.
std::vector<Ring2> outlines_of(const Setting& s, const Object& o) {
  if (o.type == Type::segment) return {{point_of<2>(s.point(o, "from")), point_of<2>(s.point(o, "to"))}};
  if (o.type == Type::hull) return {convex_hull(points_of<2>(s.points(o)))};
  if (o.type == Type::box) {
    const Vec3 lo = s.point(o, "lo"), hi = s.point(o, "hi");
    return {{{lo.x(), lo.y()}, {hi.x(), lo.y()}, {hi.x(), hi.y()}, {lo.x(), hi.y()}}};
  }
  std::vector<Ring2> rings;
  for (const auto& ring : s.rings(o)) rings.push_back(points_of<2>(ring));
  return rings;
}

// What runs along a line.

Json along_result(const Setting& s, const Object& a, const Object& b) {
  const Polygon<double, 2> polygon = {outlines_of(s, b)};
  std::optional<double> t;
  if (a.type == Type::segment) {
    t = first_hit(Segment<double, 2>{point_of<2>(s.point(a, "from")), point_of<2>(s.point(a, "to"))}, polygon);
  } else {
    const Ray<double, 3> ray = ray_in_space(s, a);
    t = first_hit(Ray<double, 2>{point_of<2>(ray.origin), point_of<2>(ray.direction), ray.range}, polygon);
  }
  Json result = {{"hit", t.has_value()}};
  if (t) result["t"] = query::number(*t);
  return result;
}

void tell_along(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const bool hit = out.result["hit"] == true;
  if (hit) add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  meets(a, b, out, hit);
}

// Outlines.

/// The segment, or the point, that one ring without an area is.
std::optional<Segment<double, 2>> thin(const std::vector<Ring2>& rings) {
  if (rings.size() != 1) return {};
  const Ring2 hull = convex_hull(rings.front());
  return hull.size() == 1 || hull.size() == 2 ? std::optional(Segment<double, 2>{hull.front(), hull.back()})
                                              : std::nullopt;
}

/// Each has its interior within the line that it spans.
Relation relation_of_segments(const Segment<double, 2>& a, const Segment<double, 2>& b) {
  const Relation r = isect::relate(a, Polygon<double, 2>{{{b.p, b.q}}});
  const auto met = intersect(a, b).relation;
  const bool within = met == segment_segment::Meeting::cross || met == segment_segment::Meeting::overlap;
  return r == Relation::touching && within ? Relation::overlapping : r;
}

/// How they lie, by the even-odd rule; what has no area, as a segment.
Json outlines_result(const Setting& s, const Object& a, const Object& b) {
  const Polygon<double, 2> p = {outlines_of(s, a)}, q = {outlines_of(s, b)};
  const auto thin_p = thin(p.rings), thin_q = thin(q.rings);
  if (thin_p && thin_q) return as_relation(relation_of_segments(*thin_p, *thin_q));
  if (thin_p) return as_relation(isect::relate(*thin_p, q));
  if (thin_q) return as_relation(reversed(isect::relate(*thin_q, p)));
  return as_relation(isect::relate(p, q));
}

// A point beside a line or a plane.

Plane<double, 3> plane_in_space(const Setting& s, const Object& o) { return {s.point(o, "normal"), s.number(o, "d")}; }

Json beside_plane(const Setting& s, const Object& a, const Object& b) {
  return {{"side", side(plane_in_space(s, b), s.point(a, "at"))}};
}
void tell_beside_plane(const Setting&, const Object& a, const Object& b, Answer& out) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  const int side = out.result["side"];
  if (side == 0) out.verdict = {Verdict::Kind::on, na + " lies in " + nb};
  if (side > 0) out.verdict = {Verdict::Kind::no, fmt::format("{} lies beside {}, where its normal points", na, nb)};
  if (side < 0)
    out.verdict = {Verdict::Kind::no, fmt::format("{} lies beside {}, on the side that its normal leaves", na, nb)};
}

/// Its corners, or its points.
std::vector<Vec3> all_corners(const Setting& s, const Object& o) {
  std::vector<Vec3> all;
  if (o.type == Type::triangle || o.type == Type::polygon)
    for (const std::vector<Vec3>& ring : s.rings(o)) all.insert(all.end(), ring.begin(), ring.end());
  else if (o.type == Type::mesh)  // those of its triangles
    for (const TriangleMesh<double> mesh = mesh_of(o); const std::array<int, 3>& triangle : mesh.triangles)
      for (const int i : triangle) all.push_back(mesh.vertices[i]);
  else
    all = s.points(o);
  return all;
}

Json corners_beside_plane(const Setting& s, const Object& a, const Object& b) {
  const Sides count = sides<double, 3>(plane_in_space(s, a), all_corners(s, b));
  return {{"behind", count.behind}, {"on", count.on}, {"before", count.before}};
}
void tell_corners(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  const int behind = out.result["behind"], on = out.result["on"], before = out.result["before"];
  if (behind > 0 && before > 0)
    out.verdict = {Verdict::Kind::yes, b.type == Type::cloud ? fmt::format("{} has points on both sides of {}", nb, na)
                                                             : fmt::format("{} cuts {}", na, nb)};
  else if (on > 0)
    out.verdict = {Verdict::Kind::on,
                   behind + before > 0 ? fmt::format("{} and {} touch", na, nb) : fmt::format("{} lies in {}", nb, na)};
  else
    out.verdict = {Verdict::Kind::no,
                   fmt::format("{} lies beside {}, {}", nb, na,
                               before > 0 ? "where its normal points" : "on the side that its normal leaves")};
  if (b.type == Type::mesh) return;  // whose triangles share corners
  const char* unit = b.type == Type::cloud || b.type == Type::hull ? "points" : "corners";
  out.values = {{"where the normal points", static_cast<double>(before), unit, viz::Role::text, true},
                {s.flat ? "on the line" : "in the plane", static_cast<double>(on), unit, viz::Role::hit, true},
                {"on the other side", static_cast<double>(behind), unit, viz::Role::text, true}};
}

/// Left of it, right of it, on it, or in line with it and beyond an end.
Json beside_line(const Setting& s, const Object& a, const Object& b) {
  static constexpr const char* words[] = {"on", "in line", "in line", "left", "right", "in line"};
  const Point<double, 2> p = point_of<2>(s.point(a, "at"));
  const auto in_plane = [&] {
    const Ray<double, 3> ray = ray_in_space(s, b);
    return Ray<double, 2>{point_of<2>(ray.origin), point_of<2>(ray.direction), ray.range};
  };
  const Beside where =
      b.type == Type::segment
          ? beside(p, Segment<double, 2>{point_of<2>(s.point(b, "from")), point_of<2>(s.point(b, "to"))})
          : beside(p, in_plane());
  return {{"where", words[static_cast<int>(where)]}};
}
void tell_beside_line(const Setting&, const Object& a, const Object& b, Answer& out) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name), where = out.result["where"];
  if (where == "on") out.verdict = {Verdict::Kind::on, na + " lies on " + nb};
  if (where == "in line")
    out.verdict = {Verdict::Kind::no, fmt::format("{} lies in line with {}, beyond its end", na, nb)};
  if (where == "left" || where == "right")
    out.verdict = {Verdict::Kind::no, fmt::format("{} lies {} of {}", na, where, nb)};
}

}  // namespace

std::optional<Ring2> convex_corners(const Ring2& outline) {
  // A corner named again and a point of a side, between its neighbours, change nothing of the set.
  Ring2 ring;
  const auto says_nothing = [](const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& c) {
    return b == c || (orient2d(a, b, c) == 0 && (a.cwiseMin(c).array() <= b.array()).all() &&
                      (b.array() <= a.cwiseMax(c).array()).all());
  };
  for (const Point<double, 2>& p : outline) {
    while (ring.size() > 1 && says_nothing(ring[ring.size() - 2], ring.back(), p)) ring.pop_back();
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }
  while (ring.size() > 2 && says_nothing(ring[ring.size() - 2], ring.back(), ring.front())) ring.pop_back();
  while (ring.size() > 2 && says_nothing(ring.back(), ring.front(), ring[1])) ring.erase(ring.begin());

  const Ring2 hull = convex_hull(ring);
  if (hull.size() < 3) return {};
  for (int way = 0; way < 2; ++way) {
    const auto first = std::ranges::find(ring, hull.front());
    if (first == ring.end()) return {};
    std::rotate(ring.begin(), first, ring.end());
    if (ring == hull) return hull;
    std::ranges::reverse(ring);
  }
  return {};
}

std::vector<Pair> pairs_in_plane() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table = {{point, plane, nullptr, In::both, beside_plane, tell_beside_plane}};
  for (const Type with_corners : {triangle, polygon, hull, mesh, cloud})
    table.push_back({plane, with_corners, nullptr, with_corners == mesh ? In::space : In::both, corners_beside_plane,
                     tell_corners});
  for (const Type along : {segment, ray, line}) {
    table.push_back({point, along, nullptr, In::plane, beside_line, tell_beside_line});
    for (const Type outline : {triangle, polygon, hull})
      table.push_back({along, outline, nullptr, In::plane, along_result, tell_along});
  }
  for (const Type a : {triangle, polygon, hull, box})  // in both orders, so that they are named as they are asked about
    for (const Type b : {triangle, polygon, hull, box}) {
      const bool has_query = (a == box && b == box) || (a == box && b == triangle) || (a == triangle && b == box);
      if (!has_query) table.push_back({a, b, nullptr, In::plane, outlines_result, relate});
    }
  return table;
}

}  // namespace isect::program::scene
