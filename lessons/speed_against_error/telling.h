#pragma once
// One test's measurements, read and explained: what each step of the lesson says and shows.

#include <string>
#include <utility>
#include <vector>

#include "bench/plots.h"
#include "lessons/shared/script.h"

namespace isect::lessons::speed_against_error_lesson {

class Teller {
 public:
  Teller(const bench::Report& report, const std::string& test);
  viz::Walk tell();

  /// The hard families that the lesson goes through: at most three.
  const std::vector<std::string>& hard() const { return hard_; }

 private:
  using Rows = std::vector<const bench::Row*>;
  enum Line { time_line, judge_line, front_line, hard_line, wrong_line, cost_line, choose_line };

  Rows of(const std::string& family) const;
  const bench::Row& naive(const std::string& family) const;
  const bench::Row& exact(const std::string& family) const;
  double error(const bench::Row&) const;            ///< ulp at the 99th percentile, or wrong verdicts of a million
  std::string error_text(const bench::Row&) const;  ///< with its unit
  viz::Plot plot(const std::vector<std::string>& families) const;
  /// Whether two times differ by more than the noise of the machine that took them.
  bool differ(double a, double b) const;
  /// Of isect's methods that are right on all ordinary cases, the exact one left out, and as fast there as the fastest:
  /// the one that is least often wrong on hard cases.
  const bench::Row& rival() const;
  /// Those, but for noise.
  Rows as_fast_as(const bench::Row&) const;
  /// The share of its verdicts on hard cases.
  double wrong_when_hard(const bench::Row& method) const;
  /// The family on which the exact call takes most times as long as the naive method, and how many times.
  std::pair<std::string, double> dearest() const;
  /// On how many hard families it takes longer, and how much: empty where it does on none.
  std::string cost_when_hard() const;
  /// What the naive method does there, as a sentence.
  std::string naive_there(const std::string& family) const;
  void values(const std::string& family);
  void show(viz::Step&, viz::Chart) const;

  // ordinary.cpp
  void axes();
  void methods();
  void front();
  // hard.cpp
  void hard_family(const std::string& family, bool first);
  void fall();
  // cost.cpp
  void cost();
  void fallback();
  void choose();

  const bench::Report& report_;
  std::string test_;
  Rows rows_;
  bool by_value_;
  std::string ordinary_;
  std::vector<std::string> hard_;
  Script script_;
};

/// What is told before the first step, and after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

/// The tests that the results can tell about: with a naive method, an exact one and a hard family.
std::vector<std::string> tests(const bench::Report&);

}  // namespace isect::lessons::speed_against_error_lesson
