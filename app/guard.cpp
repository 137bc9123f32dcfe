#include "app/guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/shell/option_values.h"
#include "viz/lesson.h"
#include "viz/theme.h"

namespace isect::program {

namespace {

using GuardJson = nlohmann::ordered_json;

constexpr std::size_t most_guards = 16;
const std::vector<std::string> guarded_formats = {"png", "svg", "tikz"};

/// Returns the look without what is usual, and with its lengths in one unit.
Guard read_guard(const GuardJson& json) {
  if (!json.is_object() || json.empty())
    throw viz::BadInput(fmt::format("{} is no look; give an object, such as {{\"theme\": \"dark\"}}", json.dump()));
  Guard guard;
  for (const auto& [field, value] : json.items()) {
    const std::array all = {std::pair{"theme", &guard.theme}, std::pair{"size", &guard.size},
                            std::pair{"width", &guard.width}, std::pair{"format", &guard.format}};
    const auto known = std::ranges::find(all, field, [](const auto& of) { return std::string(of.first); });
    if (known == all.end()) throw viz::unknown("field", field, {"theme", "size", "width", "format"});
    if (!value.is_string()) throw viz::BadInput(fmt::format("{}: {} is no text", field, value.dump()));
    *known->second = value.get<std::string>();
  }
  if (std::ranges::find(guarded_formats, guard.format) == guarded_formats.end())
    throw viz::unknown("format", guard.format, guarded_formats);
  if (!guard.size.empty() && !guard.width.empty())
    throw viz::BadInput("size: give either size (pixels) or width (on paper), not both");
  if (!guard.width.empty() && guard.format == "png")
    throw viz::BadInput("width: it is for svg and tikz; give the size of a png in pixels, such as 640x480");
  if (!guard.theme.empty() && viz::theme_named(guard.theme) == viz::ThemeName::screen) guard.theme.clear();
  if (!guard.size.empty()) {
    const Size size = size_of(guard.size), usual;
    const bool as_usual = size.width == usual.width && size.height == usual.height && guard.format != "tikz";
    guard.size = as_usual ? "" : fmt::format("{}x{}", size.width, size.height);
  }
  constexpr double cm_in_points = 72 / 2.54;
  if (!guard.width.empty()) guard.width = fmt::format("{:.4g}cm", points_of("width", guard.width) / cm_in_points);
  return guard;
}

}  // namespace

std::string Guard::name() const {
  std::string text = theme;
  for (const std::string& part : {size, width})
    if (!part.empty()) text += (text.empty() ? "" : "-") + part;
  return text;
}

std::string Guard::file(const std::string& stem) const {
  const std::string look = name();
  return stem + (look.empty() ? "" : "." + look) + "." + format;
}

std::vector<Guard> guards_in(const std::string& text) {
  const GuardJson json = GuardJson::parse(text, nullptr, false, true);  // scenes may have comments
  if (!json.is_object() || !json.contains("guard")) return {};
  const GuardJson& list = json["guard"];
  if (!list.is_array())
    throw viz::BadInput(fmt::format("guard: {} is no list of looks, such as [{{\"theme\": \"dark\"}}]", list.dump()));
  if (list.size() > most_guards)
    throw viz::BadInput(fmt::format("guard: {} looks are listed, and {} are the most", list.size(), most_guards));
  std::vector<Guard> guards;
  for (const GuardJson& entry : list) {
    const std::string place = fmt::format("guard {}: ", guards.size() + 1);
    try {
      guards.push_back(read_guard(entry));
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(place + e.what());
    }
    const Guard& last = guards.back();
    if (last == Guard{}) throw viz::BadInput(place + "this is the usual look, which is guarded anyway");
    if (std::ranges::find(guards.begin(), guards.end() - 1, last) != guards.end() - 1)
      throw viz::BadInput(place + "this look is listed before");
  }
  return guards;
}

}  // namespace isect::program
