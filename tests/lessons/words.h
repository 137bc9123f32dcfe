#pragma once
// What tests of a lesson's words share: its walks on random settings, and what stands in their steps.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::tests {

inline const viz::Lesson& lesson(const std::string& id) { return viz::lesson_named(lessons::all_lessons(), id); }
inline viz::Walk walk_of(const std::string& id, const std::string& preset) {
  return lesson(id).walk(viz::preset(lesson(id), preset).parameters);
}

using Changes = std::vector<std::pair<std::string, std::string>>;
/// The walk of a preset in which some parameters are others, as `--set` would have them.
inline viz::Walk with(const std::string& id, const std::string& preset, const Changes& changes) {
  viz::Parameters setting = viz::preset(lesson(id), preset).parameters;
  for (const auto& [name, value] : changes) viz::set(lesson(id), setting, name, value);
  viz::validate(lesson(id), setting);
  return lesson(id).walk(setting);
}

inline const std::string& text(const viz::Parameters& p, const char* name) { return std::get<std::string>(p.at(name)); }
/// The point of a flat lesson.
inline Point<double, 2> point(const viz::Parameters& p) { return std::get<viz::Vec3>(p.at("p")).head<2>(); }

/// The step of that name; null if the walk has none.
inline const viz::Step* find(const viz::Walk& walk, const std::string& slug) {
  const auto found = std::ranges::find(walk.steps, slug, &viz::Step::slug);
  return found == walk.steps.end() ? nullptr : &*found;
}
inline viz::Step ending(const viz::Walk& walk) { return walk.steps[static_cast<std::size_t>(outcome(walk))]; }

/// A lesson's own step, counted from 0: a step that shows only the opening is skipped.
inline const viz::Step& own_step(const viz::Walk& walk, std::size_t i) {
  return walk.steps.at(walk.steps.front().slug == viz::opening_slug ? i + 1 : i);
}

inline double value(const viz::Step& step, const std::string& name) {
  for (const viz::Value& v : step.values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}

inline bool says(const std::string& told, const std::string& words) { return told.find(words) != std::string::npos; }
/// Whether some exercise's solution says these words.
inline bool solved_with(const std::string& id, const std::string& words) {
  return std::ranges::any_of(lesson(id).closing->exercises,
                             [&](const viz::Exercise& e) { return says(viz::plain(e.solution), words); });
}
/// Whether some caption of some preset says these words.
inline bool told(const std::string& id, const std::string& words) {
  return std::ranges::any_of(lesson(id).presets, [&](const viz::Preset& p) {
    return std::ranges::any_of(lesson(id).walk(p.parameters).steps,
                               [&](const viz::Step& s) { return says(viz::plain(s.caption), words); });
  });
}
/// The choice that a question accepts.
inline std::string answer(const viz::Step& step) { return step.question->choices[step.question->answer]; }

inline bench::Random random_of(const char* name) { return bench::Random(bench::stream(seed(), name)); }

/// Calls check(setting, walk) on this many random settings of a lesson.
template <class Check>
void on_random_settings(const std::string& id, int how_many, const Check& check) {
  bench::Random random(bench::stream(seed(), id.c_str()));
  for (int i = 0; i < cases(how_many, 20 * how_many); ++i) {
    const viz::Parameters setting = random_setting(lesson(id), random);
    std::string told = id;
    for (const auto& [name, v] : setting) told += " --set " + name + "=" + viz::to_text(v);
    INFO(told);
    check(setting, lesson(id).walk(setting));
  }
}

}  // namespace isect::tests
