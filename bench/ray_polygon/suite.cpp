// Ray against polygon in space: the note's projection, a fan of triangles, and the exact call.

#include <isect/ray_polygon.h>

#include <isect/methods/ray_polygon.h>
#include "bench/pair_contest.h"
#include "bench/ray_polygon/families.h"
#include "bench/ray_polygon/oracle.h"
#include "bench/session.h"

namespace isect::bench::ray_polygon_suite {
namespace {

template <class S>
using Case = RayAndRing<S>;

/// t = n.(p - o) / n.d: each sum magnifies an error by the sizes of its terms over its own; the normal's own error,
/// which is that of the outline, comes on top.
template <class S>
Truth truth(const Case<S>& c) {
  const oracle::RayPolygon meeting = oracle::ray_polygon(c.a, c.b);
  if (!meeting.hit) return {};
  const oracle::Real t = oracle::real(meeting.t);
  const Point<double, 3> first = c.b[0].template cast<double>();
  Vector<double, 3> n = Vector<double, 3>::Zero();
  for (std::size_t i = 1; i + 1 < c.b.size(); ++i) {
    const Vector<double, 3> p = c.b[i].template cast<double>() - first, q = c.b[i + 1].template cast<double>() - first;
    n += p.cross(q);
  }
  const Vector<double, 3> d = c.a.direction.template cast<double>();
  const double along = std::abs(n.dot(d)), sizes = n.norm() * (first.norm() + c.a.origin.norm());
  return {1, t, sizes / (std::abs(t.nearest) * along) + n.norm() * d.norm() / along};
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = ray_polygon;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("ray-polygon", drawn, truth<S>, 1 << 15));
  contest.enter("projected", [](const Case<S>& c) { return methods::projected(c.a, c.b); }).standard();
  contest.enter("fan of triangles", [](const Case<S>& c) { return methods::fan(c.a, c.b); });
  contest.enter("exact", [](const Case<S>& c) { return intersect(c.a, c.b).t; }).exact().fallback([](const Case<S>& c) {
    return fell_back([&](const auto& trace) { intersect(c.a, c.b, FillRule::even_odd, trace); });
  });
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "ray-polygon with t",
               .test = "ray-polygon",
               .theirs = "naive",
               .at_most = 1.5,
               .limit = "Compiled for this machine the naive method gains a tenth. The exact call gains less: in any "
                        "build it finds t by fused products where the machine has them."});
  session.aim_on_hard_input("ray-polygon");
  for (const auto& drawn : ray_polygon_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_polygon_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::ray_polygon_suite
