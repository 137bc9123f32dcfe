#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "viz/formats/files.h"
#include "viz/formats/formats.h"
#include "viz/snapshot/json.h"
#include "viz/window/window_session.h"

namespace isect::viz {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the field, or `fallback` if it is missing or of another type.
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

/// A size that no screen has is a damaged field. Read as a double first: the library wraps what no int holds.
int size_field(const Json& from, const char* name, int least, int fallback) {
  const double px = field(from, name, static_cast<double>(fallback));
  return px >= least && px <= 16000 ? static_cast<int>(px) : fallback;
}

ThemeName theme_field(const Json& from, const char* name, ThemeName fallback) {
  try {
    return theme_named(field(from, name, name_of(fallback)));
  } catch (const BadInput&) {
    return fallback;
  }
}

std::optional<ReaderState> place_field(const Json& from, const std::vector<const Lesson*>& lessons) {
  const auto found = from.find("place");
  if (found == from.end()) return std::nullopt;
  try {
    return reader_state_from_json(found->dump(), lessons);
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

std::optional<Beside> beside_field(const Json& from) {
  const auto found = from.find("beside");
  if (found == from.end() || !found->is_object()) return std::nullopt;
  const auto text = [&](const char* name) { return field(*found, name, std::string()); };
  Beside beside{text("lesson"), text("method"), text("preset")};
  if (beside.method.empty() == beside.preset.empty()) return std::nullopt;
  return beside;
}

/// Returns the texts of a list; what is none is left out.
std::set<std::string> texts_field(const Json& from, const char* name) {
  std::set<std::string> texts;
  const auto found = from.find(name);
  if (found == from.end() || !found->is_array()) return texts;
  for (const Json& text : *found)
    if (text.is_string()) texts.insert(text.get<std::string>());
  return texts;
}

/// Returns a number of steps; 0 where there is none.
int count_field(const Json& from, const char* name) {
  constexpr double most = 30'000;  // the product of two fits into an int
  const double count = field(from, name, 0.0);
  return count >= 1 && count <= most ? static_cast<int>(count) : 0;
}

std::map<std::string, Score> scores_field(const Json& from) {
  std::map<std::string, Score> scores;
  const auto found = from.find("scores");
  if (found == from.end() || !found->is_object()) return scores;
  for (const auto& lesson : found->items()) {
    if (!lesson.value().is_object()) continue;
    Score& score = scores[lesson.key()];
    score.finished = field(lesson.value(), "finished", false);
    score.skipped = texts_field(lesson.value(), "skipped");
    score.solved = texts_field(lesson.value(), "solved");
    score.seen = count_field(lesson.value(), "seen"), score.of = count_field(lesson.value(), "of");
    if (score.seen > score.of) score.seen = score.of = 0;
    const Json answers = lesson.value().value("answers", Json::object());
    if (!answers.is_object()) continue;
    for (const auto& answer : answers.items())
      if (answer.value().is_boolean()) score.answers[answer.key()] = answer.value().get<bool>();
  }
  return scores;
}

std::vector<HourPlace> hours_field(const Json& from) {
  std::vector<HourPlace> hours;
  const auto found = from.find("hours");
  if (found == from.end() || !found->is_array()) return hours;
  for (const Json& hour : *found) {
    if (!hour.is_object() || hours.size() == hours_kept) continue;
    HourPlace place{field(hour, "file", std::string())};
    const int stop = count_field(hour, "stop");
    place.stop = std::max(stop - 1, 0), place.step = stop > 0 ? count_field(hour, "step") - 1 : -1;
    if (place.file.starts_with('/')) hours.push_back(std::move(place));
  }
  return hours;
}

Json json_of(const HourPlace& hour) {
  Json kept = {{"file", hour.file}, {"stop", hour.stop + 1}};
  if (hour.step >= 0) kept["step"] = hour.step + 1;
  return kept;
}

/// Returns the record of answers. Throws BadInput where it is damaged. A file from before there was one knows at least
/// how each question was answered the last time.
AnswerRecord record_field(const Json& from, const std::map<std::string, Score>& scores) {
  if (const auto found = from.find("record"); found != from.end()) return answer_record_from(found->dump());
  AnswerRecord record;
  for (const auto& [lesson, score] : scores)
    for (const auto& [question, right] : score.answers) record.lessons[lesson][question] = {right, 1, right ? 0 : 1, 0};
  return record;
}

/// Returns why the record can't be read; empty if it can.
std::string damage_of_record(const Json& from) {
  try {
    record_field(from, {});
    return {};
  } catch (const BadInput& damage) {
    return damage.what();
  }
}

Json json_of(const std::map<std::string, Score>& scores) {
  Json all = Json::object();
  for (const auto& [lesson, score] : scores) {
    const bool touched = score.of > 0 || !score.skipped.empty() || !score.solved.empty();
    if (!score.finished && score.answers.empty() && !touched) continue;
    Json& kept = all[lesson];
    kept = {{"finished", score.finished}, {"answers", score.answers}};
    if (!score.skipped.empty()) kept["skipped"] = score.skipped;
    if (!score.solved.empty()) kept["solved"] = score.solved;
    if (score.of > 0) kept["seen"] = score.seen, kept["of"] = score.of;
  }
  return all;
}

/// Returns a new name beside a file, for one that is damaged, or newer than this program.
std::string name_aside(const std::string& file, const std::string& kind = "damaged") {
  std::error_code error;
  std::string aside = fmt::format("{}.{}", file, kind);
  for (int i = 2; std::filesystem::exists(aside, error); ++i) aside = fmt::format("{}.{}-{}", file, kind, i);
  return aside;
}

/// Keeps a copy of a file under another name. Returns where it is, or why it is nowhere.
std::string copied(const std::string& file, const std::string& aside) {
  std::error_code error;
  std::filesystem::copy_file(file, aside, error);
  return error ? "The file can't be copied: " + error.message() : "A copy of the file is kept as " + aside;
}

/// Returns the version of the file; 1 where it names none.
double version_of(const Json& from) { return field(from, "version", 1.0); }

/// Returns the parsed file; empty if it is no JSON object.
Json parsed(const std::string& file) {
  try {
    const Json json = snap::parsed(read_regular_file(file));
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
  s.nonstop = field(json, "nonstop", s.nonstop);
  s.width = size_field(json, "width", least_width, s.width);
  s.height = size_field(json, "height", least_height, s.height);
  s.reduced_motion = field(json, "reduced_motion", s.reduced_motion);
  s.map = field(json, "map", s.map);
  s.size = std::clamp(field(json, "size", s.size), least_size, most_size);
  const double cm = field(json, "save_width_cm", s.save_width_cm);
  if (cm >= least_width_cm && cm <= most_width_cm) s.save_width_cm = cm;
  s.save_folder = field(json, "save_folder", s.save_folder);
  if (!s.save_folder.starts_with('/')) s.save_folder.clear();
  s.reader_state = place_field(json, lessons);
  s.beside = beside_field(json);
  s.scores = scores_field(json);
  try {
    s.record = record_field(json, s.scores);
  } catch (const BadInput&) {  // told, and kept, by set_spoilt_settings_aside
    s.record = {};
  }
  s.recent = field(json, "recent", s.recent);
  std::erase_if(s.recent, [&](const std::string& id) {
    return std::ranges::none_of(lessons, [&](const Lesson* l) { return l->id == id; });
  });
  if (s.recent.size() > recent_kept) s.recent.resize(recent_kept);
  s.saved = field(json, "saved", s.saved);
  if (s.saved.size() > saved_kept) s.saved.resize(saved_kept);
  s.hours = hours_field(json);
  return s;
}

std::string set_spoilt_settings_aside(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return {};
  const std::string aside = name_aside(file);
  if (const Json json = parsed(file); !json.is_null()) {
    if (const std::string why = damage_of_record(json); !why.empty())
      return fmt::format("The answers kept in {} can't be read ({}) and start afresh. {}", file, why,
                         copied(file, aside));
    if (version_of(json) > settings_version)
      return fmt::format("{} was written by a newer isect, of which this one keeps what it knows. {}", file,
                         copied(file, name_aside(file, "newer")));
    return {};
  }
  fs::rename(file, aside, error);
  return error ? fmt::format("{} is damaged, and the window starts afresh. It can't be moved aside: {}", file,
                             error.message())
               : fmt::format("{} is damaged, and the window starts afresh. It is kept as {}", file, aside);
}

std::string text_of(const Settings& s) {
  Json json = {{"version", settings_version},
               {"theme", name_of(s.theme)},
               {"save_theme", name_of(s.save_theme)},
               {"save_format", s.save_format},
               {"parameters_open", s.parameters_open},
               {"speed", s.speed},
               {"nonstop", s.nonstop},
               {"width", s.width},
               {"height", s.height},
               {"reduced_motion", s.reduced_motion},
               {"map", s.map},
               {"size", s.size},
               {"save_width_cm", s.save_width_cm},
               {"save_folder", s.save_folder},
               {"recent", s.recent},
               {"saved", s.saved},
               {"scores", json_of(s.scores)},
               {"record", Json::parse(text_of(s.record))}};
  if (const auto& b = s.beside) json["beside"] = {{"lesson", b->lesson}, {"method", b->method}, {"preset", b->preset}};
  for (const HourPlace& hour : s.hours) json["hours"].push_back(json_of(hour));
  if (s.reader_state) json["place"] = Json::parse(to_json(*s.reader_state));
  return json.dump(2) + "\n";
}

void write_settings(const std::string& file, const Settings& s) {
  if (!file.empty()) write_file(file, text_of(s));
}

}  // namespace isect::viz
