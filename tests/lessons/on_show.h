#pragma once
// What is on show while a question is open, as numbers: those of its prompt, and the values beside it.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/text/rich_text.h"
#include "viz/walk/question_scene.h"

namespace isect::tests::on_show {

using namespace viz;

/// Numbers in their order; asking for one that is not there throws.
struct Numbers : std::vector<double> {
  using std::vector<double>::vector;
  double operator[](std::size_t i) const { return at(i); }
};

/// 500 000 is one number.
inline std::string without_thin_spaces(std::string text) {
  for (std::size_t at; (at = text.find("\u2009")) != text.npos;) text.erase(at, 3);
  return text;
}

/// A number as readers see it: "−1.121 · 10⁸" is not one here, as no question has such.
inline std::optional<double> number_in(std::string text) {
  text = without_thin_spaces(std::move(text));
  for (std::size_t at; (at = text.find("−")) != text.npos;) text.replace(at, 3, "-");
  std::size_t end = 0;
  try {
    const double x = std::stod(text, &end);
    return end == text.size() ? std::optional(x) : std::nullopt;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

/// The text with powers of ten written out: "5.5 · 10⁻³" becomes 0.0055.
inline std::string without_powers(std::string text) {
  static const std::vector<std::string> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  static const std::regex power("([0-9.]+)[^0-9a-z]{0,4}·[^0-9a-z]{0,4}10((⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+)");
  for (std::smatch found; std::regex_search(text, found, power);) {
    std::string exponent = found[2];
    for (std::size_t i = 0; i < raised.size(); ++i)
      for (std::size_t at; (at = exponent.find(raised[i])) != exponent.npos;)
        exponent.replace(at, raised[i].size(), std::to_string(i));
    if (exponent.starts_with("⁻")) exponent.replace(0, std::string("⁻").size(), "-");
    const std::string number = fmt::format("{:.40f}", std::stod(found[1].str() + "e" + exponent));
    text = found.prefix().str() + number + found.suffix().str();
  }
  return text;
}

/// All numbers of a text, in their order.
inline Numbers numbers_in(const std::string& text) {
  Numbers all;
  std::string word;
  const std::string digits = "0123456789.";
  const std::string words = without_powers(without_thin_spaces(text)) + " ";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool minus = words.compare(i, 3, "−") == 0;
    if (minus && word.empty()) {
      word = "-", i += 2;
    } else if (digits.find(words[i]) != digits.npos) {
      word += words[i];
    } else {
      while (word.ends_with('.')) word.pop_back();
      if (const auto x = number_in(word)) all.push_back(*x);
      word = minus ? "-" : "", i += minus ? 2 : 0;
    }
  }
  return all;
}

/// The numbers that a reader can answer from: the prompt's, and the values on show by their plain names.
struct OnShow {
  Numbers told;
  std::map<std::string, double> values = {};
  std::string code = {};  ///< the pseudocode beside it
  double operator()(const std::string& name) const {
    const auto found = values.find(name);
    if (found == values.end()) throw std::out_of_range("no value on show is called " + name);
    return found->second;
  }
};

/// Returns what is on show while the question before step k is open.
inline OnShow shown_at(const Walk& walk, int k) {
  const Step asking = asking_step(walk, k);
  OnShow shown = {numbers_in(plain(asking.question->prompt))};
  for (const Value& value : asking.values) shown.values[plain(value.name)] = value.value;
  for (const std::string& line : walk.pseudocode) shown.code += line + "\n";
  return shown;
}

}  // namespace isect::tests::on_show
