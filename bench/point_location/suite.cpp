// Point location in a polygon prepared for it: slabs in floating point, exact slabs, trapezoids, grid. The question is
// whether the closed polygon holds the point. Then what preparation costs, and how that and a query grow.

#include <isect/many/polygon_grid.h>
#include <isect/many/slab_map.h>
#include <isect/many/trapezoid_map.h>
#include <isect/methods/slab_map.h>
#include "bench/contest.h"
#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/point_location/peers.h"
#endif

namespace isect::bench::point_location_suite {
namespace {

template <class S>
using Case = PolygonCase<S>;

template <class S, class Map>
void enter_map(Contest<S, Case<S>>& contest, const char* name, const Map& map) {
  contest.enter(name, [&map](const Case<S>& c) { return locate(c.point, map); })
      .exact()
      .fallback([&map](const Case<S>& c) {
        return fell_back([&](const auto& trace) { locate(c.point, map, FillRule::even_odd, trace); });
      });
}

template <class S>
void compete(Session& session, const char* name, int n) {
  using slab_map::Abscissa;
  const PolygonFamily<S> family = polygon_family<S>(name, n);
  const Ring<S, 2>& ring = family.rings.at(0);
  Contest<S, Case<S>> contest(
      session, {"point-location",
                scalar_name<S>,
                name,
                family.note,
                std::string_view(name) != "ordinary",
                [&](Random& random) { return family.draw(random); },
                [](const Case<S>& c) -> Truth { return truth_of(oracle::location(c.point, *c.ring)); },
                [](const Case<S>& c) {
                  return text("point", c.point, "in the polygon of the family, of edges", c.ring->size());
                },
                {},
                1 << 13});  // the oracle looks at all edges
  const auto lines = slab_map::make_naive_slabs(ring, Abscissa::line),
             interpolated = slab_map::make_naive_slabs(ring, Abscissa::interpolated);
  contest.enter("slabs, interpolated", [&](const Case<S>& c) { return slab_map::slabs_naive(c.point, interpolated); })
      .standard();
  contest.enter("slabs, x = m y + k", [&](const Case<S>& c) { return slab_map::slabs_naive(c.point, lines); });
  const SlabMap slabs = make_slab_map(ring);
  const TrapezoidMap trapezoids = make_trapezoid_map(ring);
  const PolygonGrid grid = make_polygon_grid(ring);
  enter_map(contest, "slabs, exact", slabs);
  enter_map(contest, "trapezoids, exact", trapezoids);
  enter_map(contest, "grid, exact", grid);
#ifdef ISECT_PEERS
  peers::point_location<S>(contest, ring);
#endif
  contest.run();
}

/// One way to prepare, at all sizes of one outline.
class Preparation {
 public:
  Preparation(Session& session, Outline outline, const std::string& method, const std::string& library = "isect")
      : session_(session),
        build_(name(outline), method, "build", library),
        query_(name(outline), method, "query", library) {}

  /// Times prepare(ring) and then ask(prepared, point).
  template <class Prepare, class Ask>
  void add(const Ring<double, 2>& ring, const Ring<double, 2>& points, const Prepare& prepare, const Ask& ask) {
    const double n = static_cast<double>(ring.size());
    const auto prepared = timed(session_, [&] { return prepare(ring); });
    build_.add(n, prepared.ns);
    query_.add(n, least_each(session_, points, [&](const auto& p) { return ask(prepared.result, p); }));
  }
  void report() { build_.report(session_), query_.report(session_); }

 private:
  static std::string name(Outline outline) {
    return outline == Outline::smooth ? "point location, smooth" : "point location, spiky";
  }

  Session& session_;
  Grown build_, query_;
};

void grow(Session& session, Outline outline) {
  const auto in = [](const auto& map, const Point<double, 2>& p) { return locate(p, map) != Location::out; };
  Preparation slabs(session, outline, "slabs"), trapezoids(session, outline, "trapezoids"),
      grid(session, outline, "grid");
  for (const int n : sizes(session, 1000)) {
    const Ring<double, 2> ring = outline_of(outline, n);
    const Ring<double, 2> points = points_in_square(outline == Outline::spiky && n > 10'000 ? 8192 : 65536);
    if (n <= (outline == Outline::smooth ? 10'000 : 1000))
      slabs.add(
          ring, points, [](const auto& r) { return make_slab_map(r); }, in);
    trapezoids.add(
        ring, points, [](const auto& r) { return make_trapezoid_map(r); }, in);
    grid.add(
        ring, points, [](const auto& r) { return make_polygon_grid(r); }, in);
  }
  slabs.report(), trapezoids.report(), grid.report();
#ifdef ISECT_PEERS
  peers::grow_point_location(session, outline, [&](const char* library, const char* method) {
    return Preparation(session, outline, method, library);
  });
#endif
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "point in a smooth polygon, preprocessed, 10^6",
               .kind = Target::growth,
               .test = "point location, smooth",
               .ours = "grid",
               .theirs = "GEOS",
               .n = 1e6,
               .unit = "query",
               .at_most = 0.15});
  session.aim({.work = "point in a spiky polygon, preprocessed, 10^6",
               .kind = Target::growth,
               .test = "point location, spiky",
               .ours = "trapezoids",
               .theirs = "CGAL",
               .n = 1e6,
               .unit = "query",
               .at_most = 0.35});
  session.aim({.work = "preprocessing a smooth polygon, 10^6",
               .kind = Target::growth,
               .test = "point location, smooth",
               .ours = "grid",
               .theirs = "GEOS",
               .n = 1e6,
               .unit = "build",
               .at_most = 1.5});
  session.aim({.work = "trapezoids of a smooth polygon, built, 10^6",
               .kind = Target::growth,
               .test = "point location, smooth",
               .ours = "trapezoids",
               .theirs = "GEOS",
               .n = 1e6,
               .unit = "build",
               .at_most = 3,
               .limit =
                   "GEOS sorts the edges' intervals of y. Here a third of the time walks through questions to where an "
                   "edge begins, a quarter cuts trapezoids, and a sixth makes sure that no two edges cross."});
  for (const char* name : {"ordinary", "near-edge", "on-vertex", "near-horizontal", "near-vertical", "coincident"})
    compete<double>(session, name, 256);
  for (const char* name : {"ordinary", "near-edge", "coincident"}) compete<float>(session, name, 256);
  session.progress("point-location, growth");
  for (const Outline outline : {Outline::smooth, Outline::spiky}) grow(session, outline);
}

}  // namespace isect::bench::point_location_suite
