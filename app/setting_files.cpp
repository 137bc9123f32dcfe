#include "app/setting_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "app/figures/figure_place.h"
#include "app/playlist_file.h"
#include "app/preset_folder.h"
#include "app/scene/lesson.h"
#include "app/scene/walks.h"
#include "app/shell/named_file.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

/// Returns where a file lies, links followed; the name of a pipe, such as <(command), which lies nowhere.
fs::path place_of(const std::string& path) {
  std::error_code nowhere;
  const fs::path place = fs::weakly_canonical(path, nowhere);
  return nowhere ? fs::absolute(path).lexically_normal() : place;
}

/// Returns the folder in which the files lie that a scene names: its own or, for what comes through a pipe, ours.
std::string folder_beside(const std::string& path) {
  std::error_code absent;
  return fs::is_regular_file(path, absent) ? fs::path(path).parent_path().string() : std::string();
}

/// Returns the objects of a file and the questions in it.
Excerpt from_scene(const std::string& text, const PresetFile& file) {
  const SaidLater busy = deciding(file.path);
  Excerpt e;
  e.lesson = scene::naming_scene(file.path, [&] { return &scene::kept_lesson_of(text, folder_beside(file.path)); });
  e.folder = file.name;
  e.path = file.path;
  e.guards = guards_in(text);
  e.parameters = e.lesson->presets.front().parameters;
  return e;
}

Excerpt at(const viz::Lesson& lesson, const viz::ReaderState& state, const std::string& folder) {
  Excerpt e;
  e.lesson = &lesson;
  e.folder = folder;
  e.preset = state.preset;
  e.parameters = *state.parameters;
  e.camera = state.camera;
  e.step = state.step;
  e.time = state.time;
  return e;
}

/// Returns the settings of a figure. The one that was drawn at a scale with others gets all of these.
std::vector<Excerpt> in_figure(const Program& program, const PresetFile& file, const viz::Format& format) {
  std::vector<const viz::Lesson*> lessons = program.lessons;
  const FigurePlace found = place_in_figure(program, file.path, format, lessons);
  const auto setting = [&](const FigurePlace& place) {
    Excerpt e = at(*place.lesson, place.state, place.folder.empty() ? file.name : place.folder);
    e.several = place.steps;
    e.style = found.style;
    return e;
  };
  std::vector<Excerpt> all;
  for (const FigurePlace& place : found.cases) all.push_back(setting(place));
  if (!all.empty() && !found.scaled_as) return all;
  std::vector<Excerpt> alone = {setting(found)};
  if (all.empty()) return alone;
  for (Excerpt& e : all) take_steps(e, e.several), sweep_shown_map(e);
  alone.front().scaled_as = *found.scaled_as;
  alone.front().scaled_with = std::make_shared<const std::vector<Excerpt>>(std::move(all));
  return alone;
}

}  // namespace

std::vector<PresetFile> named_files(const std::vector<std::string>& paths) {
  std::vector<PresetFile> files;
  std::set<fs::path> known;
  std::set<std::string> names;
  for (const std::string& path : paths)
    if (known.insert(place_of(path)).second) {
      files.push_back({path, path == "-" ? "stdin" : fs::path(path).stem().string()});
      names.insert(files.back().name);
    }
  if (names.size() == files.size()) return files;
  const fs::path first = *known.begin(), last = *known.rbegin();  // sorted: all lie where these two do
  fs::path above = first.parent_path();
  while (last.lexically_relative(above).string().starts_with("..")) above = above.parent_path();
  for (PresetFile& file : files) file.name = place_of(file.path).lexically_relative(above).replace_extension().string();
  return files;
}

std::vector<Excerpt> settings_in(const Program& program, const PresetFile& file) {
  if (std::error_code absent; fs::is_directory(file.path, absent))
    throw viz::FileError(
        fmt::format("preset: \"{0}\" is a folder; render --dir {0} draws all presets and scenes in it", file.path));
  if (const viz::Format* format = viz::format_of(file.path)) return in_figure(program, file, *format);
  viz::ReaderState state;
  std::vector<Guard> guards;
  try {
    require_utf8(file);
    const std::string text = read_named_file(file.path);
    if (scene::is_scene(text)) return {from_scene(text, file)};
    if (is_playlist(text))
      throw viz::BadInput(
          "this is a playlist, which show, handout, deck and quiz take; a preset's file has \"lesson\"");
    state = viz::reader_state_from_json(text, program.lessons);
    guards = guards_in(text);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", file.path, e.what()));
  }
  Excerpt e = at(viz::lesson_named(program.lessons, state.lesson), state, file.name);
  e.path = file.path;
  e.guards = std::move(guards);
  return {std::move(e)};
}

std::string method_for(const viz::Lesson& lesson, const std::vector<std::string>& presets) {
  if (presets.empty()) return {};
  const viz::Preset& preset = viz::preset(lesson, presets.front());
  const std::vector<std::string> known = scene::methods_for_many(lesson.id);
  if (const auto at = preset.parameters.find(lesson.group_by); at != preset.parameters.end() && presets.size() == 1)
    if (const auto* name = std::get_if<std::string>(&at->second);
        name && std::ranges::find(known, *name) != known.end())
      return *name;
  throw viz::BadInput(fmt::format("preset: beside --scene, whose objects are taken, {}",
                                  known.empty()
                                      ? lesson.id + " takes none"
                                      : fmt::format("it is for the method, one of {}", fmt::join(known, ", "))));
}

Excerpt setting_of_scene(const viz::Lesson& lesson, const std::string& method, const PresetFile& file) {
  require_utf8(file);
  try {
    Excerpt e;
    const std::string text = read_named_file(file.path);
    const SaidLater busy = deciding(file.path);
    e.lesson = scene::naming_scene(
        file.path, [&] { return &scene::kept_walks_of(lesson, method, text, folder_beside(file.path)); });
    e.folder = lesson.id + "-" + file.name;
    e.path = file.path;
    e.parameters = e.lesson->presets.front().parameters;
    return e;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", file.path, e.what()));
  }
}

}  // namespace isect::program
