#include "app/grade/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace isect::grade {

namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos; at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string small_letters(std::string_view word) {
  std::string text(word.substr(0, 16));
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return word.find("e-") == word.npos ? INFINITY : 0.0;
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::optional<std::vector<double>> numbers_in(const std::vector<std::string_view>& words) {
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const std::optional<double> number = number_in(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

const Mark unreadable = {false, "no answer to read"};

Mark marked_yes_no(const Truth& truth, const std::vector<std::string_view>& words) {
  if (words.size() != 1) return unreadable;
  const std::string word = small_letters(words[0]);
  const bool yes = word == "1" || word == "yes" || word == "true";
  if (!yes && word != "0" && word != "no" && word != "false") return unreadable;
  if (yes == truth.yes) return {};
  return {true, yes ? "false yes" : "false no"};
}

Mark marked_location(const Truth& truth, const std::vector<std::string_view>& words) {
  if (words.size() != 1) return unreadable;
  const std::string word = small_letters(words[0]);
  if (word != "in" && word != "on" && word != "out") return unreadable;
  return {true, word == truth.location ? "" : fmt::format("{} for {}", word, truth.location)};
}

/// A number for each of the true ones, or a miss.
Mark marked_values(const Task& task, const Truth& truth, const std::vector<std::string_view>& words) {
  const std::size_t count = task.output == Output::span ? 2 : 1;
  if (words.size() == 1 && small_letters(words[0]) == "miss") return {true, truth.yes ? "false miss" : ""};
  const auto said = numbers_in(words);
  if (!said || said->size() != count) return unreadable;
  if (!truth.yes) return {true, "false hit"};
  Mark mark;
  for (std::size_t i = 0; i < count; ++i) mark.ulps = std::max(mark.ulps, ulps_off((*said)[i], truth.numbers[i]));
  if (!(mark.ulps <= task.ulps)) mark.fault = "wrong value";
  return mark;
}

/// Any of the nearest is right.
Mark marked_nearest(const Task& task, const Truth& truth, const std::vector<std::string_view>& words) {
  if (words.size() == 1 && small_letters(words[0]) == "miss") return {true, truth.yes ? "false miss" : ""};
  const auto said = numbers_in(words);
  if (!said || said->size() != 2) return unreadable;
  const double index = (*said)[0];
  if (!(index >= 0 && index < static_cast<double>(truth.numbers.size()) && index == std::floor(index)))
    return unreadable;
  if (!truth.yes) return {true, "false hit"};
  double least = INFINITY;
  for (const double t : truth.numbers)
    if (t < least) least = t;
  const double of_said = truth.numbers[static_cast<std::size_t>(index)];
  if (!(ulps_off(of_said, least) <= task.ulps)) return {true, "wrong sphere"};
  Mark mark = {true, "", ulps_off((*said)[1], of_said)};
  if (!(mark.ulps <= task.ulps)) mark.fault = "wrong value";
  return mark;
}

/// The same corners in the same sense, from any of them on.
Mark marked_corners(const Truth& truth, const std::vector<std::string_view>& words) {
  const auto said = numbers_in(words);
  if (!said || said->empty() || !((*said)[0] * 2 + 1 == static_cast<double>(said->size()))) return unreadable;
  std::vector<double> corners(said->begin() + 1, said->end());
  if (corners.size() > truth.numbers.size()) return {true, "too many corners"};
  if (corners.size() < truth.numbers.size()) return {true, "too few corners"};
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    if (corners == truth.numbers) return {};
    std::rotate(corners.begin(), corners.begin() + 2, corners.end());
  }
  return {true, corners == truth.numbers ? "" : "other corners, or another order"};
}

Mark marked_pairs(const Truth& truth, const std::vector<std::string_view>& words) {
  const auto said = numbers_in(words);
  if (!said || said->empty() || !((*said)[0] * 2 + 1 == static_cast<double>(said->size()))) return unreadable;
  const auto pairs_of = [](const double* at, std::size_t count) {
    std::vector<std::pair<double, double>> pairs;
    for (std::size_t i = 0; i < count; i += 2) pairs.emplace_back(std::minmax(at[i], at[i + 1]));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  };
  const auto found = pairs_of(said->data() + 1, said->size() - 1);
  const auto right = pairs_of(truth.numbers.data(), truth.numbers.size());
  if (found == right) return {};
  const bool none_false = std::includes(right.begin(), right.end(), found.begin(), found.end());
  const bool all_there = std::includes(found.begin(), found.end(), right.begin(), right.end());
  return {true, none_false ? "missing pairs" : all_there ? "pairs too many" : "missing and false pairs"};
}

}  // namespace

double ulps_off(double said, double true_value) {
  if (said == true_value) return 0;
  if (!std::isfinite(said) || !std::isfinite(true_value)) return INFINITY;
  const double size = std::max(std::abs(true_value), 1.0);
  const double ulp = std::ldexp(1.0, std::ilogb(size) - 52);
  return std::abs(said / ulp - true_value / ulp);
}

std::string harmless(std::string_view text, std::size_t most) {
  std::string shown;
  for (const char c : text) {
    const bool plain = ' ' <= c && c <= '~' && c != '<' && c != '>' && c != '&' && c != '\\';
    std::string next = plain ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    if (shown.size() + next.size() > most) return shown + "...";
    shown += next;
  }
  return shown;
}

Mark marked(const Task& task, const Truth& truth, std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  switch (task.output) {
    case Output::yes_no:
      return marked_yes_no(truth, words);
    case Output::location:
      return marked_location(truth, words);
    case Output::corners:
      return marked_corners(truth, words);
    case Output::pairs:
      return marked_pairs(truth, words);
    case Output::nearest:
      return marked_nearest(task, truth, words);
    default:
      return marked_values(task, truth, words);
  }
}

}  // namespace isect::grade
