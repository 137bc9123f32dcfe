#pragma once
// What the suites of two shapes share: how a family is told and how the exact call enters.

#include "bench/full_precision.h"
#include "bench/named_draw.h"

namespace isect::bench {

/// Hard families do with fewer cases, for their exact answers are slow; of 8,192 a branch predictor may learn some,
/// so that the quickest methods look quicker than on the ordinary ones. `most` bounds all.
template <class S, class Case>
CaseFamily<Case> family_of(const char* test, const NamedDraw<Case>& drawn, Truth (*truth)(const Case&),
                           long most = 1 << 16) {
  CaseFamily<Case> family = {test,         scalar_name<S>, drawn.name, drawn.note,
                             drawn.hard(), drawn.draw,     truth,      [](const Case& c) { return full_precision(c); }};
  family.most_cases = drawn.hard() ? std::min(most, 1L << 13) : most;
  return family;
}

/// intersects(a, b), as ADL finds it.
template <class S, class Case>
void enter_exact(Contest<S, Case>& contest) {
  contest.enter("exact", [](const Case& c) { return intersects(c.a, c.b); }).exact().fallback([](const Case& c) {
    return fell_back([&](const auto& trace) { intersects(c.a, c.b, trace); });
  });
}

/// relate(a, b).
template <class S, class Case>
void enter_exact_relation(Contest<S, Case>& contest) {
  contest.enter("exact", [](const Case& c) { return static_cast<int>(relate(c.a, c.b)); })
      .exact()
      .fallback([](const Case& c) { return fell_back([&](const auto& trace) { relate(c.a, c.b, trace); }); });
}

}  // namespace isect::bench
