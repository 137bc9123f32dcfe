#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "viz/files.h"
#include "viz/formats.h"
#include "viz/window/session.h"

namespace isect::viz {
namespace {

using Json = nlohmann::ordered_json;

/// The field, or `fallback` where it is missing or of another type.
template <class T>
T field(const Json& from, const char* name, T fallback) {
  const auto found = from.find(name);
  if (found == from.end()) return fallback;
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    return fallback;
  }
}

ThemeName theme_field(const Json& from, const char* name, ThemeName fallback) {
  try {
    return theme_named(field(from, name, name_of(fallback)));
  } catch (const BadInput&) {
    return fallback;
  }
}

std::optional<Place> place_field(const Json& from, const std::vector<const Lesson*>& lessons) {
  const auto found = from.find("place");
  if (found == from.end()) return std::nullopt;
  try {
    return place_from_json(found->dump(), lessons);
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

/// Empty if it is no JSON object.
Json parsed(const std::string& file) {
  try {
    const Json json = Json::parse(read_regular_file(file), nullptr, false);
    return json.is_object() ? json : Json();
  } catch (const FileError&) {
    return {};
  }
}

}  // namespace

std::string settings_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && *state == '/') return std::string(state) + "/isect/window.json";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.local/state/isect/window.json" : std::string();
}

Settings read_settings(const std::string& file, const std::vector<const Lesson*>& lessons) {
  Settings s;
  if (file.empty()) return s;
  const Json json = parsed(file);
  if (json.is_null()) return s;
  s.theme = theme_field(json, "theme", s.theme);
  s.save_theme = theme_field(json, "save_theme", s.save_theme);
  const Format* const format = format_of("." + field(json, "save_format", s.save_format));
  if (format && format->write) s.save_format = format->name;
  s.parameters_open = field(json, "parameters_open", s.parameters_open);
  s.speed = std::clamp(field(json, "speed", s.speed), 0.5, 2.0);
  s.width = std::clamp(field(json, "width", s.width), 800, 16000);
  s.height = std::clamp(field(json, "height", s.height), 500, 16000);
  s.place = place_field(json, lessons);
  return s;
}

std::string set_spoilt_settings_aside(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (file.empty() || !fs::exists(file, error) || !parsed(file).is_null()) return {};
  std::string aside = file + ".damaged";
  for (int i = 2; fs::exists(aside, error); ++i) aside = fmt::format("{}.damaged-{}", file, i);
  fs::rename(file, aside, error);
  return error ? fmt::format("{} is damaged, and the window starts afresh. It can't be moved aside: {}", file,
                             error.message())
               : fmt::format("{} is damaged, and the window starts afresh. It is kept as {}", file, aside);
}

void write_settings(const std::string& file, const Settings& s) {
  if (file.empty()) return;
  Json json = {{"theme", name_of(s.theme)},
               {"save_theme", name_of(s.save_theme)},
               {"save_format", s.save_format},
               {"parameters_open", s.parameters_open},
               {"speed", s.speed},
               {"width", s.width},
               {"height", s.height}};
  if (s.place) json["place"] = Json::parse(to_json(*s.place));
  write_file(file, json.dump(2) + "\n");
}

}  // namespace isect::viz
