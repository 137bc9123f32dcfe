// Triangle against axis-aligned box: whether they meet, by the classical separating axes and exactly.

#include <isect/triangle_aabb.h>

#include <isect/methods/triangle_aabb.h>
#include "bench/pair_contest.h"
#include "bench/session.h"
#include "bench/triangle_aabb/families.h"
#include "bench/triangle_aabb/oracle.h"
#ifdef ISECT_PEERS
#include "bench/triangle_aabb/peers.h"
#endif

namespace isect::bench::triangle_aabb_suite {
namespace {

template <class S>
using Case = TriangleAndBox<S>;

template <class S>
Truth truth(const Case<S>& c) {
  if (!finite(c.a) || !finite(c.b) || empty(c.b)) return {};
  return {!oracle::triangle_aabb::common(c.a, c.b).empty(), {}};
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = triangle_aabb;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("triangle-aabb", drawn, truth<S>));
  contest.enter("Akenine-Möller", [](const Case<S>& c) { return methods::akenine_moller(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("Akenine-Möller in double",
                  [](const Case<S>& c) { return methods::akenine_moller(cast<double>(c.a), cast<double>(c.b)); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::triangle_aabb<S>(contest, drawn.name);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "triangle-aabb",
               .test = "triangle-aabb",
               .theirs = "naive",
               .at_most = 0.5,
               .limit = "A quarter of the time is the margin, and which of 13 axes it leaves open."});
  session.aim_on_hard_input("triangle-aabb");
  for (const auto& drawn : triangle_aabb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : triangle_aabb_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::triangle_aabb_suite
