#pragma once
// What is said to a number that a reader typed as the answer to a question.

#include <optional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns how far from a value a number may be to count as that value: one unit of the last digit that counts, so that
/// one may round or cut off. The rounding of what is typed, as sqrt(2)^2, never matters.
double tolerance(const Numeric&, double value);
bool agree(const Numeric&, double typed, double value);
inline bool is_right(const Numeric& number, double typed) { return agree(number, typed, number.truth); }
/// Returns how exact the number has to be: "a whole number", "to three digits".
std::string exactness(const Numeric&);

/// Returns what a reader is told to do: "Type a whole number."
std::string what_to_type(const Numeric&);

/// What is said to numbers that are this value, up to the tolerance.
struct Reply {
  double value = 0, tolerance = 0;
  std::string text;  ///< markup
};
/// Returns what is said to wrong numbers; the first that fits counts. After the question's own mistakes: a sign that is
/// lost, and too few digits.
std::vector<Reply> replies(const Numeric&);
/// Returns what is said to this number; empty if it is right, or the mistake behind it is not known.
std::string reply_to(const Numeric&, double typed);
/// Returns what is said to this choice of a question; empty where there is nothing to say.
std::string reply_to_choice(const Question&, int choice);

/// Returns the choice that says this number, right or wrong; none: no choice does.
std::optional<int> choice_of(const Question&, double typed);
/// Returns "3/4 = 0.75" as markup: a number as typed and, where it reads differently, as it is shown.
std::string typed_text(const std::string& typed, double value);

}  // namespace isect::viz
