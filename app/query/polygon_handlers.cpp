// Polygons, hulls and fits.

#include <isect/clip_polygon.h>
#include <isect/convex_hull.h>
#include <isect/convex_polygons.h>
#include <isect/fit.h>
#include <isect/fit_tight.h>
#include <isect/many/slab_map.h>
#include <isect/many/trapezoid_map.h>
#include <isect/methods/clip_polygon.h>
#include <isect/methods/point_convex_polygon.h>
#include <isect/methods/point_polygon.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include <isect/polygon.h>
#include <isect/polygon_polygon.h>
#include "app/query/events.h"
#include "app/query/handlers.h"
#include "app/query/results.h"

namespace isect::query {

// clang-format off
template <> struct EventNames<clip_polygon::Side> : Named<"Side", "index sign"> {};
template <class S, int N> struct EventNames<clip_polygon::Crossing<S, N>> : Named<"Crossing", "index point"> {};
template <> struct EventNames<convex_polygons::Edge> : Named<"Edge", "of_b index"> {};
template <> struct EventNames<convex_polygons::Farthest> : Named<"Farthest", "edge vertex side"> {};
template <> struct EventNames<convex_polygons::Contained> : Named<"Contained", "b_in_a a_in_b"> {};
template <> struct EventNames<convex_hull_2d::Remaining> : Named<"Remaining", "count"> {};
template <class S> struct EventNames<convex_hull_2d::Added<S>> : Named<"Added", "p"> {};
template <class S> struct EventNames<convex_hull_2d::Removed<S>> : Named<"Removed", "p next turn"> {};
template <> struct EventNames<point_convex_polygon::Fan> : Named<"Fan", "first last"> {};
template <> struct EventNames<point_convex_polygon::Wedge> : Named<"Wedge", "lo mid hi turn"> {};
template <> struct EventNames<point_convex_polygon::Chord> : Named<"Chord", "lo hi turn"> {};
template <class S> struct EventNames<point_convex_polygon::Centroid<S>> : Named<"Centroid", "q"> {};
template <class S> struct EventNames<point_convex_polygon::WedgeAround<S>> : Named<"WedgeAround", "lo mid hi cross"> {};
template <class S> struct EventNames<point_convex_polygon::EdgeSide<S>> : Named<"EdgeSide", "from to cross"> {};
template <> struct EventNames<polygon_area::AreaVector> : Named<"AreaVector", "scaled largest"> {};
template <> struct EventNames<slab_map::SlabFound> : Named<"SlabFound", "slab steps"> {};
template <> struct EventNames<slab_map::OnLine> : Named<"OnLine", "slab steps holds"> {};
template <> struct EventNames<slab_map::Compared> : Named<"Compared", "edge turn"> {};
template <> struct EventNames<trapezoid_map::VertexAsked> : Named<"VertexAsked", "vertex side"> {};
template <> struct EventNames<trapezoid_map::PieceAsked> : Named<"PieceAsked", "piece side"> {};
template <> struct EventNames<trapezoid_map::Reached> : Named<"Reached", "trapezoid"> {};
template <> struct EventNames<trapezoid_map::Inserted> : Named<"Inserted", "piece cut"> {};
// clang-format on

namespace {

// What would take more is refused; `isect query --help` has both.
constexpr std::size_t most_slab_bytes = std::size_t{256} << 20, most_fit_products = std::size_t{1} << 26;

template <class S>
Polygon<S, 2> polygon(const Field& rings) {
  Polygon<S, 2> p;
  p.rings.reserve(rings.size());
  for (const Field entry : rings.list()) p.rings.push_back(ring<S, 2>(entry));
  return p;
}

/// The naive methods handle neither the boundary nor other rings: each ring is counted by itself, and the sum returned.
template <class S, class Method>
int summed(Job& job, const Polygon<S, 2>& p, const Method& method) {
  int sum = 0;
  for (const Ring<S, 2>& r : p.rings)
    sum += run<point_polygon::NaiveEvent<S>>(job, [&](auto&& trace) { return static_cast<int>(method(r, trace)); });
  return sum;
}

Json in_or_out(bool in) { return in ? "in" : "out"; }

/// Locates a point after preprocessing: the winding number, none on the boundary, is the only result.
template <class Event, class S, class Make>
Json by_map(Job& job, const Polygon<S, 2>& polygon, const Point<S, 2>& point, const Make& make) {
  const auto map = [&] {
    try {
      return make(polygon);
    } catch (const std::logic_error& e) {  // edges that cross, or too large a map
      job.fields["rings"].refuse(e.what());
    }
  }();
  const std::optional<int> times = run<Event>(job, [&](auto&& trace) { return winding(point, map, trace); });
  const auto where = [&](bool inside) { return name(!times ? Location::on : inside ? Location::in : Location::out); };
  return {{"evenodd", where(times.value_or(0) % 2 != 0)},
          {"nonzero", where(times.value_or(0) != 0)},
          {"winding", times ? Json(*times) : Json(nullptr)}};
}

template <class S>
Json pip(Job& job) {
  const Polygon<S, 2> p = polygon<S>(job.fields["rings"]);
  const Point<S, 2> point = vector<S, 2>(job.fields["point"]);
  if (job.variant == "crossings_naive") {
    const auto method = [&](const auto& r, auto&& trace) { return point_polygon::crossings_naive(point, r, trace); };
    return {{"evenodd", in_or_out(summed(job, p, method) % 2 != 0)}};
  }
  if (job.variant == "winding_naive") {
    const auto method = [&](const auto& r, auto&& trace) { return point_polygon::winding_naive(point, r, trace); };
    const int winding = summed(job, p, method);
    return {{"nonzero", in_or_out(winding != 0)}, {"winding", winding}};
  }

  if (job.variant == "convex") {
    if (p.rings.size() != 1) job.fields["rings"].complain("one ring is expected for the convex variant");
    const auto convex = make_convex(p.rings[0]);
    if (!convex)
      job.fields["rings"].list().front().refuse("it is not convex with an area, so the convex variant can't be used");
    const Location where =
        run<point_convex_polygon::Event>(job, [&](auto&& trace) { return locate(point, *convex, trace); });
    return {{"evenodd", name(where)}, {"nonzero", name(where)}};
  }

  if (job.variant == "slabs")
    return by_map<slab_map::Event>(job, p, point, [](const auto& of) { return make_slab_map(of, most_slab_bytes); });
  if (job.variant == "trapezoids")
    return by_map<trapezoid_map::Event>(job, p, point, [](const auto& of) { return make_trapezoid_map(of); });

  const Winding w = run<point_polygon::Event>(job, [&](auto&& trace) { return winding(point, p, trace); });
  Json result = wound(w);
  if (job.variant == "crossings") return {{"evenodd", result["evenodd"]}};
  if (job.variant == "winding") result.erase("evenodd");
  return result;
}

template <class S>
Json polygon_polygon(Job& job) {
  return related(relate(polygon<S>(job.fields["a"]), polygon<S>(job.fields["b"])));
}

template <class S>
ConvexPolygon<S> convex_polygon(const Field& field) {
  const auto convex = make_convex(ring<S, 2>(field));
  if (!convex) field.refuse("it is not convex with an area");
  return *convex;
}
template <class S>
Json convex_polygons(Job& job) {
  const ConvexPolygon<S> a = convex_polygon<S>(job.fields["a"]), b = convex_polygon<S>(job.fields["b"]);
  return related(run<convex_polygons::Event>(job, [&](auto&& trace) { return relate(a, b, trace); }));
}

/// Returns what is left of a polygon, beginning at the first of its vertices that is kept, or of its edges that is cut.
template <class S, int N>
Json left_of(const Ring<S, N>& ring) {
  return {{"hit", !ring.empty()}, {"points", numbers<S, N>(ring)}};
}

template <class S>
Json polygon_plane(Job& job) {
  return in_dimension(job.fields["normal"], [&]<int N>() -> Json {
    const Ring<S, N> outline = ring<S, N>(job.fields["polygon"]);
    const Plane<S, N> p = plane<S, N>(job.fields);
    using Event = clip_polygon::Event<S, N>;
    if (job.variant == "sutherland_hodgman")
      return left_of<S, N>(
          run<Event>(job, [&](auto&& trace) { return clip_polygon::sutherland_hodgman(outline, p, trace); }));
    return left_of<S, N>(run<Event>(job, [&](auto&& trace) { return clip(outline, p, trace); }));
  });
}

template <class S>
Json polygon_box(Job& job) {
  return in_dimension(job.fields["lo"], [&]<int N>() -> Json {
    const Ring<S, N> outline = ring<S, N>(job.fields["polygon"]);
    const Aabb<S, N> b = box<S, N>(job.fields);
    return left_of<S, N>(run<clip_polygon::Event<S, N>>(job, [&](auto&& trace) { return clip(outline, b, trace); }));
  });
}

template <class S>
Json segment_polygon(Job& job) {
  return related(relate(segment<S, 2>(job.fields["segment"]), polygon<S>(job.fields["rings"])), "segment", "polygon");
}

template <class S>
Json convex_hull2d(Job& job) {
  const Ring<S, 2> points = ring<S, 2>(job.fields["points"]);
  return {{"hull", numbers<S, 2>(run<convex_hull_2d::Event<S>>(
                       job, [&](auto&& trace) { return isect::convex_hull(points, trace); }))}};
}

template <class S>
Json polygon_normal(Job& job) {
  const Ring<S, 3> outline = ring<S, 3>(job.fields["polygon"]);
  const auto n = run<polygon_area::Event>(job, [&](auto&& trace) { return normal(outline, trace); });
  return {{"normal", n ? numbers<S, 3>(*n) : nullptr}, {"area", number(area(outline))}};
}

/// Returns the axes and the diagonals of the square or cube: an 8-DOP in the plane, a 14-DOP in space.
template <class S, int N>
std::vector<Vector<S, N>> usual_normals() {
  if constexpr (N == 2)
    return {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  else
    return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
}

template <class S, int N>
Json kdop_around(const Job& job, const Ring<S, N>& points) {
  const auto given = job.fields.find("normals");
  if (given && given->size() * points.size() > most_fit_products)
    given->refuse(std::to_string(given->size()) + " normals for " + std::to_string(points.size()) +
                  " points are too many; allowed: normals times points up to " + std::to_string(most_fit_products));
  const Kdop<S, N> k = fit_kdop(points, given ? ring<S, N>(*given) : usual_normals<S, N>());
  Json lo = Json::array(), hi = Json::array();
  for (const Interval<S>& slab : k.slabs) lo.push_back(number(slab.lo)), hi.push_back(number(slab.hi));
  return {{"normals", numbers<S, N>(k.normals)}, {"lo", lo}, {"hi", hi}};
}

template <class S>
Json bounding_volume_fit(Job& job) {
  const Field::Entries entries = job.fields["points"].list();
  if (entries.empty()) job.fields["points"].complain("at least one point is expected");
  return in_dimension(entries.front(), [&]<int N>() -> Json {
    const Ring<S, N> points = ring<S, N>(job.fields["points"]);
    const std::string volume = job.fields["volume"].text();
    if (const auto given = job.fields.find("normals"); given && volume != "kdop")
      given->refuse("normals are for the volume kdop");
    if (volume == "aabb") {
      const Aabb<S, N> b = fit_aabb(points);
      return {{"lo", numbers<S, N>(b.lo)}, {"hi", numbers<S, N>(b.hi)}};
    }
    if (volume == "sphere" || volume == "smallest_sphere") {
      const Sphere<S, N> ball = volume == "sphere" ? fit_sphere(points) : fit_sphere_smallest(points);
      return {{"center", numbers<S, N>(ball.center)}, {"radius", number(ball.radius)}};
    }
    if (volume == "obb") {
      const Obb<S, N> b = fit_obb(points);
      Json axes = Json::array();
      for (int i = 0; i < N; ++i) axes.push_back(numbers<S, N>(b.axes.col(i)));
      return {{"c", numbers<S, N>(b.center)}, {"u", axes}, {"e", numbers<S, N>(b.half)}};
    }
    if (volume == "kdop") return kdop_around(job, points);
    job.fields["volume"].complain("aabb, sphere, smallest_sphere, obb or kdop is expected");
  });
}

}  // namespace

const std::vector<Handler>& polygon_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(
          pip, "rings point",
          {"exact", "crossings", "winding", "convex", "slabs", "trapezoids", "crossings_naive", "winding_naive"}),
      ISECT_HANDLER(polygon_polygon, "a b", {"exact"}),
      ISECT_HANDLER(convex_polygons, "a b", {"exact"}),
      ISECT_HANDLER(polygon_plane, "polygon normal d", {"exact", "sutherland_hodgman"}),
      ISECT_HANDLER(polygon_box, "polygon lo hi", {"exact"}),
      ISECT_HANDLER(segment_polygon, "segment rings", {"exact"}),
      ISECT_HANDLER(convex_hull2d, "points", {"exact"}),
      ISECT_HANDLER(polygon_normal, "polygon", {"exact"}),
      ISECT_HANDLER(bounding_volume_fit, "points volume [normals]", {"exact"}),
  };
  return table;
}

}  // namespace isect::query
