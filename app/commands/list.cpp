// isect list: what there is to see. The list of lessons walks none of them, so that it answers at once; for one lesson
// it also lists the steps of the presets.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "app/shell/terminal.h"
#include "lessons/glossary.h"
#include "lessons/lessons.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/closing.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t line_width = 80;

/// Returns the presets' names, one line per group.
std::string preset_lines(const viz::Lesson& lesson) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const viz::Preset& p : lesson.presets) {
    if (groups.empty() || groups.back().first != p.group) groups.emplace_back(p.group, "presets:");
    groups.back().second += " " + p.id;
  }
  std::string lines;
  for (const auto& group : groups) lines += wrapped(group.second, line_width, 2);
  return lines;
}

std::string heading(const viz::Lesson& lesson) {
  return fmt::format("{}  {}", inked(Ink::bold, lesson.id), lesson.title);
}

std::string builds_on(const viz::Lesson& lesson) {
  return lesson.after.empty() ? "" : wrapped(fmt::format("after: {}", fmt::join(lesson.after, ", ")), line_width, 2);
}

/// Returns "shares: Minkowski sum (sphere-aabb, obb-obb); slab (clipping)".
std::string shares(const viz::Lesson& lesson) {
  std::vector<std::string> all;
  for (const viz::SharedIdea& shared : viz::shared_ideas(lesson)) {
    std::vector<std::string> ids;
    for (const viz::Lesson* other : shared.others) ids.push_back(other->id);
    all.push_back(fmt::format("{} ({})", shared.idea, fmt::join(ids, ", ")));
  }
  return all.empty() ? "" : wrapped(fmt::format("shares: {}", fmt::join(all, "; ")), line_width, 2);
}

std::string text(const std::vector<const viz::Lesson*>& lessons) {
  std::string out;
  for (const viz::Lesson* lesson : lessons)
    out += fmt::format("{}, {} presets\n", heading(*lesson), lesson->presets.size()) +
           wrapped(lesson->summary, line_width, 2) + builds_on(*lesson) + shares(*lesson) + preset_lines(*lesson);
  return out;
}

std::string in_rows(const std::string& name, std::size_t widest, const std::string& text) {
  const std::size_t indent = 4 + widest + 2;
  const std::string lines = wrapped(text, line_width, indent);
  return "    " + name + lines.substr(4 + viz::count_characters(name));
}

/// Returns a parameter's default: the value of the first preset.
std::string initial(const viz::Lesson& lesson, const viz::Parameter& p) {
  if (p.optional) return "not moved";
  return viz::to_text(lesson.presets.empty() ? p.initial : lesson.presets.front().parameters.at(p.name));
}

const viz::Condition* condition_of(const viz::Lesson& lesson, const viz::Parameter& p) {
  const auto found = std::ranges::find(lesson.conditions, p.name, &viz::Condition::parameter);
  return found == lesson.conditions.end() ? nullptr : &*found;
}

/// Returns the help with the unit, what is allowed, and the default.
std::string told(const viz::Lesson& lesson, const viz::Parameter& p) {
  std::string takes = viz::wanted(p);
  takes.erase(std::min(takes.find(", such as"), takes.size()));  // the default is example enough
  if (const viz::Condition* c = condition_of(lesson, p)) takes += "; " + c->allowed;
  const std::string where = p.where.empty() ? "" : viz::told_where(p) + ". ";
  return fmt::format("{}\n{}. {}Default: {}", p.help, takes, where, initial(lesson, p));
}

std::string text(const viz::Lesson& lesson) {
  std::string out =
      heading(lesson) + "\n" + wrapped(lesson.summary, line_width, 2) + builds_on(lesson) + shares(lesson);
  std::size_t widest = 0;
  for (const viz::Parameter& p : lesson.parameters) widest = std::max(widest, viz::count_characters(p.name));
  out += "\n  Parameters (--set NAME=VALUE); the defaults are those of the first preset:\n";
  for (const viz::Parameter& p : lesson.parameters) out += in_rows(p.name, widest, told(lesson, p));

  widest = 0;
  for (const viz::Preset& p : lesson.presets) widest = std::max(widest, viz::count_characters(p.id));
  out += "\n  Presets (--preset NAME):\n";
  for (const viz::Preset& p : lesson.presets)
    out +=
        in_rows(p.id, widest, fmt::format("{}, {} steps", viz::plain(p.title), lesson.walk(p.parameters).steps.size()));
  return out;
}

Json json(const viz::Lesson& lesson, const viz::Parameter& p) {
  Json object = {{"name", p.name}, {"help", p.help}, {"initial", viz::to_text(p.initial)}};
  object["default"] = initial(lesson, p);
  if (!p.choices.empty())
    object["choices"] = p.choices;
  else
    object.update({{"from", p.lo}, {"to", p.hi}});
  if (!p.where.empty()) object["where"] = p.where;
  if (const viz::Condition* c = condition_of(lesson, p)) object["condition"] = c->allowed;
  return object;
}

Json json(const viz::Lesson& lesson, bool with_steps) {
  Json object = {{"id", lesson.id},           {"title", lesson.title}, {"rows", lesson.rows},
                 {"summary", lesson.summary}, {"after", lesson.after}, {"ideas", lesson.ideas}};
  object["parameters"] = Json::array();
  for (const viz::Parameter& p : lesson.parameters) object["parameters"].push_back(json(lesson, p));
  object["presets"] = Json::array();
  for (const viz::Preset& p : lesson.presets) {
    Json preset = {{"id", p.id}, {"title", p.title}};
    if (!p.group.empty()) preset["group"] = p.group;
    if (with_steps) preset["steps"] = lesson.walk(p.parameters).steps.size();
    object["presets"].push_back(preset);
  }
  return object;
}

int list_all(const std::vector<const viz::Lesson*>& lessons, bool as_json) {
  Json all = Json::array();
  if (as_json)
    for (const viz::Lesson* lesson : lessons) all.push_back(json(*lesson, false));
  print(as_json ? all.dump(2) + "\n" : text(lessons));
  return done;
}

int list_one(const viz::Lesson& lesson, bool as_json) {
  print(as_json ? json(lesson, true).dump(2) + "\n" : text(lesson));
  return done;
}

/// Returns the ids of further lessons that have the idea.
std::vector<std::string> also_in(const lessons::Term& term) {
  std::vector<std::string> ids;
  for (const viz::Lesson* lesson : lessons::all_lessons())
    if (lesson->id != term.lesson && std::ranges::count(lesson->ideas, term.name) > 0) ids.push_back(lesson->id);
  return ids;
}

std::string told(const std::string& name, const std::string& meaning, const std::string& where) {
  return inked(Ink::bold, name) + "\n" + wrapped(fmt::format("{} ({})", viz::plain(meaning), where), line_width, 2);
}

int list_terms(bool as_json) {
  Json all = Json::array();
  std::string out;
  for (const lessons::Term& t : lessons::glossary()) {
    const std::vector<std::string> also = also_in(t);
    all.push_back({{"term", t.name}, {"meaning", viz::plain(t.meaning)}, {"lesson", t.lesson}, {"also", also}});
    out += told(t.name, t.meaning, t.lesson + (also.empty() ? "" : fmt::format("; also {}", fmt::join(also, ", "))));
  }
  for (const lessons::Letter& l : lessons::letters()) {
    all.push_back({{"term", l.name}, {"meaning", viz::plain(l.meaning)}, {"lesson", l.lesson}});
    out += told(l.name, l.meaning, l.lesson);
  }
  print(as_json ? all.dump(2) + "\n" : out);
  return done;
}

}  // namespace

void add_list(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand(
      "list", "the lessons in the order of the course, and their presets;\nof one: parameters and steps");
  const auto lesson = std::make_shared<std::string>();
  const auto as_json = std::make_shared<bool>(false);
  if (!program.only)
    sub.add_option("LESSON", *lesson,
                   "tell of this one its parameters (range, unit, default,\nchoices) and how many steps each "
                   "preset has")
        ->type_name("");
  const auto terms = std::make_shared<bool>(false);
  sub.add_flag("--glossary", *terms, "the terms of the course instead, each with its lesson");
  sub.add_flag("--json", *as_json, "for programs: also parameters; of one lesson also the steps");
  sub.footer(program.only ? "Example: " + program.name + " list --json"
                          : "Examples: isect list\n          isect list ray-sphere");
  sub.callback([&program, lesson, as_json, terms] {
    program.chosen = [&program, lesson, as_json, terms] {
      if (*terms) return list_terms(*as_json);
      if (program.only) return list_one(*program.only, *as_json);
      if (lesson->empty()) return list_all(program.lessons, *as_json);
      if (std::error_code absent; std::filesystem::is_regular_file(*lesson, absent))
        throw viz::BadInput(
            fmt::format("lesson: \"{0}\" is a file; {1} explain {0} tells what it holds", *lesson, program.name));
      return list_one(viz::lesson_named(program.lessons, *lesson), *as_json);
    };
  });
}

}  // namespace isect::program
