#pragma once
// Questions whose wrong answers come from a named misconception. The right answer is the predicate's.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/text/rich_text.h"
#include "viz/walk/question_scene.h"

namespace isect::lessons {

/// "What is d^2?": the true value among those of the `misconceived` ways, in rising order. Values that read alike are
/// offered once; if fewer than three are left, larger ones are made up.
inline viz::Question which_value(const std::string& prompt, double truth, std::vector<double> misconceived,
                                 const std::string& because) {
  std::vector<double> values = {truth};
  const auto offered = [&](double x) {
    return std::ranges::any_of(values, [&](double v) { return viz::shown(v) == viz::shown(x); });
  };
  for (const double x : misconceived)
    if (!offered(x) && x == x) values.push_back(x);
  const bool whole = truth == std::round(truth);
  for (int k = 1; values.size() < 3 && k < 9; ++k)
    if (const double x = whole ? truth + k : truth * (k + 1); !offered(x)) values.push_back(x);
  std::ranges::sort(values);
  viz::Question question = {prompt, {}, 0, because};
  for (const double v : values) question.choices.push_back(viz::shown(v));
  question.answer = static_cast<int>(std::ranges::find(values, truth) - values.begin());
  return question;
}

/// Gives the question of the walk's last step these values as the step before shows them; the step may change them.
inline void give_before(viz::Walk& walk, const std::vector<std::string>& names) {
  const std::size_t last = walk.steps.size() - 1;
  if (last == 0) return;
  for (const viz::Value& value : walk.steps[last - 1].values)
    if (std::ranges::find(names, value.name) != names.end())
      walk.steps[last].question->given.push_back(viz::before(value));
}

/// While the question of the walk's last step is open, the picture before it stays: the step's own has the answer.
inline void keep_picture(viz::Walk& walk) {
  const std::size_t last = walk.steps.size() - 1;
  if (last > 0) walk.steps[last].question->over = walk.steps[last - 1].scene;
}

/// Which line settles or returns something: `line` among `others`, in the order of the pseudocode. There is no question
/// which line runs next, since tests that fail run, too.
inline viz::Question which_line(const std::string& prompt, const std::vector<std::string>& pseudocode, int line,
                                std::vector<int> others, const std::string& because) {
  others.push_back(line);
  std::ranges::sort(others);
  others.erase(std::unique(others.begin(), others.end()), others.end());
  viz::Question question = {prompt, {}, 0, because};
  for (const int i : others) question.choices.push_back(viz::as_markup(viz::unindented(pseudocode.at(i))));
  question.answer = static_cast<int>(std::ranges::find(others, line) - others.begin());
  return question;
}

}  // namespace isect::lessons
