// isect show: the window.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "app/figures/figure_place.h"
#include "app/playlist_file.h"
#include "app/scene/editor.h"
#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "app/shell/environment.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "lessons/course.h"
#include "viz/formats/files.h"
#include "viz/formats/formats.h"
#include "viz/player/reader_state.h"
#include "viz/window/window.h"

namespace isect::program {

namespace {

using Lessons = std::vector<const viz::Lesson*>;

/// Returns where to begin. `file` becomes the scene's, if that can be written to.
viz::ReaderState state_of(const Program& program, Selection asked, Lessons& lessons,
                          std::optional<scene::KeptFile>& file) {
  const std::string first = asked.lessons.empty() ? std::string() : asked.lessons.front();
  if (const viz::Format* format = viz::format_of(first); format && asked.step.empty() && asked.changes.empty())
    return place_in_figure(program, first, *format, lessons).state;
  const bool anywhere = asked.lessons.empty() && asked.preset.empty() && asked.changes.empty() && asked.step.empty() &&
                        asked.scene.empty();
  if (anywhere && program.only == nullptr) return {};  // where the reader stopped last time, or the first lesson
  if (asked.lessons.empty() && asked.preset.empty() && asked.scene.empty())
    asked.lessons = {program.lessons.front()->id};
  const Excerpt e = excerpt(program, asked);
  if (!asked.step.empty() && e.steps.size() != 1)
    throw viz::BadInput(fmt::format("step: \"{}\" is not allowed here; give one", asked.step));
  if (e.lesson->made_from.empty()) {  // it may be told in another language
    std::ranges::replace_if(
        lessons, [&](const viz::Lesson* lesson) { return lesson->id == e.lesson->id; }, e.lesson);
  } else {
    lessons.push_back(e.lesson);
    if (std::error_code absent; std::filesystem::is_regular_file(e.path, absent)) file.emplace(e.path);
  }
  viz::ReaderState state;
  state.lesson = e.lesson->id;
  state.preset = e.preset;
  state.step = e.steps.front();
  state.parameters = e.parameters;
  state.camera = e.camera;
  if (e.step == state.step) state.time = e.time;
  return state;
}

/// Returns the playlist that is asked for, which opens in part at least; one without stops if something else is asked
/// for. Stops that can't be opened are told.
viz::Playlist playlist_of(const Program& program, const Selection& asked) {
  const std::string path = playlist_asked(asked);
  if (path.empty()) return {};
  viz::Playlist list = read_playlist(program, path, Faults::kept);
  const bool opens = std::ranges::any_of(list.stops, [](const viz::Stop& stop) { return stop.fault.empty(); });
  if (!opens) throw viz::BadInput(fmt::format("{}: {}", path, list.stops.front().fault));
  for (const viz::Stop& stop : list.stops)
    if (!stop.fault.empty()) say(fmt::format("{}: {}: {}", program.name, path, stop.fault));
  return list;
}

/// Gives each scene of a playlist an id of its own, by which the window finds it among the lessons.
void add_scenes(viz::Playlist& list, Lessons& lessons, std::deque<viz::Lesson>& scenes) {
  std::map<const viz::Lesson*, const viz::Lesson*> known;
  for (viz::Stop& stop : list.stops) {
    if (!stop.lesson || stop.lesson->made_from.empty()) continue;
    const auto [made, is_new] = known.try_emplace(stop.lesson);
    if (is_new) {
      viz::Lesson& scene = scenes.emplace_back(*stop.lesson);
      if (scenes.size() > 1) scene.id += fmt::format("-{}", scenes.size());
      lessons.push_back(made->second = &scene);
    }
    stop.lesson = made->second;
    stop.state.lesson = stop.lesson->id;
  }
}

/// Returns how a scene that has no file gets one, which `file` then is.
viz::NewSceneFile file_for(std::optional<scene::KeptFile>& file) {
  const auto text = [](const viz::Lesson& lesson, const viz::Parameters& p, const std::string& folder) {
    std::string all = scene::text_with(lesson, p).value();
    try {
      scene::read_scene(all, folder);
    } catch (const viz::FileError& e) {
      throw viz::BadInput(fmt::format("What the scene names does not lie beside it there: {}", e.what()));
    }
    return all;
  };
  const auto take = [&file](const viz::Lesson& lesson, const viz::Parameters& p, const std::string& path) {
    file.emplace(path);
    scene::keep(lesson, file->folder(), p);
  };
  return {text, take};
}

int show(const Program& program, const Selection& asked) {
  Lessons lessons = program.lessons;
  std::optional<scene::KeptFile> file;
  std::deque<viz::Lesson> scenes;  // none of them moves
  viz::Playlist list = playlist_of(program, asked);
  add_scenes(list, lessons, scenes);
  const viz::ReaderState state = list.stops.empty() ? state_of(program, asked, lessons, file) : viz::ReaderState();
  const viz::Lesson* const scene =
      list.stops.empty() && lessons.size() > program.lessons.size() ? lessons.back() : nullptr;
  viz::NewSceneFile new_file;
  if (scene && !file && scene::is_editable(*scene)) new_file = file_for(file);
  std::function<void(const viz::Lesson&, const viz::Parameters&)> save;
  if (file || new_file.text)
    save = [&](const viz::Lesson& lesson, const viz::Parameters& p) {
      if (const std::optional<std::string> text = scene::text_with(lesson, p))
        file->write(*text);
      else
        file->save(p);
      scene::keep(lesson, file->folder(), p);
    };
  need_environment(program);
  try {
    viz::show(
        lessons, lessons::course(), state,
        [&](const std::string& words) { say(fmt::format("{}: {}", program.name, words)); }, save, list, scene::editor(),
        new_file);
  } catch (const viz::NoDisplay& e) {
    say(fmt::format("{}: {}", program.name, e.what()));
    if (!list.stops.empty()) {
      say(fmt::format("Without a display, `{} handout {}` makes the same hour a page to print.", program.name,
                      asked.lessons.front()));
      return nowhere_to_draw;
    }
    const std::string which = scene ? file ? " " + (asked.lessons.empty() ? asked.preset : asked.lessons.front())
                                           : std::string(" FILE.json, of the scene in it,")
                              : program.only
                                  ? ""
                                  : " " + (state.lesson.empty() ? program.lessons.front()->id : state.lesson);
    const std::string method = asked.preset.empty() ? "" : " --preset " + asked.preset;
    const std::string preset = !asked.scene.empty()            ? " --scene " + asked.scene + method
                               : scene || state.preset.empty() ? ""
                                                               : " --preset " + state.preset;
    say(fmt::format(
        "Without a display, `{0} render{1}{2}` writes the figures, and `{0} explain{1}{2}` tells them as text.",
        program.name, which, preset));
    return nowhere_to_draw;
  }
  return done;
}

}  // namespace

void add_show(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("show", "the window, at that place");
  const auto asked = std::make_shared<Selection>();
  add_lesson(sub, program, *asked, Takes::one,
             fmt::format("a lesson's id; or a figure made by isect (.{}),\nto open it where it was made; or a "
                         "playlist's file, to\ngo through its stops",
                         fmt::join(viz::format_names(), ", .")));
  add_preset(sub, *asked, Takes::one,
             "a preset, or a file with one (its step, time and camera\nare honoured); the first if not given");
  add_step(
      sub, *asked, Takes::one,
      "counted from 1, -1 is the last; or by name: intersect, verdict;\nif not given, that of the preset's file, or 1");
  add_scene_file(sub, program, *asked);
  add_set(sub, *asked);
  add_language(sub, *asked);
  sub.footer(program.only ? "Example: " + program.name + " show --step 3"
                          : "Examples: isect show ray-sphere --step 3\n          isect show "
                            "figures/ray-sphere/tangent/03-distance.svg\n          isect show "
                            "examples/playlists/ray-and-ball.json\n          isect show - < my-scene.json\n\n"
                            "A playlist names the presets, steps and scenes of an hour, in its order:\n"
                            "  { \"title\": \"Rays and balls\", \"stops\": [\n"
                            "      {\"lesson\": \"ray-sphere\", \"preset\": \"tangent\", \"steps\": \"3-6\"},\n"
                            "      {\"preset\": \"mine.json\", \"note\": \"Where does it end?\"},\n"
                            "      {\"scene\": \"crates.json\"} ] }\n"
                            "A stop is also what Ctrl+C copies in the window. Files are named relative to\n"
                            "the playlist. N, the right arrow and Page Down go on, ask each step's question\n"
                            "first, and lead to the next stop; Page Up goes back; I lists all stops, and a\n"
                            "number there goes to one. The window opens a playlist where it was left.");
  sub.callback([&program, asked] { program.chosen = [&program, asked] { return show(program, *asked); }; });
}

}  // namespace isect::program
