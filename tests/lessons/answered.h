#pragma once
// Questions answered from what is on show alone.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/random.h"
#include "lessons/shared/questions.h"
#include "tests/lessons/on_show.h"
#include "tests/lessons/ways_in_words.h"
#include "tests/lessons/ways_to_numbers.h"

namespace isect::tests::on_show {

/// Questions answered by the parameters and objects, which every page gives in words, and by what was said on the way.
inline const std::vector<std::string>& from_what_is_given() {
  static const std::vector<std::string> all = {"which set is a subset",
                                               "which points do they share",
                                               "one pose, four kinds",
                                               "coordinates on",
                                               "how many say near",
                                               "of the four differences",
                                               "which face of the triangle",
                                               "is compared with",
                                               "how are the intervals related",
                                               "which t belong",
                                               "which line returns",
                                               "find the bullet in the wall",
                                               "when does the bullet hit",
                                               "how are the two boxes related",
                                               "how are the ball and the box related",
                                               "of the two segments' lines",
                                               "how are the two capsules related",
                                               "what do they tell",
                                               "the whole line share with the sphere",
                                               "the ray's first hit",
                                               "which has less void",
                                               "what does the volume's test show",
                                               "compared with the hull",
                                               "how many edges count",
                                               "which line settles",
                                               "does the boundary wind",
                                               "where does the line meet the plane",
                                               "coordinate is best dropped",
                                               "does the point have on its right",
                                               "each counts once for every slab",
                                               "where is p =",
                                               "boxes are active then",
                                               "comparisons of the vertices",
                                               "side do to the range",
                                               "left after the cut",
                                               "how many does it reject",
                                               "from the point",
                                               "may a mesh that bounds a solid",
                                               "how many pairs of points",
                                               "what follows"};
  return all;
}

/// Questions on rules, counts of parts, and guesses at measurements: no number of the setting decides them.
inline const std::vector<std::string>& from_what_is_known() {
  static const std::vector<std::string> all = {"of the six relations remain",
                                               "how far may r be",
                                               "numbers are that",
                                               "-dop have",
                                               "where does b lie",
                                               "at most",
                                               "does that rule out",
                                               "grow with n",
                                               "does the complete map have",
                                               "the new edge",
                                               "why must no edge",
                                               "and the holes are filled",
                                               "double loop",
                                               "fewest tests",
                                               "how long may one step be",
                                               "box around the whole path",
                                               "single out one wedge",
                                               "which boxes cost",
                                               "of the count is left",
                                               "of c++ return",
                                               "becomes of the expected cost",
                                               "by the time measured",
                                               "naive test",
                                               "how many roundings",
                                               "how many further signs",
                                               "let a wrong sign through",
                                               "miss both triangles",
                                               "what does it compute there",
                                               "which point must be tested",
                                               "errs most",
                                               "does the exact call take",
                                               "dominated"};
  return all;
}

inline bool is_among(const std::vector<std::string>& parts, const std::string& text) {
  return std::ranges::any_of(parts, [&](const std::string& part) { return text.find(part) != text.npos; });
}

/// How a question is answered: from the numbers on show; by some that are shown alike, as it hangs on rounding; from
/// what the page says in words, or the reader knows; wrongly; or not at all.
enum class How { by_numbers, by_rounding, in_words, wrongly, not_at_all };

/// A way from what is on show to a choice, by the part of the prompt that it is known by.
struct Way {
  std::string name = {};
  std::function<int(const OnShow&)> choice = {};
};

/// Returns the choices as numbers; nothing if one is none.
inline std::optional<std::vector<double>> numeric_choices(const Question& question) {
  std::vector<double> all;
  for (const std::string& choice : question.choices)
    if (const auto x = number_in(without_powers(without_thin_spaces(plain(choice)))))
      all.push_back(*x);
    else
      return {};
  return all;
}

/// Returns the way to answer; one without a name if there is none. The question must outlive it.
inline Way way_to_answer(const Question& question) {
  const std::string prompt = plain(question.prompt);
  std::string lower = prompt;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [part, way] : ways_in_words())
    if (lower.find(part) != lower.npos)
      return {part, [&question, prompt, way = way](const OnShow& shown) { return way(question, prompt, shown); }};
  const std::optional<std::vector<double>> choices = numeric_choices(question);
  for (const auto& [part, way] : ways())
    if (choices && prompt.find(part) != prompt.npos)
      return {part, [choices = *choices, way = way](const OnShow& shown) {
                const double found = way(shown);
                const auto nearest =
                    std::ranges::min_element(choices, {}, [&](double x) { return std::abs(x - found); });
                return static_cast<int>(nearest - choices.begin());
              }};
  return {};
}

/// Calls look(moved) with other numbers that are shown alike, to five digits: all as they are read, each moved alone,
/// then all in 32 ways; until one returns true. Returns whether one did.
template <class Look>
bool if_read_otherwise(const OnShow& shown, const Look& look) {
  OnShow read = shown;
  for (double& x : read.told) x = lessons::as_read(x);
  for (auto& [name, x] : read.values) x = lessons::as_read(x);
  if (look(read)) return true;
  const auto digit = [](double x) {
    return x == 0 || !std::isfinite(x) ? 0 : std::pow(10, std::floor(std::log10(std::abs(x))) - 4);
  };
  const std::size_t told = shown.told.size(), count = told + shown.values.size();
  const auto shift = [&](OnShow& moved, std::size_t i, double sign) {
    double& x =
        i < told ? moved.told.at(i) : std::next(moved.values.begin(), static_cast<std::ptrdiff_t>(i - told))->second;
    x += sign * digit(x);
  };
  for (std::size_t i = 0; i < count; ++i)
    for (const double sign : {-1.0, 1.0}) {
      OnShow moved = shown;
      shift(moved, i, sign);
      if (look(moved)) return true;
    }
  bench::Random random(bench::stream(1, "read otherwise"));
  for (int i = 0; i < 32; ++i) {
    OnShow moved = shown;
    for (std::size_t k = 0; k < count; ++k) shift(moved, k, random.uniform(-1, 1));
    if (look(moved)) return true;
  }
  return false;
}

/// Answers the question before step k. `name`: the way's; empty: it has none.
inline How answered(const Walk& walk, int k, std::string* name = nullptr) {
  const Question& question = *walk.steps.at(static_cast<std::size_t>(k)).question;
  const Way way = way_to_answer(question);
  if (name) *name = way.name;
  if (!way.choice) {
    std::string prompt = plain(question.prompt);
    std::ranges::transform(prompt, prompt.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool known = is_among(from_what_is_given(), prompt) || is_among(from_what_is_known(), prompt) ||
                       std::ranges::any_of(ways(), [&](const auto& w) {
                         return plain(question.prompt).find(w.first) != std::string::npos;
                       });
    return known ? How::in_words : How::not_at_all;
  }
  const OnShow shown = shown_at(walk, k);
  if (way.choice(shown) == question.answer) return How::by_numbers;
  const bool near = if_read_otherwise(shown, [&](const OnShow& moved) { return way.choice(moved) == question.answer; });
  return near ? How::by_rounding : How::wrongly;
}

}  // namespace isect::tests::on_show
