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
  /// The method of isect that is least often wrong on hard cases, among those that are not the exact one, right on all
  /// ordinary cases and, up to noise, as fast there as the fastest.
  const bench::Row& rival() const;
  /// The methods among which rival() chooses: as fast as this one up to noise.
  Rows as_fast_as(const bench::Row&) const;
  /// The share of a method's verdicts on hard cases that are wrong.
  double wrong_when_hard(const bench::Row& method) const;
  /// The family on which the ratio of the exact call's time to the naive method's is largest, and that ratio.
  std::pair<std::string, double> dearest() const;
  /// A sentence on the number of hard families where the exact call takes longer, and how much; empty if there is none.
  std::string cost_when_hard() const;
  /// A sentence on what the naive method does on that family.
  std::string naive_there(const std::string& family) const;
  /// Whether a method misses all of a family where shapes touch, for its strict <, and not by rounding: methods that
  /// round as it does, but count touching, are never wrong there.
  bool by_convention(const bench::Row&) const;
  /// The hard families that have no step of their own.
  std::vector<std::string> other_families() const;
  /// The family that the note of this one calls "the same"; empty if it says all by itself.
  std::string like(const std::string& family) const;
  /// What a family is made of, a sentence without its capital letter.
  std::string made_of(const std::string& family) const;
  void values(const std::string& family);
  void show(viz::Step&, viz::Chart) const;

  // ordinary.cpp
  void axes();
  void methods();
  void front();
  // typical.cpp
  void typical_cases();
  // hard.cpp
  void hard_family(const std::string& family, bool first);
  void others();
  /// A sentence where no rounded method errs by less than a tenth of what the naive one does; empty where one does.
  std::string no_cure(const std::string& family) const;
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

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

/// The tests that the results can show: those with a naive method, an exact one and a hard family.
std::vector<std::string> tests(const bench::Report&);

}  // namespace isect::lessons::speed_against_error_lesson
