// Ray against axis-aligned box: where the ray enters, by the usual slabs, the exact call, and the conservative test
// of hierarchies, which may say yes to a near miss but never no to a hit.

#include <isect/ray_aabb.h>

#include <isect/methods/ray_aabb.h>
#include "bench/pair_contest.h"
#include "bench/ray_aabb/families.h"
#include "bench/ray_aabb/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/ray_aabb/peers.h"
#endif

namespace isect::bench::ray_aabb_suite {
namespace {

template <class S>
using Case = RayAndBox<S>;

/// t is a difference over d: a relative error of the input moves it by the larger of the two terms, over d.
template <class S>
Truth truth(const Case<S>& c) {
  const auto ends = oracle::ray_aabb(c.a, c.b);
  if (!ends) return {};
  const oracle::Real t = oracle::real(ends->first);
  const double along = std::abs(t.nearest) * c.a.direction.template cast<double>().stableNorm();
  return {1, t, 1 + 2 * static_cast<double>(c.a.origin.stableNorm()) / along};
}

/// Where the ray enters.
template <class S>
std::optional<S> entry(const std::optional<Interval<S>>& part) {
  return part ? std::optional<S>(part->lo) : std::nullopt;
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = ray_aabb;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("ray-aabb", drawn, truth<S>));
  contest.enter("slabs, 1/d, min, max", [](const Case<S>& c) { return entry(methods::by_min_max(c.a, c.b)); })
      .standard();
  contest.enter("slabs, /d", [](const Case<S>& c) { return entry(methods::slabs_naive(c.a, c.b)); });
  contest.enter("slabs, 1/d, sign", [](const Case<S>& c) { return entry(methods::by_sign(c.a, c.b)); });
  contest.enter("slabs, 1/d, fmin, fmax", [](const Case<S>& c) { return entry(methods::by_fmin_fmax(c.a, c.b)); });
  contest.enter("conservative", [](const Case<S>& c) { return may_intersect(c.a, c.b); });
  contest.enter("exact", [](const Case<S>& c) { return entry(intersect(c.a, c.b)); })
      .exact()
      .fallback([](const Case<S>& c) { return fell_back([&](const auto& trace) { intersect(c.a, c.b, trace); }); });
#ifdef ISECT_PEERS
  peers::ray_aabb<S>(contest, drawn.name);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("ray-aabb");
  for (const auto& drawn : ray_aabb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_aabb_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::ray_aabb_suite
