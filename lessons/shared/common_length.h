#pragma once
// Questions for the length that two intervals have in common; where there is a gap, it is negative.

#include <algorithm>
#include <optional>
#include <string>

#include <isect/interval.h>
#include "lessons/shared/questions.h"

namespace isect::lessons {

/// The length that two intervals have in common; that of a gap between them is negative.
inline double common_length(const Interval<double>& a, const Interval<double>& b) {
  return std::min(a.hi, b.hi) - std::max(a.lo, b.lo);
}
/// That length, from the ends as they are shown.
inline double common_length_read(const Interval<double>& a, const Interval<double>& b) {
  return common_length({as_read(a.lo), as_read(a.hi)}, {as_read(b.lo), as_read(b.hi)});
}

/// "a reaches from 0 to 2, b from 1 to 4. How long is what they share?" `told` is the first of these sentences. None
/// where the ends, as shown, do not give the length.
inline std::optional<viz::Question> common_length_question(const std::string& told, const Interval<double>& a,
                                                           const Interval<double>& b) {
  const double length = common_length(a, b), of_a = a.hi - a.lo, of_b = b.hi - b.lo;
  if (!read_well(common_length_read(a, b), length)) return {};
  return which_value(told + " How long is what they share? Give a gap as a negative length.", length,
                     {{std::max(a.hi, b.hi) - std::min(a.lo, b.lo), "That reaches from the lowest end to the highest."},
                      {of_a, "That is the length of a alone."},
                      {of_b, "That is the length of b alone."},
                      {of_a + of_b, "That adds both lengths."}},
                     "It is the smaller upper end, less the larger lower one. Where that is negative, there is a gap.");
}

}  // namespace isect::lessons
