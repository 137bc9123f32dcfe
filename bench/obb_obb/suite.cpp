// Oriented box against oriented box: separating axes with the customary epsilon, with a small one, with none, and
// exactly.

#include <isect/obb_obb.h>

#include <isect/methods/obb_obb.h>
#include "bench/obb_obb/families.h"
#include "bench/obb_obb/oracle.h"
#include "bench/pair_contest.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/obb_obb/peers.h"
#endif

namespace isect::bench::obb_obb_suite {
namespace {

template <class S>
using Case = OrientedBoxes<S>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = obb_obb;
  CaseFamily<Case<S>> family = family_of<S, Case<S>>(
      "obb-obb", drawn,
      [](const Case<S>& c) -> Truth {
        return {oracle::obb::meet_by_projection(c.a, c.b), {}};
      },
      1 << 15);
  Contest<S, Case<S>> contest(session, family);
  contest.enter("epsilon 1e-6", [](const Case<S>& c) { return methods::gottschalk(c.a, c.b, S(1e-6)); }).standard();
  contest.enter("epsilon 4 u",
                [](const Case<S>& c) { return methods::gottschalk(c.a, c.b, 2 * std::numeric_limits<S>::epsilon()); });
  contest.enter("no epsilon", [](const Case<S>& c) { return methods::gottschalk(c.a, c.b, S(0)); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::obb_obb<S>(contest);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "obb-obb",
               .test = "obb-obb",
               .theirs = "Bullet",
               .at_most = 1,
               .limit = "A fifth of the time finds how far the axes are from orthonormal, which Bullet takes for "
                        "granted: without that it would be 1.04 × Bullet, in double."});
  session.aim({.work = "obb-obb: wrong verdicts", .kind = Target::wrong, .test = "obb-obb", .at_most = 0});
  session.aim_on_hard_input("obb-obb");
  for (const auto& drawn : obb_obb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : obb_obb_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::obb_obb_suite
