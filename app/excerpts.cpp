// The presets and steps that the words of a command line mean.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

#include "app/figures/figure_place.h"
#include "app/figures/setting_name.h"
#include "app/playlist_file.h"
#include "app/preset_folder.h"
#include "app/scene/lesson.h"
#include "app/scene/walks.h"
#include "app/shell/named_file.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/chart/case_map.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/player/scene_time.h"
#include "viz/text/spelling.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

/// Whether a preset is a file; the names of our presets have no dot. "-" is the standard input.
bool is_file(const std::string& preset) {
  std::error_code absent;
  return preset == "-" || preset.ends_with(".json") || viz::format_of(preset) || preset.find('/') != preset.npos ||
         (preset.find('.') != preset.npos && fs::is_regular_file(preset, absent));
}

void change(Excerpt& to, const std::vector<std::string>& changes) {
  const viz::Parameters before = to.parameters;
  to.parameters = changed(*to.lesson, before, changes);
  to.folder += name_of_change(before, to.parameters);
  if (!to.preset.empty() && to.parameters != viz::preset(*to.lesson, to.preset).parameters) to.preset.clear();
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
  e.parameters = e.lesson->presets.front().parameters;
  return e;
}

/// Returns the method for many objects that a preset beside a scene names, if the lesson has several.
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

/// Returns the lesson's walks through a scene's objects.
Excerpt from_scene_for(const viz::Lesson& lesson, const std::string& method, const PresetFile& file) {
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

Excerpt at(const std::vector<const viz::Lesson*>& lessons, const viz::ReaderState& state, const PresetFile& file) {
  Excerpt e;
  e.lesson = &viz::lesson_named(lessons, state.lesson);
  e.folder = file.name;
  e.preset = state.preset;
  e.parameters = *state.parameters;
  e.camera = state.camera;
  e.step = state.step;
  e.time = state.time;
  return e;
}

/// Returns the preset of a file, whose name becomes the folder; or the place where a figure was made, and its folder.
Excerpt from_file(const Program& program, const PresetFile& file) {
  if (std::error_code absent; fs::is_directory(file.path, absent))
    throw viz::FileError(
        fmt::format("preset: \"{0}\" is a folder; render --dir {0} draws all presets and scenes in it", file.path));
  if (const viz::Format* format = viz::format_of(file.path)) {
    std::vector<const viz::Lesson*> lessons = program.lessons;
    const FigurePlace found = place_in_figure(program, file.path, *format, lessons);
    Excerpt e = at(lessons, found.state, file);
    e.several = found.steps;
    e.style = found.style;
    if (!found.folder.empty()) e.folder = found.folder;
    return e;
  }
  viz::ReaderState state;
  try {
    require_utf8(file);
    const std::string text = read_named_file(file.path);
    if (scene::is_scene(text)) return from_scene(text, file);
    if (is_playlist(text))
      throw viz::BadInput(
          "this is a playlist, which show, handout, deck and quiz take; a preset's file has \"lesson\"");
    state = viz::reader_state_from_json(text, program.lessons);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", file.path, e.what()));
  }
  Excerpt e = at(program.lessons, state, file);
  e.path = file.path;
  return e;
}

std::vector<std::string> ids_of(const Program& program) {
  std::vector<std::string> ids;
  for (const viz::Lesson* lesson : program.lessons) ids.push_back(lesson->id);
  return ids;
}

bool is_lesson(const Program& program, const std::string& id) {
  return std::ranges::any_of(program.lessons, [&](const viz::Lesson* lesson) { return lesson->id == id; });
}

/// Returns the lessons asked for; none if a preset's file decides.
std::vector<const viz::Lesson*> lessons_of(const Program& program, const Selection& asked) {
  if (program.only) return {program.only};
  if (asked.all && !asked.lessons.empty()) throw viz::BadInput("lesson: give either names or --all, not both");
  if (asked.all) return program.lessons;
  std::vector<const viz::Lesson*> lessons;
  for (const std::string& id : asked.lessons) {
    if (id.find('=') != id.npos)
      throw viz::BadInput(fmt::format("lesson: \"{0}\" is none; to change a parameter write --set {0}", id));
    for (const viz::Lesson* before : lessons)
      if (std::ranges::find(before->presets, id, &viz::Preset::id) != before->presets.end() && !is_lesson(program, id))
        throw viz::BadInput(fmt::format(
            "lesson: \"{0}\" is none, but a preset of {1}; several are joined by commas, such as --preset {2},{0}", id,
            before->id, asked.presets.empty() ? before->presets.front().id : asked.presets.back()));
    const viz::Lesson* lesson = &viz::lesson_named(program.lessons, id);
    if (std::ranges::find(lessons, lesson) == lessons.end()) lessons.push_back(lesson);
  }
  return lessons;
}

/// Returns where a file lies, links followed; the name of a pipe, such as <(command), which lies nowhere.
fs::path place_of(const std::string& path) {
  std::error_code nowhere;
  const fs::path place = fs::weakly_canonical(path, nowhere);
  return nowhere ? fs::absolute(path).lexically_normal() : place;
}

/// Returns the files in order, each once, by their own names; if two have the same name, by where they lie.
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

void walk(Excerpt& e, const std::string& asked, bool one_of_many) {
  e.walk = e.lesson->walk(e.parameters);
  draw_at_time(e);
  const std::string text = !asked.empty()       ? asked
                           : !e.several.empty() ? e.several
                           : e.step             ? std::to_string(*e.step + 1)
                                                : "all";
  one_of_many = one_of_many && !asked.empty();  // the step that a file names must exist
  const std::optional<Steps> wanted = Steps::read(text);
  if (!wanted || (!one_of_many && !wanted->all_in(e.walk))) throw unknown_steps("step", text, e.walk, e.folder);
  e.steps = wanted->of(e.walk);
  sweep_shown_map(e);
}

/// Prints one line on what was asked for and is missing in some presets.
void say_skipped(const std::vector<Excerpt>& found, const std::string& asked) {
  const std::optional<Steps> wanted = asked.empty() ? std::nullopt : Steps::read(asked);
  if (!wanted) return;
  std::vector<std::string> lessons;
  for (auto e = found.begin(); e != found.end();) {
    const viz::Lesson* lesson = e->lesson;
    std::size_t all = 0;
    std::vector<std::string> without;
    for (; e != found.end() && e->lesson == lesson; ++e, ++all)
      if (!wanted->all_in(e->walk)) without.push_back(e->folder);
    if (without.empty()) continue;
    const bool few = without.size() <= 3 && without.size() < all;
    lessons.push_back(fmt::format("{} ({})", lesson->id,
                                  few                     ? fmt::format("{}", fmt::join(without, ", "))
                                  : without.size() == all ? fmt::format("all {}", all)
                                                          : fmt::format("{} of {}", without.size(), all)));
  }
  if (!lessons.empty()) say(fmt::format("step {}: not in these presets: {}", asked, fmt::join(lessons, ", ")));
}

/// Returns the error for a step that no preset has.
viz::BadInput no_such_step(const std::vector<Excerpt>& found, const std::string& asked) {
  std::set<std::string> names;
  std::size_t most = 0;
  for (const Excerpt& e : found) {
    std::ranges::copy(step_names(e.walk), std::inserter(names, names.end()));
    most = std::max(most, e.walk.steps.size());
  }
  return viz::BadInput(
      fmt::format("step: \"{}\" is unknown{}", asked,
                  spelling::instead(
                      asked, {names.begin(), names.end()},
                      fmt::format("no preset has it; they have {} steps at most, and verdict is one of each", most))));
}

/// Whether both are one setting: a figure in two formats, or two steps of one setting, may be given side by side.
bool same_setting(const Excerpt& a, const Excerpt& b) {
  return a.lesson == b.lesson && a.folder == b.folder && !a.style.empty() && a.style == b.style &&
         a.parameters == b.parameters && (a.step != b.step || a.time == b.time);
}

/// Throws viz::BadInput if two would be written to the same place.
void require_own_places(std::vector<Excerpt>& found) {
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Excerpt &a = found[i], &b = found[j];
      if (a.lesson->id != b.lesson->id || a.folder != b.folder) continue;
      if (!same_setting(a, b))
        throw viz::BadInput(fmt::format("preset: two are called {0} and would be written to {1}/{0}; rename a file",
                                        a.folder, a.lesson->id));
      std::erase_if(found[i].steps, [&](int step) { return std::ranges::find(b.steps, step) != b.steps.end(); });
    }
  std::erase_if(found, [](const Excerpt& e) { return e.steps.empty(); });
}

/// Returns the presets of a folder: all, or those for the lessons asked for.
std::vector<Excerpt> from_folder(const Program& program, const Selection& asked) {
  const std::vector<const viz::Lesson*> lessons = lessons_of(program, asked);
  std::vector<Excerpt> found;
  for (const PresetFile& file : asked.files) {
    Excerpt e = from_file(program, file);
    if (lessons.empty() || std::ranges::find(lessons, e.lesson) != lessons.end()) found.push_back(std::move(e));
  }
  if (found.empty())
    throw viz::BadInput(fmt::format("lesson: no preset file is for {}", fmt::join(asked.lessons, ", ")));
  std::ranges::stable_sort(found, {}, [](const Excerpt& e) { return e.lesson->id; });
  return found;
}

std::vector<Excerpt> named(const viz::Lesson& lesson, const std::vector<std::string>& names, bool all) {
  std::vector<Excerpt> found;
  const auto add = [&](const viz::Preset& p) { found.push_back({&lesson, p.id, p.id, p.parameters, {}, {}}); };
  const bool every = std::ranges::find(names, "all") != names.end();
  if (every || (names.empty() && all))
    std::ranges::for_each(lesson.presets, add);
  else if (names.empty())
    add(lesson.presets.front());
  else
    for (const std::string& name : names)
      if (std::ranges::find(found, name, &Excerpt::preset) == found.end()) add(viz::preset(lesson, name));
  return found;
}

/// Splits presets joined by commas, as formats are. A file with that very name is taken as a whole.
std::vector<std::string> each_of(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const std::string& word : words) {
    if (std::error_code absent; fs::exists(word, absent)) {
      all.push_back(word);
      continue;
    }
    std::istringstream parts(word + ",");
    for (std::string part; std::getline(parts, part, ',');) all.push_back(part);
  }
  return all;
}

/// Returns the presets that words name: files, and names in each of the lessons.
std::vector<Excerpt> from_words(const Program& program, Selection asked) {
  std::vector<std::string> names = each_of(asked.presets), files;
  if (!asked.preset.empty()) names.push_back(asked.preset);
  for (std::vector<std::string>* words : {&names, &asked.lessons}) {
    std::ranges::copy_if(*words, std::back_inserter(files), is_file);
    std::erase_if(*words, is_file);
  }
  const std::vector<const viz::Lesson*> lessons = lessons_of(program, asked);
  std::vector<Excerpt> found;
  if (!asked.scene.empty()) {
    if (lessons.size() != 1 || !files.empty())
      throw viz::BadInput("scene: one lesson is to take its objects; name that, and no other file");
    const viz::Lesson& lesson = *lessons.front();
    return {from_scene_for(lesson, method_for(lesson, names), {asked.scene, fs::path(asked.scene).stem().string()})};
  }
  if (files.empty() || !names.empty()) {
    if (lessons.empty())
      throw viz::BadInput(fmt::format("lesson: none given; allowed: {}", fmt::join(ids_of(program), ", ")));
    for (const viz::Lesson* lesson : lessons)
      std::ranges::move(named(*lesson, names, asked.all), std::back_inserter(found));
  }
  for (const PresetFile& file : named_files(files)) {
    found.push_back(from_file(program, file));
    const viz::Lesson* lesson = found.back().lesson;
    if (!lessons.empty() && std::ranges::find(lessons, lesson) == lessons.end())
      throw viz::BadInput(fmt::format("preset: {} is for {}, not for {}", file.path, lesson->id, lessons[0]->id));
  }
  return found;
}

}  // namespace

void draw_at_time(Excerpt& e) {
  if (!e.time) return;
  const auto step = static_cast<std::size_t>(e.step.value_or(0));
  const bool moves = step < e.walk.steps.size() && e.walk.steps[step].scene.time;
  if (!moves) return e.time.reset();
  e.walk = viz::at_time(std::move(e.walk), static_cast<int>(step), *e.time);
  e.time = e.walk.steps[step].scene.time->now;
}

void sweep_shown_map(Excerpt& e) {
  const auto shows_map = [&](int step) { return e.walk.steps[step].slug == viz::case_map_slug; };
  if (std::ranges::any_of(e.steps, shows_map)) viz::sweep_map(e.walk, *e.lesson, e.parameters);
}

viz::Parameters changed(const viz::Lesson& lesson, viz::Parameters parameters,
                        const std::vector<std::string>& changes) {
  for (const std::string& text : changes) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw viz::BadInput(fmt::format("set: \"{}\" has no '='; write name=value, such as {}={}", text,
                                      lesson.parameters.front().name, viz::to_text(lesson.parameters.front().initial)));
    viz::set(lesson, parameters, text.substr(0, equals), text.substr(equals + 1));
  }
  viz::validate(lesson, parameters);
  return parameters;
}

std::vector<Excerpt> excerpts(const Program& program, const Selection& asked) {
  for (const std::string& text : asked.changes)  // checked before a word after it is taken for a lesson
    if (text.find('=') == text.npos)
      throw viz::BadInput(fmt::format("set: \"{}\" has no '='; write name=value, such as {}=2", text, text));
  std::vector<Excerpt> found = asked.files.empty() ? from_words(program, asked) : from_folder(program, asked);
  for (Excerpt& e : found) {
    change(e, asked.changes);
    walk(e, asked.step, found.size() > 1);
  }
  if (std::ranges::all_of(found, [](const Excerpt& e) { return e.steps.empty(); }))
    throw no_such_step(found, asked.step);
  say_skipped(found, asked.step);
  require_own_places(found);
  return found;
}

Excerpt excerpt(const Program& program, const Selection& asked) {
  if (asked.preset == "all") throw viz::BadInput("preset: \"all\" is not allowed here; name one");
  if (const std::size_t several = each_of({asked.preset}).size(); several > 1)
    throw viz::BadInput(fmt::format("preset: \"{}\" names {}; here is room for one", asked.preset, several));
  return std::move(excerpts(program, asked).front());
}

}  // namespace isect::program
