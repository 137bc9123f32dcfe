#pragma once
// Two reports of the same measurements: what became slower, faster or wrong.

#include <string>
#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// One call in both reports.
struct Changed {
  Row before, after;
  /// How much longer it takes. Beside a standard method's row of the same family in both reports, the ratio of the
  /// ratios to it, so that another day's machine does not count; the standard itself by its plain times.
  double ratio = 1;
  /// What of it may be chance: the spreads of all times that it comes from, and 3 % at least.
  double noise = 0;

  bool slower() const { return ratio > 1 + noise; }
  bool faster() const { return ratio * (1 + noise) < 1; }
  bool more_wrong() const { return after.wrong_per_million() > before.wrong_per_million(); }
};

struct Comparison {
  std::vector<Changed> rows;  ///< those in both, in the order of the second report
  std::vector<Row> gone, added;

  /// Whether nothing became slower, wrong or gone.
  bool holds() const;
};

/// Throws std::runtime_error where the reports have no row in common, or come from different builds, whose times are
/// not comparable.
Comparison compare(const Report& before, const Report& after);

/// For a terminal: what changed, the worst first, then one line of how many did not.
std::string told(const Comparison&);

}  // namespace isect::bench
