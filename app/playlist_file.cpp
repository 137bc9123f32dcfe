#include "app/playlist_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/scene/lesson.h"
#include "app/scene/source.h"
#include "app/shell/named_file.h"
#include "app/shell/option_values.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

/// Whether the parameters are those of the preset that is named.
bool is_as_preset(const viz::Stop& stop) {
  return !stop.state.preset.empty() &&
         viz::preset(*stop.lesson, stop.state.preset).parameters == *stop.state.parameters;
}

/// Returns the stop's name, or "stop-7" for the seventh.
std::string name_or_number(const viz::Stop& stop, std::size_t number) {
  return stop.name.empty() ? fmt::format("stop-{}", number) : stop.name;
}

/// Reads the stops of one file. An error begins with its field.
class StopReader {
 public:
  StopReader(const Program& program, std::filesystem::path folder)
      : lessons_(program.lessons), folder_(std::move(folder)) {}

  viz::Stop read(const Json& stop, std::size_t number) {
    if (!stop.is_object())
      throw viz::BadInput(
          fmt::format("{} is no stop; give an object such as {{\"lesson\": \"ray-sphere\", \"preset\": "
                      "\"tangent\"}} or {{\"scene\": \"crates.json\"}}",
                      stop.dump()));
    viz::Stop read = stop.contains("scene") ? of_scene(stop) : names_file(stop) ? of_file(stop) : of_lesson(stop);
    if (stop.contains("note")) read.note = text(stop, "note");
    choose_steps(stop, read, name_or_number(read, number));
    return read;
  }

 private:
  static std::string text(const Json& stop, const std::string& field) {
    if (!stop.at(field).is_string())
      throw viz::BadInput(fmt::format("{}: {} is not allowed; give a text", field, stop.at(field).dump()));
    return stop.at(field);
  }

  static void only(const Json& stop, const std::string& of, const std::vector<std::string>& allowed) {
    for (const auto& item : stop.items())
      if (std::ranges::find(allowed, item.key()) == allowed.end())
        throw viz::unknown("field of " + of, item.key(), allowed);
  }

  static bool names_file(const Json& stop) {
    return stop.contains("preset") && stop.at("preset").is_string() && text(stop, "preset").ends_with(".json");
  }

  /// Returns the file that a field names.
  std::string path_in(const Json& stop, const std::string& field) const {
    const std::string name = text(stop, field);
    if (name.empty() || name.find('\0') != name.npos)
      throw viz::BadInput(fmt::format("{}: {} is no file's name", field, stop.at(field).dump()));
    return (folder_ / name).lexically_normal().string();
  }

  viz::Stop of_scene(const Json& stop) {
    only(stop, "a stop with a scene", {"scene", "steps", "note"});
    viz::Stop read;
    read.path = path_in(stop, "scene");
    read.name = std::filesystem::path(read.path).stem().string();
    read.lesson = &scene_in(read.path);
    read.state.lesson = read.lesson->id;
    read.state.parameters = read.lesson->presets.front().parameters;
    return read;
  }

  /// Returns the scene of a file: the same one each time.
  const viz::Lesson& scene_in(const std::string& path) {
    const auto known = scenes_.find(path);
    if (known != scenes_.end()) return *known->second;
    try {
      const std::string text = read_named_file(path), folder = std::filesystem::path(path).parent_path().string();
      const SaidLater busy = deciding(path);
      const viz::Lesson* const made = scene::naming_scene(path, [&] { return &scene::kept_lesson_of(text, folder); });
      return *scenes_.emplace(path, made).first->second;
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(fmt::format("scene: {}: {}", path, e.what()));
    } catch (const viz::FileError& e) {
      throw viz::FileError(fmt::format("scene: {}", e.what()));
    }
  }

  viz::Stop of_file(const Json& stop) const {
    only(stop, "a stop with a preset's file", {"preset", "steps", "note"});
    viz::Stop read;
    read.path = path_in(stop, "preset");
    read.name = std::filesystem::path(read.path).stem().string();
    try {
      const std::string text = read_named_file(read.path);
      if (scene::is_scene(text)) throw viz::BadInput("it is a scene; write \"scene\" in place of \"preset\"");
      read.state = viz::reader_state_from_json(text, lessons_);
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(fmt::format("preset: {}: {}", read.path, e.what()));
    } catch (const viz::FileError& e) {
      throw viz::FileError(fmt::format("preset: {}", e.what()));
    }
    read.lesson = &viz::lesson_named(lessons_, read.state.lesson);
    return read;
  }

  viz::Stop of_lesson(const Json& stop) const {
    only(stop, "a stop",
         {"lesson", "preset", "step", "parameters", "camera", "beside", "time", "steps", "note", "scene"});
    if (!stop.contains("lesson"))
      throw viz::BadInput(
          "lesson: missing; give a lesson with a preset, a preset's file (\"preset\": \"NAME.json\"), or "
          "a scene's file (\"scene\": \"NAME.json\")");
    Json state = stop;
    state.erase("steps"), state.erase("note");
    viz::Stop read;
    read.lesson = &viz::lesson_named(lessons_, text(stop, "lesson"));
    if (!stop.contains("preset") && !stop.contains("parameters") && !read.lesson->presets.empty())
      state["preset"] = read.lesson->presets.front().id;
    read.state = viz::reader_state_from_json(state.dump(), lessons_);
    if (is_as_preset(read)) read.name = read.state.preset;
    return read;
  }

  /// `called`: in an error.
  static void choose_steps(const Json& stop, viz::Stop& read, const std::string& called) {
    std::string asked = read.state.step ? std::to_string(*read.state.step + 1) : "all";
    if (stop.contains("steps"))
      asked = stop.at("steps").is_number_integer() ? stop.at("steps").dump() : text(stop, "steps");
    const viz::Walk walk = read.lesson->walk(*read.state.parameters);
    const std::optional<Steps> wanted = Steps::read(asked);
    if (!wanted || !wanted->all_in(walk)) throw unknown_steps("steps", asked, walk, called);
    read.steps = wanted->of(walk);
    if (read.state.time && std::ranges::find(read.steps, *read.state.step) != read.steps.end())
      read.timed = read.state.step;
    else
      read.state.time.reset();
    read.state.step = read.steps.front();
    read.whole = read.steps.size() == walk.steps.size();
    read.asks = read.steps.front() > 0 && walk.steps[read.steps.front()].question.has_value();
  }

  const std::vector<const viz::Lesson*>& lessons_;
  std::filesystem::path folder_;
  std::map<std::string, const viz::Lesson*> scenes_;  ///< by path
};

/// Returns "stop 3, line 12: preset: why". The line is that of the field with which `why` begins, if the stop has it.
std::string told_of_stop(const scene::Source& source, std::size_t i, const std::string& why) {
  const int line = source.line_of({"stops", std::to_string(i), why.substr(0, why.find(':'))});
  return fmt::format("stop {}, line {}: {}", i + 1, line, why);
}

/// Returns what a stop is called that can't be opened: what it names.
std::string written_name(const Json& stop) {
  for (const char* field : {"scene", "preset", "lesson"})
    if (stop.is_object() && stop.contains(field) && stop.at(field).is_string()) return stop.at(field);
  return {};
}

viz::Playlist playlist_in(const Program& program, const std::string& path, const std::string& text, Faults faults) {
  constexpr std::size_t most_stops = 1000;
  const scene::Source source(text);
  const Json& json = source.json();
  source.only(json, {}, {"title", "stops"});
  const Json& stops = source.member(json, {}, "stops");
  source.list(stops, {"stops"}, 1, most_stops, "stops");
  viz::Playlist list;
  std::error_code nowhere;
  list.file = std::filesystem::absolute(path, nowhere).lexically_normal().string();
  if (json.contains("title")) list.title = source.text(json["title"], {"title"});
  StopReader reader(program, std::filesystem::path(path).parent_path());
  for (std::size_t i = 0; i < stops.size(); ++i) try {
      list.stops.push_back(reader.read(stops[i], i + 1));
    } catch (const viz::BadInput& e) {
      if (faults == Faults::refused) throw viz::BadInput(told_of_stop(source, i, e.what()));
      list.stops.push_back({.name = written_name(stops[i]), .fault = told_of_stop(source, i, e.what())});
    } catch (const viz::FileError& e) {
      if (faults == Faults::refused) throw viz::FileError(told_of_stop(source, i, e.what()));
      list.stops.push_back({.name = written_name(stops[i]), .fault = told_of_stop(source, i, e.what())});
    }
  return list;
}

}  // namespace

bool is_playlist(const std::string& text) {
  if (text.find("\"stops\"") == text.npos) return false;  // a large scene is not taken apart for this
  const scene::Spans spans(text);
  return spans.at("/stops") && !spans.at("/objects") && !spans.at("/lesson");
}

viz::Playlist read_playlist(const Program& program, const std::string& path, Faults faults) {
  const std::string text = read_named_file(path);
  try {
    return playlist_in(program, path, text, faults);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", path, e.what()));
  } catch (const viz::FileError& e) {
    throw viz::FileError(fmt::format("{}: {}", path, e.what()));
  }
}

std::string playlist_asked(const Selection& asked) {
  const std::string path = asked.lessons.empty() ? std::string() : asked.lessons.front();
  std::error_code absent;
  const bool file = path.ends_with(".json") && std::filesystem::is_regular_file(path, absent);
  if (!file || !is_playlist(viz::read_file(path))) return {};
  for (const auto& [option, given] :
       {std::pair("preset", !asked.preset.empty()), std::pair("step", !asked.step.empty()),
        std::pair("scene", !asked.scene.empty()), std::pair("set", !asked.changes.empty()),
        std::pair("answers", !asked.answers.empty()), std::pair("lang", !asked.lang.empty())})
    if (given)
      throw viz::BadInput(fmt::format("{}: not allowed with a playlist; each stop in {} names its own", option, path));
  return path;
}

std::vector<Excerpt> excerpts_of(const viz::Playlist& list) {
  std::vector<Excerpt> all;
  std::size_t number = 0;
  for (const viz::Stop& stop : list.stops) {
    ++number;
    if (!stop.fault.empty()) continue;
    Excerpt e;
    e.lesson = stop.lesson;
    e.folder = name_or_number(stop, number);
    if (is_as_preset(stop)) e.preset = stop.state.preset;
    e.parameters = *stop.state.parameters;
    e.walk = stop.lesson->walk(e.parameters);
    e.step = stop.timed, e.time = stop.state.time;
    draw_at_time(e);
    e.steps = stop.steps;
    e.camera = stop.state.camera;
    e.path = stop.path;
    sweep_shown_map(e);
    all.push_back(std::move(e));
  }
  return all;
}

}  // namespace isect::program
