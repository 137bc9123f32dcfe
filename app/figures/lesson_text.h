#pragma once
// A lesson as text, for terminals and screen readers: the setting, the pseudocode once, then step by step.

#include <string>

#include "app/shell/options.h"

namespace isect::program {

struct TextOptions {
  std::size_t columns = 80;
  bool brief = false;    ///< one line per step and what it decides; no values, no questions
  bool answers = false;  ///< right after each question, not at the end
};

/// Returns the chosen steps of an excerpt.
std::string lesson_text(const Excerpt&, const TextOptions&);
/// Returns a lesson's exercises with their solutions.
std::string exercises_text(const viz::Lesson&, const TextOptions&);

}  // namespace isect::program
