// Sphere against cylinder: whether they meet, by its nearest point, by both coordinates, and exactly.

#include <isect/sphere_cylinder.h>

#include <isect/methods/sphere_cylinder.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"

namespace isect::bench::sphere_cylinder_suite {
namespace {

template <class S>
using Case = BallAndSolid<S, Cylinder<S>>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = sphere_cylinder;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("sphere-cylinder", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("clamped", [](const Case<S>& c) { return methods::clamped(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("clamped in double",
                  [](const Case<S>& c) { return methods::clamped(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "sphere-cylinder: wrong verdicts", .kind = Target::wrong, .test = "sphere-cylinder", .at_most = 0});
  for (const auto& drawn : sphere_cylinder_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : sphere_cylinder_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::sphere_cylinder_suite
