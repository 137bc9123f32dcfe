// Smallest spheres of n points: time against n.

#include <isect/fit_tight.h>

#include "bench/growth.h"
#include "bench/growth_shapes.h"
#ifdef ISECT_PEERS
#include "bench/smallest_sphere/peers.h"
#endif

namespace isect::bench::smallest_sphere_suite {
namespace {

using Points = std::vector<Point<double, 3>>;

}  // namespace

void measure(Session& session) {
  session.aim({.work = "smallest sphere around 10^6 points",
               .kind = Target::growth,
               .test = "smallest sphere",
               .theirs = "CGAL",
               .n = 1e6,
               .at_most = 1,
               .limit = "A third of the time brings coordinates to a scale at which no square overflows, and back."});
  const auto in_ball = [](int n) { return cloud(n, true); };
  constexpr const char *test = "smallest sphere", *unit = "set of points";
  grow(session, test, "exact", unit, in_ball, [](const Points& p) { return fit_sphere_smallest(p); });
  grow(session, test, "Ritter", unit, in_ball, [](const Points& p) { return fit_sphere_ritter(p); });
#ifdef ISECT_PEERS
  peers::smallest_sphere(session);
#endif
}

}  // namespace isect::bench::smallest_sphere_suite
