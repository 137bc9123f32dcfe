#pragma once
// What the suites of a cylinder and of a cone against half-spaces share. The half-spaces are made of the k-DOP in the
// call that is timed.

#include <isect/half_spaces.h>
#include "bench/cylinder_half_spaces/families.h"
#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/pair_contest.h"
#include "bench/session.h"

namespace isect::bench::solid_and_kdop {

template <class S, template <class> class Solid>
void compete(Session& session, const char* test) {
  using Case = SolidAndKdop<S, Solid<S>>;
  for (const NamedDraw<Case>& drawn : solid_and_kdop_draws<S, Solid>) {
    const auto truth = [](const Case& c) -> Truth { return {oracle::relation(c.a, c.b) != Relation::disjoint, {}}; };
    Contest<S, Case> contest(session, family_of<S, Case>(test, drawn, truth, 1 << 10));  // rationals are slow
    contest.enter("exact", [](const Case& c) { return intersects(c.a, half_spaces_of(c.b)); })
        .exact()
        .fallback([](const Case& c) {
          return fell_back([&](const auto& trace) { intersects(c.a, half_spaces_of(c.b), trace); });
        });
    contest.run();
  }
}

template <template <class> class Solid>
void measure(Session& session, const char* test) {
  session.aim({.work = std::string(test) + ": wrong verdicts", .kind = Target::wrong, .test = test, .at_most = 0});
  compete<double, Solid>(session, test);
  compete<float, Solid>(session, test);
}

}  // namespace isect::bench::solid_and_kdop
