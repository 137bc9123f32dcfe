#include "viz/walk/typed_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/lang/message.h"
#include "viz/text/count_words.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

/// The rounding of expressions such as sqrt(2)^2, relative to their value.
constexpr double of_expressions = 1e-9;

/// How near a number with too few digits is, relative to the truth.
constexpr double too_few_digits = 0.02;

}  // namespace

double tolerance(const Numeric& number, double value) {
  if (value == 0) return 1e-12;  // 0.1 + 0.2 − 0.3
  const double size = std::abs(value);
  if (number.digits == 0) return of_expressions * size;
  const double unit = std::pow(10.0, std::floor(std::log10(size)) - number.digits + 1);
  return unit + of_expressions * size;
}

bool agree(const Numeric& number, double typed, double value) {
  return std::abs(typed - value) <= tolerance(number, value);
}

std::string exactness(const Numeric& number) {
  // digits that count are two to five
  return number.digits == 0   ? tr("a whole number")
         : number.digits == 2 ? tr("to two digits")
         : number.digits == 3 ? tr("to three digits")
         : number.digits == 4 ? tr("to four digits")
         : number.digits == 5 ? tr("to five digits")
                              : tr("to {n} digits", {{"n", in_words(number.digits)}});
}

std::string what_to_type(const Numeric& number) {
  return number.digits == 0 ? tr("Type a whole number.")
                            : tr("Type a number {exactness}; 1/3 and √2 will do.", {{"exactness", exactness(number)}});
}

std::vector<Reply> replies(const Numeric& number) {
  std::vector<Reply> all;
  for (const WrongNumber& wrong : number.wrong)
    all.push_back({wrong.value, tolerance(number, wrong.value), wrong.reply});
  if (number.truth != 0)
    all.push_back({-number.truth, tolerance(number, number.truth), tr("The sign is the opposite.")});
  if (number.truth != 0 && number.digits > 0)
    all.push_back({number.truth, too_few_digits * std::abs(number.truth),
                   tr("That is near. The answer is asked for {exactness}.", {{"exactness", exactness(number)}})});
  return all;
}

std::string reply_to(const Numeric& number, double typed) {
  if (is_right(number, typed)) return {};
  const std::vector<Reply> all = replies(number);
  const auto fits = [&](const Reply& r) { return std::abs(typed - r.value) <= r.tolerance; };
  const auto found = std::ranges::find_if(all, fits);
  return found == all.end() ? std::string() : found->text;
}

std::string reply_to_choice(const Question& question, int choice) {
  if (!question.number || choice == question.answer || choice < 0) return {};
  for (const WrongNumber& wrong : question.number->wrong)
    if (shown(wrong.value) == question.choices.at(static_cast<std::size_t>(choice))) return wrong.reply;
  return {};
}

std::optional<int> choice_of(const Question& question, double typed) {
  const Numeric& number = *question.number;
  if (is_right(number, typed)) return question.answer;
  for (const WrongNumber& wrong : number.wrong) {
    if (!agree(number, typed, wrong.value)) continue;
    const auto found = std::ranges::find(question.choices, shown(wrong.value));
    if (found != question.choices.end()) return static_cast<int>(found - question.choices.begin());
  }
  return {};
}

std::string typed_text(const std::string& typed, double value) {
  const std::string is = shown(value), text = with_minus_signs(typed);
  return text == is ? is : as_markup(text) + " = " + is;
}

}  // namespace isect::viz
