#pragma once
// Two reports of the same measurements: what became slower, faster or wrong.

#include <string>
#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// One call in both reports.
struct Changed {
  Row before, after;
  /// Time after divided by time before. If both reports have a standard method's row of the same family, the times are
  /// first divided by that row's, so that a faster machine does not count; the standard itself has its plain times.
  double ratio = 1;
  /// Relative noise of the ratio: the sum of the spreads of all times in it, at least 3 %.
  double noise = 0;

  bool slower() const { return ratio > 1 + noise; }
  bool faster() const { return ratio * (1 + noise) < 1; }
  bool more_wrong() const { return after.wrong_per_million() > before.wrong_per_million(); }
};

struct Comparison {
  std::vector<Changed> rows;  ///< the rows in both reports, in the order of the second
  std::vector<Row> gone, added;

  /// Whether nothing became slower, wrong or gone.
  bool holds() const;
};

/// Throws std::runtime_error where the reports have no row in common, or come from different builds, whose times are
/// not comparable.
Comparison compare(const Report& before, const Report& after);

/// The comparison as text for a terminal: what changed, the worst first, then one line with how many rows did not.
std::string told(const Comparison&);

}  // namespace isect::bench
