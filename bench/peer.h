#pragma once
// How another library enters a contest: its own shapes are made before the clock starts.

#include <memory>
#include <vector>

#include "bench/contest.h"

namespace isect::bench::peers {

/// convert(case) -> the library's shapes, ask(shapes) -> bool, int, optional or Said.
template <class S, class Case, class Convert, class Ask>
Entrant<Case>& enter(Contest<S, Case>& contest, const char* library, const char* method, const Convert& convert,
                     const Ask& ask) {
  using Shapes = std::decay_t<decltype(convert(contest.cases()[0]))>;
  const auto all = std::make_shared<std::vector<Shapes>>();
  all->reserve(contest.cases().size());
  for (const Case& c : contest.cases()) all->push_back(convert(c));
  const auto pass = [all, ask] {
    Sum sum;
    for (const Shapes& x : *all) sum += ask(x);
    asm volatile("" : : "g"(sum.count), "x"(sum.values));
  };
  return contest.enter_pass(
      method, pass, [all, ask](std::size_t i) { return said(ask((*all)[i])); }, library);
}

}  // namespace isect::bench::peers
