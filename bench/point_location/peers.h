#pragma once
// Point location by GEOS and CGAL.

#include "bench/growth_shapes.h"
#include "bench/peer.h"
#include "bench/point_polygon/families.h"
#if defined ISECT_HAS_GEOS && defined ISECT_HAS_CGAL
#include "bench/point_location/locators.h"
#endif

namespace isect::bench::peers {

template <class S>
void point_location([[maybe_unused]] Contest<S, PolygonCase<S>>& contest, [[maybe_unused]] const Ring<S, 2>& ring) {
#if defined ISECT_HAS_GEOS && defined ISECT_HAS_CGAL
  Ring<double, 2> wide;
  for (const Point<S, 2>& v : ring) wide.push_back(v.template cast<double>());
  const auto converted = [](const PolygonCase<S>& c) { return Point<double, 2>(c.point.template cast<double>()); };
  const auto geos = std::make_shared<Geos>(make_geos(wide));
  enter(contest, "GEOS", "IndexedPointInAreaLocator", converted,
        [geos](const Point<double, 2>& p) { return geos_covers(*geos, p); });
  const auto cgal = std::make_shared<std::unique_ptr<Triangulation>>(make_cgal(wide));
  enter(contest, "CGAL", "CDT hierarchy, EPICK", converted, [cgal](const Point<double, 2>& p) {
    return cgal_covers(*cgal, p);
  }).exact();
#endif
}

/// prepared_by(library, method) -> a Preparation of the suite.
template <class PreparedBy>
void grow_point_location([[maybe_unused]] const Session& session, [[maybe_unused]] Outline outline,
                         [[maybe_unused]] const PreparedBy& prepared_by) {
#if defined ISECT_HAS_GEOS && defined ISECT_HAS_CGAL
  auto geos = prepared_by("GEOS", "indexed"), cgal = prepared_by("CGAL", "CDT hierarchy");
  for (const int n : sizes(session, 1000)) {
    const Ring<double, 2> ring = outline_of(outline, n);
    const bool slow = outline == Outline::spiky;
    geos.add(ring, points_in_square(slow ? std::max(256, 10'000'000 / n) : 65536), make_geos, geos_covers);
    cgal.add(ring, points_in_square(slow && n > 10'000 ? 4096 : 65536), make_cgal, cgal_covers);
  }
  geos.report(), cgal.report();
#endif
}

}  // namespace isect::bench::peers
