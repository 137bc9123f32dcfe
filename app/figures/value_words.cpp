#include "app/figures/value_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/text/rich_text.h"

namespace isect::program {

namespace {

/// Returns how far five digits are from the number, relative to it.
double lost(double x) {
  return x == 0 || !std::isfinite(x) ? 0 : std::abs(std::stod(fmt::format("{:.4e}", x)) / x - 1);
}

/// Whether all digits are told: for a number that has few, or lies next to a number of five digits.
bool wants_all(double x) {
  constexpr std::size_t few = 12;  // letters
  constexpr double next = 1e-9;
  return viz::to_text(x).size() <= few || lost(x) < next;
}

std::string all_digits(double x) {
  return lost(x) == 0 ? viz::shown_with_sign(x) : viz::with_minus_signs(viz::to_text(x));
}
std::string number_in_words(double x) { return wants_all(x) ? all_digits(x) : viz::shown(x); }

template <class Told>
std::string each(const viz::Setting& setting, bool flat, const Told& told) {
  if (const auto* text = std::get_if<std::string>(&setting)) return *text;
  if (const auto* number = std::get_if<double>(&setting)) return told(*number);
  const auto& p = std::get<viz::Vec3>(setting);
  return "(" + told(p.x()) + ", " + told(p.y()) + (flat ? ")" : ", " + told(p.z()) + ")");
}

}  // namespace

std::string in_full(const viz::Setting& setting, bool flat) {
  return each(setting, flat, [](double x) { return viz::to_text(x); });
}

std::string in_words(const viz::Setting& setting, bool flat) { return each(setting, flat, number_in_words); }

std::string in_words_and_full(const viz::Setting& setting, bool flat) { return each(setting, flat, all_digits); }

bool rounded_in_words(const viz::Setting& setting) {
  const auto rounded = [](double x) { return !wants_all(x); };
  if (const auto* number = std::get_if<double>(&setting)) return rounded(*number);
  const auto* p = std::get_if<viz::Vec3>(&setting);
  return p && std::ranges::any_of(*p, rounded);
}

}  // namespace isect::program
