// Sphere against sphere: whether they meet, and which of the six relations holds.

#include <isect/sphere_sphere.h>

#include <isect/methods/sphere_sphere.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/sphere_sphere/families.h"
#include "bench/sphere_sphere/oracle.h"
#ifdef ISECT_PEERS
#include "bench/sphere_sphere/peers.h"
#endif

namespace isect::bench::sphere_sphere_suite {
namespace {

template <class S>
using Case = Balls<S, 3>;

template <class S>
void meet(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = sphere_sphere;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("sphere-sphere", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("squares (<)", [](const Case<S>& c) { return methods::squared_distance_naive(c.a, c.b); }).standard();
  contest.enter("squares", [](const Case<S>& c) { return methods::closed_squared_distance(c.a, c.b); });
  contest.enter("root", [](const Case<S>& c) { return methods::by_distance(c.a, c.b); });
  contest.enter("hypot", [](const Case<S>& c) { return methods::by_hypot(c.a, c.b); });
  if constexpr (std::is_same_v<S, float>)
    contest.enter("squares in double", [](const Case<S>& c) {
      return methods::closed_squared_distance(cast<double>(c.a), cast<double>(c.b));
    });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::sphere_sphere<S>(contest, drawn.name);
#endif
  contest.run();
}

template <class S>
void lie(Session& session, const NamedDraw<Case<S>>& drawn) {
  Contest<S, Case<S>> contest(session,
                              family_of<S, Case<S>>("sphere-sphere relation", drawn, [](const Case<S>& c) -> Truth {
                                return {static_cast<int>(oracle::relation(c.a, c.b)), {}};
                              }));
  contest.enter("squares", [](const Case<S>& c) { return static_cast<int>(sphere_sphere::squared_relation(c.a, c.b)); })
      .standard();
  enter_exact_relation(contest);
  contest.run();
}

template <class S>
void measure_all(Session& session) {
  for (const auto& drawn : sphere_sphere_draws<S>)
    if (drawn.name != std::string_view("inner-touch") && drawn.name != std::string_view("concentric"))
      meet<S>(session, drawn);
  for (const auto& drawn : sphere_sphere_draws<S>) lie<S>(session, drawn);
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "sphere-sphere",
               .test = "sphere-sphere",
               .theirs = "naive",
               .at_most = 1.2,
               .limit =
                   "The naive test is 11 operations. That rounding can't have decided takes six more, that no ball "
                   "is empty two."});
  session.aim_on_hard_input(
      "sphere-sphere",
      "The naive test is 11 operations. Of tenths that touch, all need two doubles and some "
      "three: 490 instructions. Compiled for this machine, the naive test takes many floats at once.",
      "An ordinary call is some 20 operations. What two doubles must decide takes more than ten times that "
      "by itself.");
  session.aim_on_hard_input("sphere-sphere relation",
                            "The naive relation is as short as the naive test. Of tenths that touch, all need two "
                            "doubles and some three.");
  measure_all<double>(session);
  measure_all<float>(session);
}

}  // namespace isect::bench::sphere_sphere_suite
