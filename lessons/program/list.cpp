// isect list: what there is to see.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "lessons/program/program.h"
#include "lessons/program/terminal.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

std::size_t most_steps(const viz::Lesson& lesson) {
  std::size_t most = 0;
  for (const viz::Preset& p : lesson.presets) most = std::max(most, lesson.walk(p.parameters).steps.size());
  return most;
}

/// The presets' names, one line a group.
std::string preset_lines(const viz::Lesson& lesson) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const viz::Preset& p : lesson.presets) {
    if (groups.empty() || groups.back().first != p.group) groups.emplace_back(p.group, "presets:");
    groups.back().second += " " + p.id;
  }
  std::string lines;
  for (const auto& group : groups) lines += wrapped(group.second, 80, 2);
  return lines;
}

std::string text(const std::vector<const viz::Lesson*>& lessons) {
  std::string out;
  for (const viz::Lesson* lesson : lessons) {
    out += fmt::format("{}  {} ({}), up to {} steps, {} presets\n", inked(Ink::bold, lesson->id),
                       lesson->title, lesson->rows, most_steps(*lesson), lesson->presets.size());
    out += wrapped(lesson->summary, 80, 2) + preset_lines(*lesson);
  }
  return out;
}

Json json(const viz::Parameter& p) {
  Json object = {{"name", p.name}, {"help", p.help}, {"initial", viz::to_text(p.initial)}};
  if (!p.choices.empty())
    object["choices"] = p.choices;
  else
    object.update({{"from", p.lo}, {"to", p.hi}});
  return object;
}

Json json(const viz::Lesson& lesson) {
  Json object = {
      {"id", lesson.id}, {"title", lesson.title}, {"rows", lesson.rows}, {"summary", lesson.summary}};
  object["parameters"] = Json::array();
  for (const viz::Parameter& p : lesson.parameters) object["parameters"].push_back(json(p));
  object["presets"] = Json::array();
  for (const viz::Preset& p : lesson.presets) {
    Json preset = {{"id", p.id}, {"title", p.title}};
    if (!p.group.empty()) preset["group"] = p.group;
    preset["steps"] = lesson.walk(p.parameters).steps.size();
    object["presets"].push_back(preset);
  }
  return object;
}

int list(const std::vector<const viz::Lesson*>& lessons, bool as_json) {
  if (as_json) {
    Json all = Json::array();
    for (const viz::Lesson* lesson : lessons) all.push_back(json(*lesson));
    print(all.dump(2) + "\n");
  } else {
    print(text(lessons));
  }
  return done;
}

}  // namespace

void add_list(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("list", "lessons: id, title, note rows, steps, presets");
  const auto as_json = std::make_shared<bool>(false);
  sub.add_flag("--json", *as_json, "for programs: also parameters and the steps of each preset");
  sub.footer("Example: isect list --json");
  sub.callback([&program, as_json] {
    program.chosen = [&program, as_json] { return list(program.lessons, *as_json); };
  });
}

}  // namespace isect::program
