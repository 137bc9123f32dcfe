#pragma once
// What isect set out to reach: ratios of times in one run, beside naive methods and beside other libraries, as data.

#include <optional>
#include <string>
#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// One row: a measured number and the most that it may be.
struct Target {
  enum class Kind {
    ratio,   ///< ours / theirs: least times of one family, in one run
    growth,  ///< the same at `n` elements
    time,    ///< ours in ns, at `n` elements
    wrong,   ///< wrong verdicts of ours, all families together
    ulps     ///< greatest error of ours, all families together
  };
  std::string work;  ///< what is done, for the table
  Kind kind;
  std::string test;               ///< of Row or Growth
  std::string family;             ///< of Row; empty: "ordinary"
  std::string ours;               ///< method of isect
  std::string theirs;             ///< method of isect, or library; "naive": the row that others are divided by
  double n = 0;                   ///< of Growth
  std::optional<double> at_most;  ///< none: reported only
  std::string unit = {};          ///< of Growth: "query", "build"; empty: any
};
const std::vector<Target>& targets();

/// The number that a target is about, or nothing where the report lacks a row for it.
std::optional<double> measured(const Target&, const Report&);
/// "at most 2 x naive", "0", "at most 60 ns".
std::string wanted(const Target&);
bool met(const Target&, double measured);

}  // namespace isect::bench
