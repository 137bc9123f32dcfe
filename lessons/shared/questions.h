#pragma once
// Questions whose wrong answers come from a named misconception. The right answer is the predicate's.

#include <algorithm>
#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/rich_text.h"

namespace isect::lessons {

/// "What is d^2?": the true value among those that `misconceived` ways give, in rising order. What reads alike is
/// offered once; where nothing else is left, one larger value is made up.
inline viz::Question which_value(const std::string& prompt, double truth, std::vector<double> misconceived,
                                 const std::string& because) {
  std::vector<double> values = {truth};
  const auto offered = [&](double x) {
    return std::ranges::any_of(values, [&](double v) { return viz::shown(v) == viz::shown(x); });
  };
  for (const double x : misconceived)
    if (!offered(x) && x == x) values.push_back(x);
  if (values.size() == 1) values.push_back(truth + 1);
  std::ranges::sort(values);
  viz::Question question = {prompt, {}, 0, because};
  for (const double v : values) question.choices.push_back(viz::shown(v));
  question.answer = static_cast<int>(std::ranges::find(values, truth) - values.begin());
  return question;
}

/// "Which line runs next?": `next` among `others`, in the order of the pseudocode.
inline viz::Question which_line(const std::vector<std::string>& pseudocode, int next, std::vector<int> others,
                                const std::string& because) {
  others.push_back(next);
  std::ranges::sort(others);
  others.erase(std::unique(others.begin(), others.end()), others.end());
  viz::Question question = {"Which line runs next?", {}, 0, because};
  for (const int line : others) question.choices.push_back(viz::as_markup(viz::unindented(pseudocode.at(line))));
  question.answer = static_cast<int>(std::ranges::find(others, next) - others.begin());
  return question;
}

}  // namespace isect::lessons
