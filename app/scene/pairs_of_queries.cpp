// Pairs that a query can ask, too: the result is written as a query writes it.

#include <isect/ask.h>
#include <isect/ray_polygon.h>
#include <isect/segment_polygon.h>

#include "app/query/results.h"
#include "app/scene/pairs.h"
#include "app/scene/types.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Verdict;

/// Calls what.operator()<N>() with the dimension of the scene.
void in_dimension(const Shaped& a, const auto& what) {
  a.flat() ? what.template operator()<2>() : what.template operator()<3>();
}

// How two sets lie.

void related(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  const bool of_ball = a.type() == Type::sphere;
  out.result = query::related(*out.answer.relation, of_ball ? "sphere" : "a", of_ball ? spec(b.type()).name : "b");
}

void two_balls(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = query::two_balls(*out.answer.relation, out.answer.tangent, a.as<Sphere, 3>(), b.as<Sphere, 3>());
}

void two_boxes(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  in_dimension(a,
               [&]<int N>() { out.result = query::two_boxes(*out.answer.relation, a.as<Aabb, N>(), b.as<Aabb, N>()); });
}

void two_segments(const Shaped& a, const Shaped& b, Told& out) {
  using segment_segment::Meeting;
  out.answer = by_core(a, b);
  const SegmentSegment<double> shared = intersect(a.as<Segment, 2>(), b.as<Segment, 2>());
  out.result = query::two_segments(shared);
  if (shared.point) {
    const Point<double, 2>& at = *shared.point;
    const viz::Mark mark = shared.relation == Meeting::cross ? viz::Mark::disc : viz::Mark::diamond;
    out.marks.push_back(viz::Dot{viz::Vec3(at.x(), at.y(), 0), mark, Role::hit});
    out.formula = viz::tr("at ({x}, {y})", {{"x", viz::shown(at.x())}, {"y", viz::shown(at.y())}});
  }
  static constexpr Verdict::Kind kinds[] = {Verdict::Kind::no, Verdict::Kind::on, Verdict::Kind::yes,
                                            Verdict::Kind::yes};
  static constexpr viz::Message words[] = {viz::message("{both} are disjoint"), viz::message("{both} touch"),
                                           viz::message("{both} cross"), viz::message("{both} share a stretch")};
  const auto meeting = static_cast<std::size_t>(shared.relation);
  out.verdict = {kinds[meeting], viz::tr(words[meeting], {{"both", both_names(a, b)}})};
}

// Points.

void same_point(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"equal", out.answer.meet}};
}

void point_in_outline(const Shaped& a, const Shaped& b, Told& out) {
  const Winding w = winding(point_of<2>(a.numbers.point(a.object, "at")), b.outline());
  out.answer = answer(w.even_odd);
  out.result = query::wound(w);
  if (w.even_odd != w.nonzero) out.formula = viz::tr("by the even-odd rule");
}

// Rays, lines and segments. A segment that is no ray is asked with both ends as given, and no query asks the same.

template <int N>
void along(const Shaped& a, Told& out, const auto& asked) {
  if (const auto& ray = a.ray())
    return asked(Ray<double, N>{point_of<N>(ray->origin), point_of<N>(ray->direction), ray->range});
  asked(a.as<Segment, N>());
  out.query = {};
}

void line_and_ball(const Shaped& a, const Shaped& b, Told& out) {
  in_dimension(a, [&]<int N>() {
    along<N>(a, out, [&](const auto& line) {
      const RaySphere<double> shared = intersect(line, b.as<Sphere, N>());
      out.answer = answer(shared);
      out.result = query::line_and_ball(shared);
    });
  });
  if (a.ray()) return;
  out.result.erase("origin");
  out.result.erase("t_first_surface");
}

void part_of_segment(const Shaped& a, const Shaped& b, Told& out) {
  out.query = {};
  tell_part(by_core(a, b).part, out);
}

void line_and_round(const Shaped& a, const Shaped& b, Told& out) {
  if (!a.ray()) return part_of_segment(a, b, out);
  out.answer = by_core(*a.ray(), b);
  out.result = query::stretch(out.answer.part);
}

template <template <class, int> class Box>
void line_and_box(const Shaped& a, const Shaped& b, Told& out) {
  if (!a.ray()) return part_of_segment(a, b, out);
  in_dimension(
      a, [&]<int N>() { along<N>(a, out, [&](const auto& line) { out.answer = isect::ask(line, b.as<Box, N>()); }); });
  out.result = query::stretch(out.answer.part);
}

void line_and_plane(const Shaped& a, const Shaped& b, Told& out) {
  in_dimension(a, [&]<int N>() {
    along<N>(a, out, [&](const auto& line) {
      const Plane<double, N>& plane = b.as<Plane, N>();
      const RayPlane<double> shared = intersect(line, plane);
      out.answer = answer(shared);
      if constexpr (requires { line.range; })
        out.result = query::ray_and_plane(shared, line, plane);
      else
        out.result = query::line_and_plane(shared);
    });
  });
}

/// Asks a line and a triangle or a polygon in space.
template <class Line>
void line_and_outline(const Line& line, const Shaped& b, Told& out) {
  const Ring<double, 3>& ring = b.ring();
  const RayPolygon<double> shared = intersect(line, ring);
  out.answer = isect::answer(shared.t);
  out.result = query::line_and_polygon(shared);
  if (shared.flat) {
    if (b.type() != Type::triangle) refuse_outline(b.object);
    out.answer = isect::answer(first_hit(line, b.as<Triangle, 3>()));
    out.result["hit_without_area"] = out.answer.meet;
    return;
  }
  if (ring.size() <= most_corners && !is_simple(ring))
    out.note = viz::tr("{a} crosses or touches itself: what is inside is told by the even-odd rule.",
                       {{"a", shown_name(b.object.name)}});
  if (shared.coplanar) {
    out.answer = isect::answer(first_hit(line, Polygon<double, 3>{{ring}}));
    out.answer.coplanar = true;
    out.result["hit_in_plane"] = out.answer.meet;
  } else if (shared.line) {
    out.answer.location = shared.location;
  }
}
void line_and_outline(const Shaped& a, const Shaped& b, Told& out) {
  if (b.off_plane() > 0) {
    out.query = {};
    a.ray() ? tell_first(first_hit(*a.ray(), b.polygon()), out)
            : tell_first(first_hit(a.as<Segment, 3>(), b.polygon()), out);
    return tell_bent(b, out);
  }
  along<3>(a, out, [&](const auto& line) { line_and_outline(line, b, out); });
}

}  // namespace

std::vector<Pair> pairs_of_queries() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table = {{sphere, sphere, "sphere_sphere", In::both, two_balls},
                             {box, box, "box_box", In::both, two_boxes},
                             {sphere, box, "sphere_box", In::both, related},
                             {sphere, capsule, "sphere_capsule", In::both, related},
                             {capsule, capsule, "capsule_capsule", In::both, related},
                             {obb, obb, "obb_obb", In::both, related},
                             {plane, sphere, "plane_sphere", In::both, related},
                             {plane, box, "plane_box", In::both, related},
                             {triangle, box, "triangle_box", In::both, related},
                             {segment, segment, "segment_segment", In::plane, two_segments},
                             {point, point, "point_point", In::both, same_point},
                             {point, sphere, "point_sphere", In::both, locate},
                             {point, box, "point_box", In::both, locate},
                             {point, obb, "point_obb", In::both, locate}};
  for (const Type outline : {triangle, polygon}) table.push_back({point, outline, "pip", In::plane, point_in_outline});
  table.push_back({point, cylinder, "point_cylinder", In::space, locate});
  table.push_back({point, cone, "point_cone", In::space, locate});
  table.push_back({plane, cylinder, "plane_cylinder", In::space, related});
  table.push_back({plane, cone, "plane_cone", In::space, related});
  table.push_back({sphere, cylinder, "sphere_cylinder", In::space, related});
  table.push_back({sphere, cone, "sphere_cone", In::space, related});
  for (const Type line : {ray, Type::line, segment}) {
    table.push_back({line, sphere, "ray_sphere", In::both, line_and_ball});
    table.push_back({line, box, "ray_box", In::both, line_and_box<Aabb>});
    table.push_back({line, obb, "ray_obb", In::both, line_and_box<Obb>});
    table.push_back({line, plane, "ray_plane", In::both, line_and_plane});
    table.push_back({line, cylinder, "ray_cylinder", In::space, line_and_round});
    table.push_back({line, cone, "ray_cone", In::space, line_and_round});
    for (const Type outline : {triangle, polygon})
      table.push_back({line, outline, "ray_polygon", In::space, line_and_outline});
  }
  return table;
}

}  // namespace isect::program::scene
