// Interval against interval: nothing but comparisons, and still not all forms are right.

#include <isect/interval_interval.h>

#include <isect/methods/interval_interval.h>
#include "bench/aabb_aabb/families.h"
#include "bench/aabb_aabb/oracle.h"
#include "bench/pair_contest.h"
#include "bench/session.h"

namespace isect::bench::interval_interval_suite {
namespace {

/// [inf, inf] holds no number, and neither does [-inf, -inf]; other intervals are compared by points.
template <class S>
Truth truth(const Intervals<S>& c) {
  for (const Interval<S>& x : {c.a, c.b})
    if (std::isnan(x.lo) || std::isnan(x.hi) || x.lo == infinite<S>.hi || x.hi == infinite<S>.lo) return {};
  const auto flat = [](const Interval<S>& x) { return Aabb<S, 1>{Point<S, 1>(x.lo), Point<S, 1>(x.hi)}; };
  return {oracle::by_points(flat(c.a), flat(c.b)) != Relation::disjoint, {}};
}

template <class S>
void compete(Session& session, const NamedDraw<Intervals<S>>& drawn) {
  using Case = Intervals<S>;
  namespace methods = interval_interval;
  Contest<S, Case> contest(session, family_of<S, Case>("interval-interval", drawn, truth<S>));
  contest.enter("!(a.lo > b.hi or b.lo > a.hi)", [](const Case& c) { return methods::ends(c.a, c.b); }).standard();
  contest.enter("min, max", [](const Case& c) { return methods::min_max(c.a, c.b); });
  contest.enter("middles", [](const Case& c) { return methods::by_middles(c.a, c.b); });
  contest.enter("exact", [](const Case& c) { return intersects(c.a, c.b); }).exact();
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("interval-interval");
  for (const auto& drawn : interval_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : interval_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::interval_interval_suite
