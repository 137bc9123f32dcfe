// Sphere against cone: whether they meet, by the distance from half a triangle, and exactly.

#include <isect/sphere_cone.h>

#include <isect/methods/sphere_cone.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"

namespace isect::bench::sphere_cone_suite {
namespace {

template <class S>
using Case = BallAndSolid<S, Cone<S>>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = sphere_cone;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("sphere-cone", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("by_profile", [](const Case<S>& c) { return methods::by_profile(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("by_profile in double",
                  [](const Case<S>& c) { return methods::by_profile(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "sphere-cone: wrong verdicts", .kind = Target::wrong, .test = "sphere-cone", .at_most = 0});
  for (const auto& drawn : sphere_cone_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : sphere_cone_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::sphere_cone_suite
