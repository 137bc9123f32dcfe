#include "app/figures/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "app/figures/ownership.h"
#include "app/figures/setting_name.h"
#include "app/scene/file.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/step_text.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *all_of_them = "cases", *own_one = "case";
/// All that a figure carries must be less than a MiB to be read again; its style is short.
constexpr std::size_t most_bytes = 1'000'000;

bool is_scene(const Excerpt& e) { return !e.lesson->made_from.empty(); }

/// Returns the preset that an excerpt shows unchanged; nullptr where it shows none.
const viz::Preset* preset_of(const Excerpt& e) {
  if (is_scene(e) || e.preset.empty()) return nullptr;
  const viz::Preset& preset = viz::preset(*e.lesson, e.preset);
  return preset.parameters == e.parameters ? &preset : nullptr;
}

/// Returns the title of what was changed by hand: "two roots (radius=2)", of "two-roots+radius=2".
std::string changed_title(const Excerpt& e) {
  const std::size_t plus = e.folder.find('+');
  for (const viz::Preset& p : e.lesson->presets)
    if (plus != e.folder.npos && p.id == e.folder.substr(0, plus))
      return fmt::format("{} ({})", p.title, viz::as_markup(e.folder.substr(plus + 1)));
  return viz::as_markup(e.folder);
}

/// Whether a scene has the title of those that have none of their own.
bool is_untitled(const viz::Lesson& lesson) {
  const viz::Speaking speaking(lesson.language);
  return lesson.title == viz::tr(scene::untitled);
}

std::string title_of(const Excerpt& e) {
  if (const viz::Preset* preset = preset_of(e)) return preset->title;
  if (!is_scene(e)) return changed_title(e);
  const bool as_in_file = e.parameters == e.lesson->presets.front().parameters;
  return as_in_file && !is_untitled(*e.lesson) ? e.lesson->title : viz::as_markup(e.folder);
}

/// Returns how many characters all titles begin with, up to the end of a ": ".
std::size_t common_begin(const std::vector<std::string>& titles) {
  std::string begin = titles.front();
  for (const std::string& title : titles) {
    const auto [end, unused] = std::mismatch(begin.begin(), begin.end(), title.begin(), title.end());
    begin.erase(end, begin.end());
  }
  const std::size_t end = begin.rfind(": ");
  return end == begin.npos ? 0 : end + 2;
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, "+")); }

Json parsed(const std::string& text) try {
  constexpr int deepest = 2;  // deeper JSON would overflow the stack
  return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest) throw viz::BadInput("cases: nested deeper than isect writes them");
    return true;
  });
} catch (const Json::exception&) {
  throw viz::BadInput("cases: no JSON");
}

}  // namespace

std::vector<std::string> case_titles(Excerpts cases) {
  std::set<const viz::Lesson*> lessons;
  for (const Excerpt& e : cases)
    if (!is_scene(e)) lessons.insert(e.lesson);
  std::vector<std::string> titles;
  for (const Excerpt& e : cases)
    titles.push_back((lessons.size() > 1 && !is_scene(e) ? viz::short_title(*e.lesson) + ": " : "") + title_of(e));
  if (cases.size() > 1 && std::ranges::all_of(cases, is_scene)) {
    const std::size_t begin = common_begin(titles);  // of a lesson's walks through scenes, its name
    for (std::string& title : titles) title.erase(0, begin);
  }

  const auto tell_apart = [&](const auto& with) {
    const std::vector<std::string> before = titles;
    for (std::size_t i = 0; i < titles.size(); ++i)
      if (std::ranges::count(before, before[i]) > 1) titles[i] = with(cases[i], before[i]);
  };
  tell_apart([](const Excerpt& e, const std::string& title) {
    const viz::Preset* preset = preset_of(e);
    return preset && !preset->group.empty() ? fmt::format("{} ({})", title, viz::as_markup(preset->group)) : title;
  });
  tell_apart([](const Excerpt& e, const std::string&) { return viz::as_markup(e.folder); });
  return titles;
}

std::vector<std::string> part_captions(Excerpts cases, bool captions) {
  const std::vector<std::string> titles = case_titles(cases);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const int step : cases[i].steps) {
      const viz::Step& s = cases[i].walk.steps[static_cast<std::size_t>(step)];
      std::string title = s.title;
      if (cases.size() > 1) title = titles[i] + (cases[i].steps.size() > 1 ? ": " + s.title : "");
      all.push_back(captions ? viz::figure_caption(*cases[i].lesson, s, title) : title);
    }
  return all;
}

std::string numbers_of(const std::vector<int>& steps) {
  const bool in_a_row = steps.back() - steps.front() + 1 == static_cast<int>(steps.size());
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!in_a_row || i == 0 || i + 1 == steps.size())
      text += fmt::format("{}{:02}", text.empty() ? "" : in_a_row ? "-" : "+", steps[i] + 1);
  return text;
}

std::string stem_of(Excerpts cases, const std::string& kind) {
  if (cases.size() == 1) return fmt::format("{}/{}-{}", folder_of(cases[0]), kind, numbers_of(cases[0].steps));
  std::vector<std::string> lessons, names, steps;
  for (const Excerpt& e : cases) {
    if (std::ranges::find(lessons, e.lesson->id) == lessons.end()) lessons.push_back(e.lesson->id);
    names.push_back(e.folder);
    steps.push_back(numbers_of(e.steps));
  }
  if (std::ranges::count(steps, steps.front()) == static_cast<std::ptrdiff_t>(steps.size())) steps.resize(1);
  return fmt::format("{}/{}-{}", plain_name(joined(lessons)), kind, plain_name(joined(names) + "-" + joined(steps)));
}

void keep_cases(viz::Metadata& to, Excerpts cases, std::optional<std::size_t> own) {
  if (cases.size() > most_cases)
    throw viz::BadInput(
        fmt::format("preset: {} are asked for, and {} are the most at one scale", cases.size(), most_cases));
  Json all = Json::array();
  for (const Excerpt& e : cases) {
    viz::Metadata one = metadata_of(e, e.steps.front());
    one.erase("version");
    one["steps"] = numbers_of(e.steps);
    all.push_back(one);
  }
  const auto text = [](const Json& json) { return json.dump(-1, ' ', true, Json::error_handler_t::replace); };
  to[all_of_them] = text(all);
  if (own) to[own_one] = std::to_string(*own + 1);
  if (const std::size_t bytes = text(to).size(); bytes > most_bytes)
    throw viz::BadInput(
        fmt::format("scene: these {} settings have {} kB, and a figure carries {} kB at most, so that it can be drawn "
                    "again; give fewer of them, or smaller meshes and clouds",
                    cases.size(), bytes / 1000, most_bytes / 1000));
}

CasesInFigure cases_of(const viz::Metadata& data) {
  CasesInFigure found;
  if (!data.contains(all_of_them)) return found;
  const Json all = parsed(data.at(all_of_them));
  const auto wrong = [](const std::string& what) { return viz::BadInput("cases: " + what); };
  try {
    found.cases = all.get<std::vector<viz::Metadata>>();
  } catch (const Json::exception&) {
    throw wrong("no list of settings");
  }
  if (found.cases.empty() || found.cases.size() > most_cases)
    throw wrong(fmt::format("{} settings, and 1 to {} are allowed", found.cases.size(), most_cases));
  if (!data.contains(own_one)) return found;
  const std::string& text = data.at(own_one);
  std::size_t own = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), own);
  if (error != std::errc{} || end != text.data() + text.size() || own < 1 || own > found.cases.size())
    throw wrong(fmt::format("\"{}\" is none of them; they are 1 to {}", text, found.cases.size()));
  found.own = own - 1;
  return found;
}

bool shows_cases(const viz::Metadata& data) { return data.contains(all_of_them) && !data.contains(own_one); }

}  // namespace isect::program
