#pragma once
// Where two walks of one lesson part, as far as the reader has come.

#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// The place where two walks part; -1 if they don't, or if only the other walk has such a place.
struct WalkDifference {
  /// The first line whose text differs in more than names or, in the same text, that only one of them runs.
  int line_a = -1, line_b = -1;
  int value_a = -1, value_b = -1;  ///< the first value of the steps shown that has another name or number
  std::vector<int> renamed = {};   ///< lines of both, before those, that differ by names alone (renamed_lines.h)
  bool operator==(const WalkDifference&) const = default;
};

/// `at_a`, `at_b`: the steps shown. Later steps are not looked at, except that two texts differ.
WalkDifference walk_difference(const Walk& a, int at_a, const Walk& b, int at_b);

}  // namespace isect::viz
