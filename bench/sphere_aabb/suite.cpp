// Sphere against axis-aligned box: whether they meet.

#include <isect/sphere_aabb.h>

#include <isect/methods/sphere_aabb.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/sphere_aabb/families.h"
#include "bench/sphere_aabb/oracle.h"
#ifdef ISECT_PEERS
#include "bench/sphere_aabb/peers.h"
#endif

namespace isect::bench::sphere_aabb_suite {
namespace {

template <class S>
using Case = BallAndBox<S, 3>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = sphere_aabb;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("sphere-aabb", drawn, [](const Case<S>& c) -> Truth {
                                return {oracle::relation(c.a, c.b) != Relation::disjoint, {}};
                              }));
  contest.enter("if, else (<)", [](const Case<S>& c) { return methods::accumulate_naive(c.a, c.b); }).standard();
  contest.enter("rejections", [](const Case<S>& c) { return methods::with_rejections(c.a, c.b); });
  contest.enter("clamp", [](const Case<S>& c) { return methods::clamped(c.a, c.b); });
  if constexpr (std::is_same_v<S, float>)
    contest.enter("clamp in double",
                  [](const Case<S>& c) { return methods::clamped(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::sphere_aabb<S>(contest, drawn.name);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "sphere-aabb",
       .test = "sphere-aabb",
       .theirs = "CGAL",
       .at_most = 0.15,
       .limit =
           "The clamp alone takes 0.07 × CGAL. A third more than that goes into the proof that rounding can't have "
           "decided, and that neither ball nor box is empty or infinite."});
  session.aim_on_hard_input("sphere-aabb");
  for (const auto& drawn : sphere_aabb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : sphere_aabb_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::sphere_aabb_suite
