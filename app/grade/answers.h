#pragma once
// Answers of a program, held against the true ones.

#include <optional>
#include <string>
#include <string_view>

#include "app/grade/truth.h"

namespace isect::grade {

/// What is said of one answer.
struct Mark {
  bool readable = true;    ///< false: the line is no answer to this task
  std::string fault = {};  ///< empty: right; "false yes", "false miss", "wrong value", ...
  double ulps = 0;         ///< how far a value is off, where there is one
};
/// Marks a line without its end. A program's text is never trusted: it may hold any byte.
Mark marked(const Task&, const Truth&, std::string_view line);

/// Returns how far `said` is from the true value, in ulps of that, or of 1 if it is smaller. Infinite for a NaN.
double ulps_off(double said, double true_value);

/// Returns a program's text for people: what is no printing ASCII, and <, > and &, as \x3c; at most `most` characters,
/// and "..." if there is more.
std::string harmless(std::string_view text, std::size_t most = 60);

}  // namespace isect::grade
