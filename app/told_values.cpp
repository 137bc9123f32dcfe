#include "app/told_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/closing.h"
#include "viz/rich_text.h"

namespace isect::program {

using viz::plain;

namespace {

/// How far five digits are from the number, as a share of it.
double lost(double x) {
  return x == 0 || !std::isfinite(x) ? 0 : std::abs(std::stod(fmt::format("{:.4e}", x)) / x - 1);
}

/// Of a number that was typed as a short one and then moved by hardly anything, the last digits matter.
constexpr double hardly_anything = 1e-9;

std::string number_in_words(double x) {
  if (lost(x) == 0 || lost(x) > hardly_anything) return viz::shown(x);
  return viz::with_minus_signs(viz::to_text(x));
}

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

bool rounded_in_words(const viz::Setting& setting) {
  if (const auto* number = std::get_if<double>(&setting)) return lost(*number) > hardly_anything;
  const auto* p = std::get_if<viz::Vec3>(&setting);
  return p && std::ranges::any_of(*p, [](double x) { return lost(x) > hardly_anything; });
}

std::vector<std::string> told_errata(const viz::Lesson& lesson, const viz::Walk& walk, std::string viz::Preset::*name) {
  std::vector<std::string> all;
  for (const viz::Erratum& erratum : lesson.errata) {
    const int line = viz::line_of(erratum, walk);
    if (line < 0) continue;
    const std::string shown_by = viz::preset(lesson, erratum.preset).*name;
    const bool published = walk.pseudocode[line] == erratum.published;
    if (!published && std::ranges::count(walk.pseudocode, erratum.published) > 0) {
      all.push_back(
          fmt::format("Line {} is not in the note. {} (See the preset “{}”.)", line + 1, plain(erratum.why), shown_by));
      continue;
    }
    const std::string& other = published ? erratum.corrected : erratum.published;
    all.push_back(fmt::format("Line {} {}: {}. {} (See the preset “{}”.)", line + 1,
                              published ? "should read" : "was published as", viz::unindented(other),
                              plain(erratum.why), shown_by));
  }
  return all;
}

}  // namespace isect::program
