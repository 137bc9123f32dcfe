#include "viz/window/number_text.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "viz/lesson.h"

namespace isect::viz {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

/// sum = product {(+|-) product}, product = factor {(*|/) factor}, factor = [+|-] (number | pi | "(" sum ")").
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
  static constexpr int deepest = 40;  // signs and brackets

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
    double value = factor(depth);
    for (;;) {
      if (take('*')) {
        value *= factor(depth);
      } else if (take('/')) {
        const double by = factor(depth);
        if (by == 0) fail("it divides by 0");
        value /= by;
      } else {
        return value;
      }
    }
  }
  double factor(int depth) {
    if (depth > deepest) fail("too many brackets and signs");
    if (take('-')) return -factor(depth + 1);
    if (take('+')) return factor(depth + 1);
    if (take('(')) {
      const double value = sum(depth + 1);
      if (!take(')')) fail("a bracket is not closed");
      return value;
    }
    if (next() == 'p' && text_.compare(at_, 2, "pi") == 0) {
      at_ += 2;
      return std::numbers::pi;
    }
    return number();
  }
  double number() {
    const char c = next();
    if (c == '\0') fail("a number is missing");
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const bool word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');  // "inf", "nan"
    if (word || error == std::errc::invalid_argument) fail("“" + text_.substr(at_) + "” is not a number");
    if (error == std::errc::result_out_of_range)
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
  for (const auto& [from, to] : {std::pair{"−", "-"}, {"·", "*"}, {"×", "*"}, {"π", "pi"}, {",", "."}, {"\t", " "}})
    plain = replaced(plain, from, to);
  return Reader(plain).all();
}

}  // namespace isect::viz
