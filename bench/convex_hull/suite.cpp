// Hulls of n points: time against n.

#include <isect/convex_hull.h>
#include <isect/convex_hull_3d.h>
#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/convex_hull/peers.h"
#endif

namespace isect::bench::convex_hull_suite {
namespace {

using Points = std::vector<Point<double, 3>>;

constexpr const char* unit = "set of points";

Points in_ball(int n) { return cloud(n, true); }
Points on_sphere(int n) { return cloud(n, false); }
Ring<double, 2> in_disc(int n) { return disc(n, false); }
Ring<double, 2> on_circle(int n) { return disc(n, true); }

}  // namespace

void measure(Session& session) {
  session.aim({.work = "hull of 10^6 points in a disc",
               .kind = Target::growth,
               .test = "hull 2D, disc",
               .theirs = "CGAL",
               .n = 1e6,
               .at_most = 0.2});
  session.aim({.work = "hull of 10^6 points on a circle",
               .kind = Target::growth,
               .test = "hull 2D, circle",
               .theirs = "CGAL",
               .n = 1e6,
               .at_most = 1.1});
  session.aim({.work = "hull of 10^6 points in space",
               .kind = Target::growth,
               .test = "hull 3D",
               .theirs = "qhull",
               .n = 1e6,
               .at_most = 1});
  const auto hull2 = [](const Ring<double, 2>& points) { return convex_hull(points); };
  const auto hull3 = [](const Points& points) { return convex_hull(points); };
  grow(session, "hull 2D, disc", "exact", unit, in_disc, hull2);
  grow(session, "hull 2D, circle", "exact", unit, on_circle, hull2);
  grow(session, "hull 3D", "exact", unit, in_ball, hull3);
  grow(session, "hull 3D, sphere", "exact", unit, on_sphere, hull3);
#ifdef ISECT_PEERS
  peers::convex_hull(session);
#endif
}

}  // namespace isect::bench::convex_hull_suite
