#pragma once
// How another library enters a contest: its own shapes are made before the clock starts.

#include <memory>
#include <vector>

#include "bench/contest.h"

namespace isect::bench::peers {

/// convert(case) -> the library's shapes, ask(shapes) -> bool, int, Location, optional or Said.
template <class S, class Case, class Convert, class Ask>
Entrant<Case>& enter(Contest<S, Case>& contest, const char* library, const char* method, const Convert& convert,
                     const Ask& ask) {
  using Shapes = std::decay_t<decltype(convert(contest.cases()[0]))>;
  const auto all = std::make_shared<std::vector<Shapes>>();
  all->reserve(contest.cases().size());
  for (const Case& c : contest.cases()) all->push_back(convert(c));
  Entrant<Case>& entrant = contest.enter_pass(
      method, [all, ask] { ask_all(*all, ask); }, [all, ask](std::size_t i) { return said(ask((*all)[i])); }, library);
  entrant.pass_in_turn = [all, ask] { ask_in_turn(*all, ask); };
  return entrant;
}

}  // namespace isect::bench::peers
