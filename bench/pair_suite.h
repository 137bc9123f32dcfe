#pragma once
// A suite of several pairs of shapes, each in a few lines: the usual test in doubles, the call of the core, and the
// truth. All pairs have the same families of cases.

#include <string>
#include <utility>

#include "bench/full_precision.h"
#include "bench/pair_draws.h"
#include "bench/session.h"

namespace isect::bench {

inline Truth truth_that(bool yes) { return {yes, {}}; }
inline Truth truth_that(Location l) { return truth_of(l); }
inline Truth truth_that(Culling c) { return {static_cast<int>(c), {}}; }
inline Truth truth_that(int count) { return {count, {}}; }
inline Truth truth_that(const Truth& t) { return t; }

/// Enters nothing: no other installed library answers the same question.
struct NoPeer {
  void operator()(auto&, std::string_view) const {}
};

/// The verdict of an answer, without its value.
template <class Answer>
auto verdict_of(const Answer& answer) {
  return said(answer).verdict;
}

template <class A, class B>
class PairContest {
 public:
  using Case = Pair<A, B>;

  /// `most` bounds the cases of a family, for slow oracles.
  PairContest(Session& session, std::string test, long most = 1 << 13)
      : session_(session), test_(std::move(test)), most_(most) {
    session.aim({.work = test_ + ": wrong verdicts", .kind = Target::wrong, .test = test_, .at_most = 0});
  }

  /// Admits only pairs for which `wanted` holds, as the core's promise requires.
  PairContest& only(bool (*wanted)(const A&, const B&)) { return wanted_ = wanted, *this; }

  /// Calls naive(a, b), exact(a, b) and truly(a, b). enter_peers(contest, family) enters other libraries.
  template <class Naive, class Exact, class Truly, class Peers = NoPeer>
  void run(const Naive& naive, const Exact& exact, const Truly& truly, const Peers& enter_peers = {}) {
    namespace draws = pair_draws;
    const auto compete = [&](const char* name, const char* note, const std::function<Case(Random&)>& any) {
      const auto draw = [any, wanted = wanted_](Random& random) {
        for (;;)
          if (Case c = any(random); wanted == nullptr || wanted(c.a, c.b)) return c;
      };
      CaseFamily<Case> family = {test_,
                                 "double",
                                 name,
                                 note,
                                 std::string_view(name) != "ordinary",
                                 draw,
                                 [&](const Case& c) { return truth_that(truly(c.a, c.b)); },
                                 [](const Case& c) { return full_precision(c); }};
      family.most_cases = most_;
      Contest<double, Case> contest(session_, family);
      contest.enter("naive", [naive](const Case& c) { return naive(c.a, c.b); }).standard();
      contest.enter("exact", [exact](const Case& c) { return exact(c.a, c.b); }).exact();
      enter_peers(contest, family.name);
      contest.run();
    };
    compete("ordinary", "", draws::of_numbers<A, B, Numbers::ordinary>);
    compete("near-touch", "one shape moved to where the answer changes, as near as doubles come.", [&](Random& random) {
      return draws::at_the_edge<A, B>(random, [&](const Case& c) { return verdict_of(exact(c.a, c.b)); });
    });
    compete("exact-touch", "small integers: they touch and coincide.", draws::of_numbers<A, B, Numbers::grid>);
    compete("nudged", "the same, up to 2 ulp off.", draws::of_numbers<A, B, Numbers::nudged>);
    compete("tenths", "multiples of 0.1, which are no doubles.", draws::of_numbers<A, B, Numbers::decimal>);
    compete("distant", "small integers 1e8 away.", draws::of_numbers<A, B, Numbers::distant>);
    compete("scale", "sizes at which squares overflow or vanish.", draws::scale<A, B>);
  }

 private:
  Session& session_;
  std::string test_;
  long most_;
  bool (*wanted_)(const A&, const B&) = nullptr;
};

}  // namespace isect::bench
