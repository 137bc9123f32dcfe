#pragma once
// The same question once more, with other numbers.

#include <cstdint>
#include <optional>

#include "viz/lesson.h"

namespace isect::viz {

/// A setting, and its step whose question is asked.
struct OtherSetting {
  Parameters parameters;
  int step = 0;
};

/// Returns a setting in which the question before `step` is asked again, with another right answer or other numbers: a
/// preset of the same method, or this setting with one parameter moved. The core decides the answer there as it does
/// here; no two choices read alike, and no usual wrong number counts as the right one. None: none was found.
std::optional<OtherSetting> other_numbers(const Lesson&, const Parameters&, int step, std::uint32_t seed);

/// Returns all that tells a question from the same one in another setting: its words, its numbers, its right answer.
std::string numbers_of_question(const Walk&, int step);
/// Whether a question's choices read differently, and no usual wrong number counts as the right one.
bool choices_differ(const Question&);

}  // namespace isect::viz
