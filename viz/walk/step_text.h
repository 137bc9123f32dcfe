#pragma once
// What a step says, in parts: made once, and rendered as text, as HTML, as LaTeX and in the window. Texts are
// markup.

#include <optional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// The current line of the pseudocode.
struct LineText {
  int number;        ///< from 1
  std::string code;  ///< plain text, without its indentation
  std::string said;  ///< "yes" or "no": what its condition is; empty where it has none, or the step does not decide it
};

struct ValueText {
  std::string name, digits;
  bool fresh = false;       ///< computed or changed in this step
  bool in_formula = false;  ///< the step's formula is about it, and ends with its digits
};

struct ComparisonText {
  std::string question;  ///< "Is *m*^2 ≤ *r*^2?"
  bool holds;
  std::string answer;  ///< "Yes"
  std::string why;     ///< "(0.5 against 2): the line meets the ball."
};

/// The question before a step. Its answers are called (a), (b), ...
struct QuestionText {
  int number;                    ///< among all of the walk, from 1
  std::string prompt;            ///< with the numbers that it is given: "What is *m*^2? Given: *s* = 2."
  std::string whole_prompt;      ///< with all that is known of its step: for a page that has no other place for it
  std::vector<ValueText> known;  ///< what is known besides the numbers that it is given
  std::vector<std::string> choices;
  std::size_t right;                ///< index into choices
  std::string answer;               ///< "(b) It misses.", "Line 4: return MISS.", "(c) far, then (a) near."
  std::string because;              ///< the reason why
  const Question* asked = nullptr;  ///< the question itself, of the walk
};

/// Where the pseudocode of a walk differs from the published one.
struct ErratumText {
  int line;          ///< from 1
  std::string says;  ///< "Line 4 should read: if d² ≤ R²."
  std::string why;
  const Preset* shown_by;  ///< the published line fails on it
};

/// A part that the step does not have is empty.
struct StepText {
  std::string title;
  std::string caption;      ///< paragraphs, separated by '\n'
  std::string own_caption;  ///< without the lesson's opening, with which the first one begins
  std::string formula;
  std::optional<LineText> line;
  std::vector<ValueText> values;
  std::optional<ComparisonText> comparison;
  Verdict verdict;
  std::string source;
  std::optional<QuestionText> question;
};

StepText step_text(const Lesson&, const Walk&, int step);
/// Returns the question before `step`, if there is one.
std::optional<QuestionText> question_text(const Walk&, int step);
/// Returns the errata of the pseudocode that this walk follows.
std::vector<ErratumText> errata_text(const Lesson&, const Walk&);

/// Returns "Line 4 should read: ... (See the preset “touching”.)", which calls the preset by its id or its title.
std::string with_preset(const ErratumText&, std::string Preset::*name);
/// Returns the numbers of a comparison, in full where they would read alike: "0.5 against 2". For a condition that
/// joins several, each has its own: "*s* < 0: yes, −1 against 0; ...".
std::string compared_numbers(const Comparison&);
/// Returns the verdict, with the core's own words where it has others: "they kiss (exactly: A and B touch)".
std::string verdict_text(const Verdict&);
/// Returns the letter of an answer: 'a' for 0.
char choice_letter(std::size_t i);
/// Returns "Given: *s* = 1.022, *l*^2 = 1.1604."
std::string given_text(const std::vector<Value>&);
/// Returns title and own caption on one line: for a figure that stands alone. `title`: in place of the step's own;
/// empty: that one.
std::string figure_caption(const Lesson&, const Step&, const std::string& title = {});

}  // namespace isect::viz
