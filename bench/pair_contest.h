#pragma once
// What the suites of two shapes share: how a family is described and how the exact call enters.

#include "bench/full_precision.h"
#include "bench/named_draw.h"

namespace isect::bench {

/// Hard families have fewer cases, since their exact answers are slow. A branch predictor may learn some of 8,192
/// cases, so that the quickest methods look quicker than on ordinary ones. `most` bounds the cases of every family.
template <class S, class Case>
CaseFamily<Case> family_of(const char* test, const NamedDraw<Case>& drawn, Truth (*truth)(const Case&),
                           long most = 1 << 16) {
  CaseFamily<Case> family = {test,         scalar_name<S>, drawn.name, drawn.note,
                             drawn.hard(), drawn.draw,     truth,      [](const Case& c) { return full_precision(c); }};
  family.most_cases = drawn.hard() ? std::min(most, 1L << 13) : most;
  return family;
}

/// Enters intersects(a, b), which ADL finds, as the exact method.
template <class S, class Case>
void enter_exact(Contest<S, Case>& contest) {
  contest.enter("exact", [](const Case& c) { return intersects(c.a, c.b); }).exact().fallback([](const Case& c) {
    return fell_back([&](const auto& trace) { intersects(c.a, c.b, trace); });
  });
}

/// Enters relate(a, b) as the exact method.
template <class S, class Case>
void enter_exact_relation(Contest<S, Case>& contest) {
  contest.enter("exact", [](const Case& c) { return static_cast<int>(relate(c.a, c.b)); })
      .exact()
      .fallback([](const Case& c) { return fell_back([&](const auto& trace) { relate(c.a, c.b, trace); }); });
}

}  // namespace isect::bench
