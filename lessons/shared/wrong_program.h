#pragma once
// Exercises that show a program with one wrong line. A reader finds the line by making a case in which the program
// errs: so the correction is no part of the prompt.

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "viz/lesson.h"
#include "viz/text/rich_text.h"

namespace isect::lessons {

/// The line that is wrong, from 1, what it should read, and why.
struct Correction {
  int number;
  std::string right;  ///< as pseudocode
  std::string why;    ///< markup
};

template <viz::TwoVerdicts (*verdicts)(const viz::Parameters&)>
bool program_errs(const viz::Parameters& p) {
  return verdicts(p).differ();
}

/// `question`: what the program should tell, "whether two boxes meet". `preset`: one in which it is right; `by` leads
/// from there to a setting in which it is wrong. `verdicts` runs the lines shown, written in C++.
template <viz::TwoVerdicts (*verdicts)(const viz::Parameters&)>
viz::Exercise wrong_program(const std::string& question, std::vector<std::string> lines, const Correction& wrong,
                            std::string preset, std::vector<std::pair<std::string, std::string>> by) {
  return {
      .prompt = fmt::format(
          "This program should tell {}. One of its lines is wrong. Find a setting in which its verdict is wrong.",
          question),
      .solution = fmt::format("Line {} should read: {}. {}", wrong.number, viz::as_markup(viz::unindented(wrong.right)),
                              wrong.why),
      .preset = std::move(preset),
      .found = program_errs<verdicts>,
      .by = std::move(by),
      .program = std::move(lines),
      .verdicts = verdicts,
  };
}

}  // namespace isect::lessons
