#pragma once
// Questions whose wrong answers come from a named misconception. The right answer is the predicate's.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "viz/lesson.h"
#include "viz/walk/question_scene.h"
#include "viz/walk/typed_answer.h"

namespace isect::lessons {

/// The number as a reader sees it: rounded to five digits, or to a whole number of up to seven.
inline double as_read(double x) {
  const double five_digits = std::strtod(fmt::format("{:.4e}", x).c_str(), nullptr), size = std::abs(five_digits);
  return 1e5 <= size && size < 1e7 ? std::nearbyint(x) : five_digits;
}

/// Whether a number computed from what is shown gives the truth to three digits; 0 must be 0.
inline bool read_well(double read, double truth) {
  return (read == 0) == (truth == 0) && std::abs(read - truth) <= 1e-3 * std::abs(truth);
}

/// Whether a number is short enough to be typed, as it is shown.
inline bool fit_for_typing(double x) { return x == 0 || (std::abs(x) >= 1e-4 && std::abs(x) < 1e7); }

/// Makes the question ask for `truth`, if it is fit for typing. `digits`: the fewest that count, 0 for a count; up to
/// five if a wrong number needs them to differ from the truth. Where five are not enough, the question keeps its
/// choices alone.
inline void ask_for_number(viz::Question& question, double truth, int digits,
                           const std::vector<viz::WrongNumber>& all_wrong) {
  if (!fit_for_typing(truth)) return;
  viz::Numeric number = {truth, digits, {}};
  for (const viz::WrongNumber& wrong : all_wrong) {
    const auto same = [&](const viz::WrongNumber& w) { return viz::shown(w.value) == viz::shown(wrong.value); };
    if (std::isfinite(wrong.value) && viz::shown(wrong.value) != viz::shown(truth) &&
        std::ranges::none_of(number.wrong, same))
      number.wrong.push_back(wrong);
  }
  const auto too_near = [&](const viz::WrongNumber& wrong) {
    const double counts = std::max(viz::tolerance(number, truth), viz::tolerance(number, wrong.value));
    return std::abs(wrong.value - truth) <= 2 * counts;
  };
  while (std::ranges::any_of(number.wrong, too_near)) {
    if (number.digits == 0 || number.digits == 5) return;
    ++number.digits;
  }
  question.number = std::move(number);
}

/// "What is d^2?": a number to type, or the true value among the wrong ones, in rising order. Each wrong number comes
/// with the mistake that leads to it. Values that read alike are offered once; if fewer than three are left, larger
/// ones are made up. `digits`: how many count; 0: it is a count.
inline viz::Question which_value(const std::string& prompt, double truth, const std::vector<viz::WrongNumber>& wrong,
                                 const std::string& because, int digits = 3) {
  std::vector<double> values = {truth};
  const auto offered = [&](double x) {
    return std::ranges::any_of(values, [&](double v) { return viz::shown(v) == viz::shown(x); });
  };
  for (const viz::WrongNumber& w : wrong)
    if (!offered(w.value) && w.value == w.value) values.push_back(w.value);
  const bool whole = truth == std::round(truth);
  for (int k = 1; values.size() < 3 && k < 9; ++k)
    if (const double x = whole ? truth + k : truth * (k + 1); !offered(x)) values.push_back(x);
  std::ranges::sort(values);
  viz::Question question = {prompt, {}, 0, because};
  for (const double v : values) question.choices.push_back(viz::shown(v));
  question.answer = static_cast<int>(std::ranges::find(values, truth) - values.begin());
  ask_for_number(question, truth, digits, wrong);
  return question;
}

/// "How many edges count?": a question for a count, which must be met exactly.
inline viz::Question which_count(const std::string& prompt, double truth, const std::vector<viz::WrongNumber>& wrong,
                                 const std::string& because) {
  return which_value(prompt, truth, wrong, because, 0);
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

}  // namespace isect::lessons
