// Hulls and smallest spheres of n points: time against n.

#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/suites/suites.h"
#include "core/convex_hull.h"
#include "core/convex_hull_3d.h"
#include "core/fit_tight.h"
#ifdef ISECT_PEERS
#include "bench/suites/hulls_peers.h"
#endif

namespace isect::bench {
namespace {

using Points = std::vector<Point<double, 3>>;

/// One method at all sizes: make(n) makes what run(it) is timed on.
template <class Make, class Run>
void grow(Session& session, const char* test, const char* method, const Make& make, const Run& run) {
  session.progress(std::string(test) + ", " + method);
  Grown grown(test, method, "set of points");
  for (const int n : sizes(session, 1000)) {
    const auto points = make(n);
    grown.add(n, least_time(session, [&] { return run(points); }));
  }
  grown.report(session);
}

Points in_ball(int n) { return cloud(n, true); }
Points on_sphere(int n) { return cloud(n, false); }
Ring<double, 2> in_disc(int n) { return disc(n, false); }
Ring<double, 2> on_circle(int n) { return disc(n, true); }

}  // namespace

void measure_hulls(Session& session) {
  const auto hull2 = [](const Ring<double, 2>& points) { return convex_hull(points); };
  const auto hull3 = [](const Points& points) { return convex_hull(points); };
  grow(session, "hull 2D, disc", "exact", in_disc, hull2);
  grow(session, "hull 2D, circle", "exact", on_circle, hull2);
  grow(session, "hull 3D", "exact", in_ball, hull3);
  grow(session, "hull 3D, sphere", "exact", on_sphere, hull3);
#ifdef ISECT_PEERS
  peers::hulls(session);
#endif
}

void measure_smallest_sphere(Session& session) {
  grow(session, "smallest sphere", "exact", in_ball, [](const Points& p) { return fit_sphere_smallest(p); });
  grow(session, "smallest sphere", "Ritter", in_ball, [](const Points& p) { return fit_sphere_ritter(p); });
#ifdef ISECT_PEERS
  peers::smallest_sphere(session);
#endif
}

}  // namespace isect::bench
