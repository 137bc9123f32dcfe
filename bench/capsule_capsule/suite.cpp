// Capsule against capsule: whether they meet, by the nearest points as Ericson and Sunday find them, and exactly.

#include <isect/capsule_capsule.h>

#include <isect/methods/capsule_capsule.h>
#include "bench/capsule_capsule/families.h"
#include "bench/capsule_capsule/oracle.h"
#include "bench/pair_contest.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/capsule_capsule/peers.h"
#endif

namespace isect::bench::capsule_capsule_suite {
namespace {

template <class S>
using Case = Capsules<S, 3>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = capsule_capsule;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("capsule-capsule", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("Ericson", [](const Case<S>& c) { return methods::clamped(c.a, c.b); }).standard();
  contest.enter("Sunday, 1e-8", [](const Case<S>& c) { return methods::sunday(c.a, c.b, S(1e-8)); });
  if constexpr (std::is_same_v<S, float>)
    contest.enter("Ericson in double",
                  [](const Case<S>& c) { return methods::clamped(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::capsule_capsule<S>(contest);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("capsule-capsule",
                            "Integers touch where a polynomial of degree 6 is 0, and it takes up to 255 bits to know: "
                            "7,200 instructions, with no function that takes more than a seventh of them.");
  session.aim(
      {.work = "capsule-capsule: wrong verdicts", .kind = Target::wrong, .test = "capsule-capsule", .at_most = 0});
  for (const auto& drawn : capsule_capsule_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : capsule_capsule_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::capsule_capsule_suite
