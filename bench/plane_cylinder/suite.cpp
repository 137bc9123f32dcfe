// Plane against cylinder: whether they meet, by the heights of its lowest and its highest point, and exactly.

#include <isect/plane_cylinder.h>

#include <isect/methods/plane_cylinder.h>
#include "bench/pair_contest.h"
#include "bench/plane_cylinder/families.h"
#include "bench/plane_cylinder/oracle.h"
#include "bench/session.h"

namespace isect::bench::plane_cylinder_suite {
namespace {

template <class S>
using Case = PlaneAndSolid<S, Cylinder<S>>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = plane_cylinder;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("plane-cylinder", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("by_heights", [](const Case<S>& c) { return methods::by_heights(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("by_heights in double",
                  [](const Case<S>& c) { return methods::by_heights(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "plane-cylinder: wrong verdicts", .kind = Target::wrong, .test = "plane-cylinder", .at_most = 0});
  for (const auto& drawn : plane_cylinder_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : plane_cylinder_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::plane_cylinder_suite
