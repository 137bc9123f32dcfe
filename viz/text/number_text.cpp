#include "viz/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include "viz/lesson.h"

namespace isect::viz {
namespace {

std::string substituted(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

/// sum = product {(+|-) product}, product = signed {(*|/) signed | word}, signed = {+|-} power,
/// power = factor [^ signed], factor = number | "(" sum ")" | word, word = "pi" | "sqrt" factor.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  double all() {
    const double value = sum(0);
    if (const char c = next(); c != '\0') fail(std::string("“") + text_.substr(at_) + "” does not belong to a number");
    if (!std::isfinite(value)) fail("that is no finite number");
    return value;
  }

 private:
  static constexpr int deepest = 40;  // signs, brackets, roots and exponents

  static bool is_e(char c) { return c == 'e' || c == 'E'; }
  [[noreturn]] static void fail(const std::string& why) { throw BadInput(why); }
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  bool at_word(std::string_view word) {
    next();
    return text_.compare(at_, word.size(), word) == 0;
  }
  bool take_word(std::string_view word) {
    if (!at_word(word)) return false;
    at_ += word.size();
    return true;
  }

  double sum(int depth) {
    double value = product(depth);
    for (;;) {
      if (take('+'))
        value += product(depth);
      else if (take('-'))
        value -= product(depth);
      else
        return value;
    }
  }
  double product(int depth) {
    double value = signed_power(depth);
    for (;;) {
      if (take('*')) {
        value *= signed_power(depth);
      } else if (take('/')) {
        const double by = signed_power(depth);
        if (by == 0) fail("it divides by 0");
        value /= by;
      } else if (at_word("pi") || at_word("sqrt")) {  // 2π, 2√3
        value *= power(depth);
      } else {
        return value;
      }
    }
  }
  double signed_power(int depth) {
    if (depth > deepest) fail("too many brackets and signs");
    if (take('-')) return -signed_power(depth + 1);
    if (take('+')) return signed_power(depth + 1);
    return power(depth);
  }
  double power(int depth) {
    const double base = factor(depth);
    if (!take('^')) return base;
    return std::pow(base, signed_power(depth + 1));
  }
  double factor(int depth) {
    if (depth > deepest) fail("too many brackets and signs");
    if (take('(')) {
      const double value = sum(depth + 1);
      if (!take(')')) fail("a bracket is not closed");
      return value;
    }
    if (take_word("pi")) return std::numbers::pi;
    if (take_word("sqrt")) {
      const double square = factor(depth + 1);
      if (square < 0) fail("it takes the root of a negative number");
      return std::sqrt(square);
    }
    return number();
  }
  double number() {
    const char c = next();
    if (c == '\0') fail("a number is missing");
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const bool digits = (c >= '0' && c <= '9') || c == '.';  // and not "inf", "nan"
    if (!digits || error == std::errc::invalid_argument) fail("“" + text_.substr(at_) + "” is not a number");
    const auto nonzero = [](char d) { return d >= '1' && d <= '9'; };
    const bool lost = value == 0 && std::any_of(begin, std::find_if(begin, end, is_e), nonzero);
    if (error == std::errc::result_out_of_range || lost)
      fail("“" + std::string(begin, end) + "” is beyond the range of numbers");
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

double number_from(const std::string& text) {
  std::string plain = text;
  // A dash is a minus on some keyboards; thin spaces group digits.
  for (const auto& [from, to] : {std::pair{"−", "-"},
                                 {"–", "-"},
                                 {"·", "*"},
                                 {"⋅", "*"},
                                 {"×", "*"},
                                 {"÷", "/"},
                                 {"⁄", "/"},
                                 {"π", "pi"},
                                 {"√", "sqrt"},
                                 {"²", "^2"},
                                 {"³", "^3"},
                                 {",", "."},
                                 {"\t", " "},
                                 {"\u00a0", " "},
                                 {"\u2009", ""},
                                 {"\u202f", ""}})
    plain = substituted(plain, from, to);
  return Reader(plain).all();
}

}  // namespace isect::viz
