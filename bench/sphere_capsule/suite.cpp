// Sphere against capsule: whether they meet, by the nearest point, by Pythagoras, and exactly.

#include <isect/sphere_capsule.h>

#include <isect/methods/sphere_capsule.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/sphere_capsule/families.h"
#include "bench/sphere_capsule/oracle.h"
#ifdef ISECT_PEERS
#include "bench/sphere_capsule/peers.h"
#endif

namespace isect::bench::sphere_capsule_suite {
namespace {

template <class S>
using Case = BallAndCapsule<S, 3>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = sphere_capsule;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("sphere-capsule", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("clamp", [](const Case<S>& c) { return methods::clamped(c.a, c.b); }).standard();
  contest.enter("Pythagoras", [](const Case<S>& c) { return methods::by_pythagoras(c.a, c.b); });
  if constexpr (std::is_same_v<S, float>)
    contest.enter("clamp in double",
                  [](const Case<S>& c) { return methods::clamped(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::sphere_capsule<S>(contest);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("sphere-capsule",
                            "Integers touch where a polynomial of degree 4 is 0: 2,200 instructions. The naive test "
                            "takes less than half of its ordinary time there, as its branches are foreseen.");
  session.aim(
      {.work = "sphere-capsule: wrong verdicts", .kind = Target::wrong, .test = "sphere-capsule", .at_most = 0});
  for (const auto& drawn : sphere_capsule_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : sphere_capsule_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::sphere_capsule_suite
