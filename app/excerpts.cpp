// The presets and steps that the words of a command line mean.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>

#include "app/figures/setting_name.h"
#include "app/scene/lesson.h"
#include "app/setting_files.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/chart/case_map.h"
#include "viz/font/file.h"
#include "viz/formats/formats.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
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

/// Hides a scene's answers, or shows them. Figures go to a folder of their own unless the file says the same.
void hide_answers(Excerpt& to, const std::string& how) {
  if (how.empty()) return;
  if (how != "hidden" && how != "shown") throw viz::unknown("answers", how, {"hidden", "shown"});
  if (to.lesson->made_from.empty())
    throw viz::BadInput(
        fmt::format("answers: those of a scene are hidden or shown; {} is a lesson, whose questions "
                    "quiz prints",
                    to.lesson->id));
  const viz::Lesson* const before = std::exchange(to.lesson, &scene::with_answers(*to.lesson, how == "hidden"));
  if (to.lesson != before) to.folder += "+answers=" + how;
}

/// Has a scene told in a language; and a lesson, if somebody has translated it. Figures go to a folder of their own
/// unless the file says the same.
void tell_in(Excerpt& to, const std::string& code) {
  if (code.empty()) return;
  const viz::Language& language = viz::language_named(code);
  const viz::Lesson* const before = to.lesson;
  to.lesson = before->made_from.empty() ? &viz::lesson_in(*before, code) : &scene::with_language(*before, code);
  if (to.lesson != before)
    to.folder += "+lang=" + code;
  else if (before->made_from.empty() && code != "en")
    say(fmt::format(
        "lang: nobody has translated {} to {} yet, so it is told in English; isect lang lists what is there",
        before->id, language.name));
}

/// Prints one sentence if a text has letters that no font of this system has.
void say_missing_letters(const std::vector<Excerpt>& found) {
  if (std::ranges::any_of(found, [](const Excerpt& e) { return e.lesson->language == "zh"; }) &&
      !viz::has_font_for("zh-cn"))
    say("lang: no font here has Chinese letters, so figures show boxes in their place; on Debian: apt install "
        "fonts-noto-cjk");
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

/// Returns the steps that are asked for, else those that a file names, else all.
std::string steps_for(const Excerpt& e, const std::string& asked) {
  return !asked.empty() ? asked : !e.several.empty() ? e.several : e.step ? std::to_string(*e.step + 1) : "all";
}

/// Walks the setting and chooses its steps; those that a file names must exist.
void walk(Excerpt& e, const Selection& asked, bool one_of_many) {
  take_steps(e, steps_for(e, asked.step), one_of_many && !asked.step.empty() && !asked.every_step);
  const bool unnamed = asked.step.empty() && e.several.empty() && !e.step;
  if (unnamed && asked.to_verdict) e.steps.resize(static_cast<std::size_t>(verdict_of(e.walk)) + 1);
  sweep_shown_map(e);
}

/// Puts a setting that is drawn at one scale with others into their list as it is now, with all steps that it has there
/// and here.
void join_others(Excerpt& e, bool changed) {
  if (!e.scaled_with) return;
  std::vector<Excerpt> all = *e.scaled_with;
  Excerpt own = e;
  own.scaled_with.reset();
  if (!changed)
    for (const int step : all[e.scaled_as].steps)
      if (std::ranges::find(own.steps, step) == own.steps.end()) own.steps.push_back(step);
  std::ranges::sort(own.steps);
  sweep_shown_map(own);
  all[e.scaled_as] = std::move(own);
  e.scaled_with = std::make_shared<const std::vector<Excerpt>>(std::move(all));
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
  const bool one_lesson = a.lesson == b.lesson || (!a.lesson->made_from.empty() && a.lesson->id == b.lesson->id &&
                                                   a.lesson->made_from == b.lesson->made_from);
  return one_lesson && a.folder == b.folder && !a.style.empty() && a.style == b.style && a.parameters == b.parameters &&
         (a.step != b.step || a.time == b.time);
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
  for (const PresetFile& file : asked.files)
    for (Excerpt& e : settings_in(program, file))
      if (lessons.empty() || std::ranges::find(lessons, e.lesson) != lessons.end()) found.push_back(std::move(e));
  if (found.empty())
    throw viz::BadInput(fmt::format("lesson: no preset file is for {}", fmt::join(asked.lessons, ", ")));
  std::ranges::stable_sort(found, {}, [](const Excerpt& e) { return e.lesson->id; });
  return found;
}

/// Returns the presets of a lesson that are named: its first one if none is, or with `all` every one. Of several
/// lessons each takes the names that it has. Throws viz::BadInput if no lesson has a name, or this one has none of
/// them.
std::vector<Excerpt> named(const viz::Lesson& lesson, const std::vector<std::string>& names, bool all,
                           const std::vector<const viz::Lesson*>& lessons) {
  std::vector<Excerpt> found;
  const auto add = [&](const viz::Preset& p) { found.push_back({&lesson, p.id, p.id, p.parameters, {}, {}}); };
  const auto is_elsewhere = [&](const std::string& name) {
    const auto has_it = [&](const viz::Lesson* l) {
      return std::ranges::find(l->presets, name, &viz::Preset::id) != l->presets.end();
    };
    return !has_it(&lesson) && std::ranges::any_of(lessons, has_it);
  };
  if (std::ranges::find(names, "all") != names.end() || (names.empty() && all))
    std::ranges::for_each(lesson.presets, add);
  else if (names.empty())
    add(lesson.presets.front());
  else
    for (const std::string& name : names)
      if (std::ranges::find(found, name, &Excerpt::preset) == found.end() && !is_elsewhere(name))
        add(viz::preset(lesson, name));
  if (!found.empty()) return found;
  std::vector<std::string> ids;
  for (const viz::Preset& p : lesson.presets) ids.push_back(p.id);
  throw viz::BadInput(fmt::format("preset: {} has none called {}; allowed: {}", lesson.id, fmt::join(names, " or "),
                                  fmt::join(ids, ", ")));
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

/// The settings that words name, in the order of these words.
class NamedSettings {
 public:
  NamedSettings(const Program& program, Selection asked)
      : words_(asked.lessons), presets_(each_of(asked.presets)), presets_first_(asked.presets_first), all_(asked.all) {
    if (!asked.preset.empty()) presets_.push_back(asked.preset);
    names_ = presets_;
    for (std::vector<std::string>* words : {&names_, &asked.lessons}) {
      std::ranges::copy_if(*words, std::back_inserter(files_), is_file);
      std::erase_if(*words, is_file);
    }
    lessons_ = lessons_of(program, asked);
    std::vector<std::string> scenes = each_of(asked.scenes);
    if (!asked.scene.empty()) scenes.push_back(asked.scene);

    for (const PresetFile& file : named_files(files_)) add_file(program, file);
    if (!scenes.empty()) {
      add_scenes(scenes);
    } else {
      if (lessons_.empty() && (files_.empty() || !names_.empty()))
        throw viz::BadInput(fmt::format("lesson: none given; allowed: {}", fmt::join(ids_of(program), ", ")));
      for (const viz::Lesson* lesson : lessons_) add_presets(*lesson);
    }
    std::ranges::stable_sort(found_, {}, &Found::place);
  }

  std::vector<Excerpt> settings() {
    std::vector<Excerpt> all;
    for (Found& one : found_) all.push_back(std::move(one.e));
    return all;
  }

 private:
  /// Where it stands: before the words, among them or behind them; at which word; at which preset.
  using Place = std::array<std::size_t, 3>;
  struct Found {
    Place place;
    Excerpt e;
  };

  static std::size_t in(const std::vector<std::string>& words, const std::string& word) {
    return static_cast<std::size_t>(std::ranges::find(words, word) - words.begin());
  }
  /// Returns where a preset's name or file stands that is one of the lesson's: the lesson's own place counts, if it is
  /// named before.
  Place place_of_preset(const viz::Lesson& lesson, const std::string& word) const {
    return {presets_first_ ? std::size_t{0} : std::size_t{lessons_.empty() ? 2u : 1u}, word_of(lesson),
            in(presets_, word)};
  }
  std::size_t word_of(const viz::Lesson& lesson) const {
    if (const std::size_t at = in(words_, lesson.id); at < words_.size()) return at;
    return static_cast<std::size_t>(std::ranges::find(lessons_, &lesson) - lessons_.begin());
  }

  /// Adds what a file holds. One that is given as a preset must be for a lesson that is named, if any is.
  void add_file(const Program& program, const PresetFile& file) {
    const bool as_preset = std::ranges::find(presets_, file.path) != presets_.end();
    for (Excerpt& e : settings_in(program, file)) {
      if (as_preset && !lessons_.empty() && std::ranges::find(lessons_, e.lesson) == lessons_.end())
        throw viz::BadInput(fmt::format("preset: {} is for {}, not for {}", file.path, e.lesson->id, lessons_[0]->id));
      const Place place = as_preset ? place_of_preset(*e.lesson, file.path) : Place{1, in(words_, file.path), 0};
      found_.push_back({place, std::move(e)});
    }
  }

  void add_scenes(const std::vector<std::string>& scenes) {
    const bool as_presets = names_.size() < presets_.size();
    if (lessons_.size() != 1 || as_presets)
      throw viz::BadInput("scene: one lesson is to take its objects; name that, and no preset's file");
    const viz::Lesson& lesson = *lessons_.front();
    const std::string method = method_for(lesson, names_);
    for (const PresetFile& file : named_files(scenes))
      found_.push_back({{1, word_of(lesson), found_.size()}, setting_of_scene(lesson, method, file)});
  }

  /// Adds the lesson's presets; none where files are given that decide, unless some are named.
  void add_presets(const viz::Lesson& lesson) {
    const auto is_for_it = [&](const Found& one) { return one.e.lesson == &lesson; };
    const bool as_presets = names_.size() < presets_.size();
    if (names_.empty() && (as_presets || (all_ && !files_.empty()) || std::ranges::any_of(found_, is_for_it))) return;
    for (Excerpt& e : named(lesson, names_, all_, lessons_)) {
      const Place place = names_.empty() ? Place{1, word_of(lesson), 0} : place_of_preset(lesson, e.preset);
      found_.push_back({place, std::move(e)});
    }
  }

  std::vector<std::string> words_, presets_, names_, files_;
  std::vector<const viz::Lesson*> lessons_;
  bool presets_first_, all_;
  std::vector<Found> found_;
};

}  // namespace

void take_steps(Excerpt& e, const std::string& text, bool some) {
  e.walk = e.lesson->walk(e.parameters);
  draw_at_time(e);
  const std::optional<Steps> wanted = Steps::read(text);
  if (!wanted || (!some && !wanted->all_in(e.walk))) throw unknown_steps("step", text, e.walk, e.folder);
  e.steps = wanted->of(e.walk);
}

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
  std::vector<Excerpt> found =
      asked.files.empty() ? NamedSettings(program, asked).settings() : from_folder(program, asked);
  for (Excerpt& e : found) {
    hide_answers(e, asked.answers);
    tell_in(e, asked.lang);
    change(e, asked.changes);
    walk(e, asked, found.size() > 1);
    join_others(e, !asked.changes.empty());
  }
  if (std::ranges::all_of(found, [](const Excerpt& e) { return e.steps.empty(); }))
    throw no_such_step(found, asked.step);
  say_skipped(found, asked.step);
  say_missing_letters(found);
  require_own_places(found);
  return found;
}

Excerpt excerpt(const Program& program, const Selection& asked) {
  if (asked.preset == "all") throw viz::BadInput("preset: \"all\" is not allowed here; name one");
  if (const std::size_t several = each_of({asked.preset}).size(); several > 1)
    throw viz::BadInput(fmt::format("preset: \"{}\" names {}; here is room for one", asked.preset, several));
  std::vector<Excerpt> found = excerpts(program, asked);
  if (found.size() > 1)
    throw viz::BadInput(fmt::format("preset: {} are given, {} the first of them; here is room for one", found.size(),
                                    found.front().folder));
  found.front().scaled_with.reset();  // it is told alone
  return std::move(found.front());
}

}  // namespace isect::program
