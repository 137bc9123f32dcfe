#pragma once
// Questions for a line of the pseudocode: the one that the walk's last step lights.

#include <algorithm>
#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/text/rich_text.h"

namespace isect::lessons {

/// Asks, before the walk's last step, for the line that this step lights: "Which line settles it?" Each wrong line that
/// is usually pointed at comes with the mistake behind it; the step's own line among them is left out. Lines near it
/// are offered, too, where there are few. There is no question which line runs next, since tests that fail run, too.
inline void ask_for_line(viz::Walk& walk, const std::string& prompt, const std::vector<viz::WrongLine>& wrong,
                         const std::string& because) {
  viz::Step& step = walk.steps.back();
  const int lines = static_cast<int>(walk.pseudocode.size());
  const auto words = [&](int line) {
    return viz::as_markup(viz::unindented(walk.pseudocode.at(static_cast<std::size_t>(line))));
  };
  viz::LineAsked asked = {step.line, {step.line}, {}};
  const auto offer = [&](int line) {
    const auto reads_alike = [&](int other) { return words(other) == words(line); };
    if (std::ranges::none_of(asked.offered, reads_alike)) asked.offered.push_back(line);
  };
  for (const viz::WrongLine& w : wrong) {
    if (w.line == step.line || std::ranges::count(asked.wrong, w.line, &viz::WrongLine::line) > 0) continue;
    asked.wrong.push_back(w);
    offer(w.line);
  }
  for (int away = 1; asked.offered.size() < 3 && away < lines; ++away)
    for (const int line : {step.line - away, step.line + away})
      if (line >= 0 && line < lines) offer(line);
  std::ranges::sort(asked.offered);
  viz::Question question = {prompt, {}, 0, because};
  for (const int line : asked.offered) question.choices.push_back(words(line));
  question.answer = static_cast<int>(std::ranges::find(asked.offered, step.line) - asked.offered.begin());
  question.line = std::move(asked);
  step.question = std::move(question);
}

}  // namespace isect::lessons
