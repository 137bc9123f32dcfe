#include "bench/prose.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace isect::bench {

std::string count(long n) {
  const std::string digits = std::to_string(std::abs(n));
  std::string text = n < 0 ? "−" : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string number(double x) {
  if (std::isinf(x)) return "∞";
  if (x == 0 || (std::abs(x) < 1000 && std::abs(x) >= 1e-3)) return fmt::format("{:.3g}", x);
  if (std::abs(x) >= 1e7 || std::abs(x) < 1e-3) {
    const double exponent = std::floor(std::log10(std::abs(x)));
    return fmt::format("{:.2g}e{:.0f}", x / std::pow(10, exponent), exponent);
  }
  const double magnitude = std::pow(10, std::floor(std::log10(std::abs(x))) - 2);
  return count(std::lround(std::round(x / magnitude) * magnitude));
}

std::string share(double wrong, double of) {
  if (!(wrong > 0)) return "none";
  const double part = wrong / of;
  if (part < 1e-4) return fmt::format("{:.0f} in a million", 1e6 * part);
  return fmt::format("{} %", part >= 0.1 ? fmt::format("{:.0f}", 100 * part) : fmt::format("{:.2g}", 100 * part));
}

std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string ratio_text(double x) {
  return x >= 10 ? number(std::stod(fmt::format("{:.2g}", x))) : fmt::format("{:.2g}", x);
}

std::string with_interval(double x, double lo, double hi) {
  const std::string middle = number(x), from = number(lo), to = number(hi);
  return from == middle && to == middle ? middle : fmt::format("{} [{}, {}]", middle, from, to);
}

}  // namespace isect::bench
