// The orientation of three points in the plane: one determinant, written in every usual way.

#include <isect/orient.h>

#include <isect/methods/orient.h>
#include "bench/contest.h"
#include "bench/orient2d/families.h"
#include "bench/orient2d/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/orient2d/peers.h"
#endif

namespace isect::bench::orient2d_suite {
namespace {

template <class S>
using Case = OrientCase<S>;

template <class S>
int sign(S area2) {
  return (area2 > S(0)) - (area2 < S(0));
}

template <class S>
int extended(const Case<S>& t) {
  using L = long double;
  return sign(
      orient::pivoted<orient::Corner::c, L>(t.a.template cast<L>(), t.b.template cast<L>(), t.c.template cast<L>()));
}

template <class S, class Trace = NoTrace>
int exact(const Case<S>& t, Trace&& trace = {}) {
  return orient2d(t.a.template cast<double>(), t.b.template cast<double>(), t.c.template cast<double>(), trace);
}

template <class S>
void compete(Session& session, const NamedDraw<OrientCase<S>>& family) {
  using orient::Corner;
  Contest<S, Case<S>> contest(
      session, {"orient2d", scalar_name<S>, family.name, family.note, family.hard(), family.draw,
                [](const Case<S>& t) -> Truth { return truth_of_sign(oracle::orientation(t.a, t.b, t.c)); },
                [](const Case<S>& t) { return text("a", t.a, "b", t.b, "c", t.c); }});
  contest.enter("pivot c", [](const Case<S>& t) { return sign(orient::pivoted<Corner::c>(t.a, t.b, t.c)); }).standard();
  contest.enter("pivot b", [](const Case<S>& t) { return sign(orient::pivoted<Corner::b>(t.a, t.b, t.c)); });
  contest.enter("pivot a", [](const Case<S>& t) { return sign(orient::pivoted<Corner::a>(t.a, t.b, t.c)); });
  contest.enter("expanded", [](const Case<S>& t) { return sign(orient::expanded(t.a, t.b, t.c)); });
  contest.enter("Kahan, std::fma", [](const Case<S>& t) { return sign(orient::fused(t.a, t.b, t.c)); });
  contest.enter("long double", extended<S>);
  contest.enter("exact", [](const Case<S>& t) { return exact(t); }).exact().fallback([](const Case<S>& t) {
    return fell_back([&](const auto& trace) { exact(t, trace); });
  });
#ifdef ISECT_PEERS
  peers::orient<S>(contest);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("orient2d", {},
                            "An ordinary call is 17 operations. Two doubles take some seven times as long, and the "
                            "grid that tells that points are on one line half as long as they.");
  for (const auto& family : orient2d_draws<double>) compete<double>(session, family);
  for (const auto& family : orient2d_draws<float>) compete<float>(session, family);
}

}  // namespace isect::bench::orient2d_suite
